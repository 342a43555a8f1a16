// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/field_writer.h"
#include "studies/quantity.h"
#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace ballonet::studies
{
namespace
{

std::string escaped(char c)
{
  if (c == '"' || c == '\\')
    return {'\\', c};
  if (static_cast<unsigned char>(c) >= 0x20 && c != 0x7f)
    return {c};
  char code[8];
  std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(static_cast<unsigned char>(c)));
  return code;
}

bool is_bare_key(const std::string &name)
{
  return !name.empty() &&
         std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
}

bool is_number(const std::string &text)
{
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

} // namespace

std::string FieldWriter::toml_text(const std::string &text)
{
  std::string result = "\"";
  for (const char c : text)
    result += escaped(c);
  return result + "\"";
}

std::string FieldWriter::toml_key(const std::string &name) { return is_bare_key(name) ? name : toml_text(name); }

std::string FieldWriter::toml_quantity(double value, const std::string &unit)
{
  if (std::isinf(value))
    return "\"unlimited\"";
  const std::string text = format_quantity(value, unit);
  return unit == "1" ? text : "\"" + text + "\"";
}

std::string FieldWriter::toml_setting(const std::string &text) { return is_number(text) ? text : toml_text(text); }

void FieldWriter::list(const std::string &key, const std::vector<std::string> &values)
{
  std::string text;
  for (const std::string &value : values)
    text += (text.empty() ? "" : ", ") + value;
  line(key, "[" + text + "]");
}

void FieldWriter::quantities(const std::string &key, const std::vector<double> &member, const std::string &unit, double,
                             double, const std::string &)
{
  std::vector<std::string> values;
  for (const double value : member)
    values.push_back(toml_quantity(value, unit));
  list(key, values);
}

void FieldWriter::names(const std::string &key, const std::vector<std::string> &member, const std::string &)
{
  std::vector<std::string> values;
  for (const std::string &name : member)
    values.push_back(toml_text(name));
  list(key, values);
}

void FieldWriter::setting(const std::string &key, const std::string &member, const std::string &)
{
  member.empty() ? not_set(key) : line(key, toml_setting(member));
}

void FieldWriter::settings(const std::string &key, const std::vector<std::string> &member, const std::string &)
{
  std::vector<std::string> values;
  for (const std::string &text : member)
    values.push_back(toml_setting(text));
  list(key, values);
}

void FieldWriter::vector(const std::string &key, const std::array<std::optional<double>, 3> &member,
                         const std::string &unit, const std::string &)
{
  std::string text;
  for (std::size_t i = 0; i < 3; ++i)
    if (member[i])
      text += (text.empty() ? "" : ", ") + std::string(1, "xyz"[i]) + " = " + toml_quantity(*member[i], unit);
  line(key, text.empty() ? "{}" : "{" + text + "}");
}

} // namespace ballonet::studies
