// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/toml_document.h"
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace ballonet::studies
{
namespace
{

const std::string a_study = "a study in TOML, see `ballonet describe`";

toml::table parse(const std::string &text, const std::string &file)
{
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    throw InputError({file}, "", "an empty file", a_study);
  if (text.find('\0') != std::string::npos)
    throw InputError({file}, "", "binary data", a_study);
  try {
    return toml::parse(text, file);
  } catch (const toml::parse_error &e) {
    throw InputError({file, e.source().begin.line}, "", "a text that is not TOML", a_study,
                     std::string(e.description()));
  }
}

/// "a.b[2].c" as {"a", "b", "[2]", "c"}.
std::vector<std::string> split_key(const std::string &key)
{
  std::vector<std::string> parts(1);
  for (const char c : key)
    if (c == '.')
      parts.emplace_back();
    else if (c == '[')
      parts.emplace_back("[");
    else
      parts.back() += c;
  return parts;
}

/// The element `part` = "[2]" of an array; null when there is none.
toml::node *element(toml::node &node, const std::string &part)
{
  toml::array *array = node.as_array();
  const std::string digits = part.substr(1, part.size() - 2);
  const bool number = part.ends_with(']') && !digits.empty() && digits.size() < 9 &&
                      std::all_of(digits.begin(), digits.end(), [](unsigned char c) { return std::isdigit(c); });
  return array && number ? array->get(std::stoul(digits)) : nullptr;
}

/// The value of an override: TOML if it is that, else a string.
toml::table parse_value(const Override &override_)
{
  const std::string place = "--set " + override_.key + "=" + override_.value;
  try {
    return toml::parse("value = " + override_.value, place);
  } catch (const toml::parse_error &) {
  }
  std::string quoted;
  for (const char c : override_.value)
    quoted += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  try {
    return toml::parse("value = \"" + quoted + "\"", place);
  } catch (const toml::parse_error &) {
    throw InputError({"--set"}, override_.key, "\"" + override_.value + "\"", "a TOML value or a text such as 7.2 mm");
  }
}

void set(toml::table &root, const Override &override_)
{
  const std::vector<std::string> parts = split_key(override_.key);
  const InputError misplaced({"--set"}, override_.key, "a key that has no place in the study file",
                             "path.to.key=value; list elements as list[0]");
  toml::node *node = &root;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    const bool is_element = parts[i].starts_with('[');
    if (toml::table *table = node->as_table(); table && !is_element && !table->contains(parts[i]))
      table->insert(parts[i], toml::table{});
    node = is_element ? element(*node, parts[i]) : node->is_table() ? node->as_table()->get(parts[i]) : nullptr;
    if (!node)
      throw misplaced;
  }
  toml::table value = parse_value(override_);
  if (parts.back().starts_with('[')) {
    if (!element(*node, parts.back()))
      throw misplaced;
    toml::array &array = *node->as_array();
    const auto position = array.cbegin() + std::stol(parts.back().substr(1));
    array.insert(array.erase(position), std::move(*value.get("value")));
  } else if (node->is_table())
    node->as_table()->insert_or_assign(parts.back(), std::move(*value.get("value")));
  else
    throw misplaced;
}

} // namespace

Override parse_override(const std::string &text)
{
  const auto equals = text.find('=');
  if (equals == std::string::npos || equals == 0)
    throw InputError({"--set"}, "", "\"" + text + "\"", "path.to.key=value");
  return {text.substr(0, equals), text.substr(equals + 1)};
}

TomlDocument::TomlDocument(std::string file, const std::string &text, const std::vector<Override> &overrides)
    : file_(std::move(file)), root_(parse(text, file_))
{
  for (const Override &override_ : overrides)
    set(root_, override_);
}

Place TomlDocument::place(const toml::node &node) const
{
  const toml::source_region &source = node.source();
  if (!source.path || source.begin.line == 0)
    return {file_};
  return {*source.path, source.path->starts_with("--set") ? 0 : source.begin.line};
}

Place TomlDocument::place(std::string key) const
{
  while (!key.empty()) {
    if (const auto node = toml::at_path(root_, key))
      return place(*node.node());
    const auto cut = key.find_last_of(".[");
    key.resize(cut == std::string::npos ? 0 : cut);
  }
  return {file_};
}

InputError TomlDocument::error(const std::string &key, const std::string &given, const std::string &allowed,
                               const std::string &hint) const
{
  return InputError(place(key), key, given, allowed, hint);
}

std::string read_text_file(const std::string &file)
{
  if (std::filesystem::is_directory(file))
    throw InputError({file}, "", "a folder", "a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream)
    throw InputError({file}, "", "a file that does not exist or cannot be read", "a readable file");
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string given_text(const toml::node &node)
{
  std::ostringstream stream;
  node.visit([&](const auto &value) { stream << value; });
  std::string text = stream.str();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.size() > 60 ? text.substr(0, 57) + "..." : text;
}

} // namespace ballonet::studies
