// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/field_reader.h"
#include "studies/field_range.h"
#include "studies/quantity.h"

namespace ballonet::studies
{

FieldReader::FieldReader(const TomlDocument &document, const toml::table &table, std::string prefix)
    : document_(document), table_(table), prefix_(std::move(prefix))
{
}

const toml::node *FieldReader::find(const std::string &key)
{
  if (std::find(known_.begin(), known_.end(), key) == known_.end())
    known_.push_back(key);
  return table_.get(key);
}

InputError FieldReader::error(const toml::node &node, const std::string &key, const std::string &allowed,
                              const std::string &hint) const
{
  return InputError(document_.place(node), prefix_ + key, given_text(node), allowed, hint);
}

double FieldReader::number(const toml::node &node, const std::string &key, const Range &range) const
{
  const auto text = node.value_exact<std::string>();
  if (range.unlimited && text == "unlimited")
    return INFINITY;
  const std::string allowed = range_text(range.min, range.max, range.unit) + (range.unlimited ? " or unlimited" : "");
  double value = 0;
  if (text && range.unit != "1") {
    try {
      value = parse_quantity(*text, range.unit);
    } catch (const QuantityError &e) {
      throw error(node, key, e.what(), "range: " + allowed);
    }
  } else if (!node.is_number() || range.unit != "1")
    throw error(node, key,
                range.unit == "1" ? "a plain number"
                                  : "a text with a unit, such as \"1.5 " + range.unit + "\"" +
                                        (node.is_number() ? "; the unit is missing" : ""),
                "range: " + allowed);
  else
    value = *node.value<double>();
  if (!(value >= range.min && value <= range.max) || !std::isfinite(value))
    throw error(node, key, allowed);
  return value;
}

int FieldReader::integer(const toml::node &node, const std::string &key, int min, int max) const
{
  const auto value = node.value_exact<std::int64_t>();
  if (!value || *value < min || *value > max)
    throw error(node, key, "a whole number, " + range_text(min, max, "1"));
  return static_cast<int>(*value);
}

std::string FieldReader::string(const toml::node &node, const std::string &key) const
{
  const auto value = node.value_exact<std::string>();
  if (!value)
    throw error(node, key, "a text in quotes");
  return *value;
}

void FieldReader::quantities(const std::string &key, std::vector<double> &member, const std::string &unit, double min,
                             double max, const std::string &)
{
  const toml::node *node = find(key);
  if (!node)
    return;
  member.clear();
  const Range range{unit, min, max, false};
  if (const toml::array *list = node->as_array())
    for (std::size_t i = 0; i < list->size(); ++i)
      member.push_back(number(*list->get(i), key + "[" + std::to_string(i) + "]", range));
  else
    member.push_back(number(*node, key, range));
}

void FieldReader::flag(const std::string &key, bool &member, const std::string &)
{
  const toml::node *node = find(key);
  if (node && !node->is_boolean())
    throw error(*node, key, "true or false");
  if (node)
    member = *node->value<bool>();
}

void FieldReader::text(const std::string &key, std::string &member, const std::string &)
{
  if (const toml::node *node = find(key))
    member = string(*node, key);
}

void FieldReader::names(const std::string &key, std::vector<std::string> &member, const std::string &)
{
  const toml::node *node = find(key);
  if (!node)
    return;
  member.clear();
  if (const toml::array *list = node->as_array())
    for (std::size_t i = 0; i < list->size(); ++i)
      member.push_back(string(*list->get(i), key + "[" + std::to_string(i) + "]"));
  else
    member.push_back(string(*node, key));
}

void FieldReader::words(const std::string &key, std::vector<std::string> &member,
                        const std::vector<std::string> &allowed, const std::string &help)
{
  names(key, member, help);
  const toml::node *node = table_.get(key);
  if (!node)
    return;
  for (const std::string &word : member)
    if (std::find(allowed.begin(), allowed.end(), word) == allowed.end())
      throw error(*node, key, "a list of words", nearest_hint(word, allowed));
}

void FieldReader::setting(const std::string &key, std::string &member, const std::string &)
{
  const toml::node *node = find(key);
  if (!node)
    return;
  if (!node->is_number() && !node->is_string())
    throw error(*node, key, "a number, or a text with a unit");
  member = node->is_string() ? **node->as_string() : given_text(*node);
}

void FieldReader::settings(const std::string &key, std::vector<std::string> &member, const std::string &)
{
  const toml::node *node = find(key);
  if (!node)
    return;
  member.clear();
  for (const toml::node &element : as_array(*node, key, "a list of numbers, or of texts with a unit")) {
    if (!element.is_number() && !element.is_string())
      throw error(element, key, "a number, or a text with a unit");
    member.push_back(element.is_string() ? **element.as_string() : given_text(element));
  }
}

std::size_t FieldReader::word_index(const toml::node &node, const std::string &key,
                                    const std::vector<std::string> &allowed) const
{
  const std::string word = string(node, key);
  const auto found = std::find(allowed.begin(), allowed.end(), word);
  if (found == allowed.end()) {
    std::string list;
    for (const auto &a : allowed)
      list += (list.empty() ? "" : " | ") + a;
    const std::string hint = nearest_hint(word, allowed);
    throw error(node, key, list, hint.starts_with("nearest") ? hint : "");
  }
  return static_cast<std::size_t>(found - allowed.begin());
}

std::array<double, 3> FieldReader::three_numbers(const toml::node &node, const std::string &key,
                                                 const std::string &unit) const
{
  const toml::array *list = node.as_array();
  if (!list || list->size() != 3)
    throw error(node, key, "a list of three values in " + (unit == "1" ? "plain numbers" : unit));
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i)
    values[i] = number(*list->get(i), key + "[" + std::to_string(i) + "]", {unit, -INFINITY, INFINITY, false});
  return values;
}

void FieldReader::vector(const std::string &key, std::array<std::optional<double>, 3> &member, const std::string &unit,
                         const std::string &)
{
  const toml::node *node = find(key);
  if (!node)
    return;
  FieldReader reader(document_, as_table(*node, key), prefix_ + key + ".");
  for (std::size_t i = 0; i < 3; ++i)
    reader.quantity(std::string(1, "xyz"[i]), member[i], unit, -INFINITY, INFINITY, "");
  reader.finish();
}

const toml::table &FieldReader::as_table(const toml::node &node, const std::string &key) const
{
  if (!node.is_table())
    throw error(node, key, "a table [" + prefix_ + key + "]");
  return *node.as_table();
}

const toml::array &FieldReader::as_array(const toml::node &node, const std::string &key,
                                         const std::string &allowed) const
{
  if (!node.is_array())
    throw error(node, key, allowed);
  return *node.as_array();
}

void FieldReader::finish() const
{
  const toml::node *first = nullptr;
  std::string unknown;
  for (const auto &[key, node] : table_) {
    const std::string name(key.str());
    if (std::find(known_.begin(), known_.end(), name) != known_.end())
      continue;
    if (!first || node.source().begin.line < first->source().begin.line) {
      first = &node;
      unknown = name;
    }
  }
  if (first)
    throw InputError(document_.place(*first), prefix_ + unknown, "an unknown key", "a key of `ballonet describe`",
                     nearest_hint(unknown, known_));
}

} // namespace ballonet::studies
