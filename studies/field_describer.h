// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/field_range.h"
#include "studies/quantity.h"
#include <array>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ballonet::studies
{

/// What `describe` says about one key.
struct KeyDescription {
  std::string key;           ///< "actuator.ribs.gap", "material.X.c10", "body[].name"
  std::string type;          ///< "quantity", "whole number", "true | false", "a | b", ...
  std::string unit;          ///< "1" for plain numbers, empty where there is none
  std::string range;         ///< empty where there is none
  std::string default_value; ///< "not set" where there is none
  std::string help;
};

/// The visitor of field lists that describes every key. Lists and named tables are described by one blank element
/// (`schema`) or by each element that is there (`actual`, to look up the unit of a key of a given study).
class FieldDescriber
{
public:
  enum class Mode { schema, actual };

  explicit FieldDescriber(Mode mode, std::string prefix = {}) : mode_(mode), prefix_(std::move(prefix)) {}

  template <class Member>
  void quantity(const std::string &key, const Member &member, const std::string &unit, double min, double max,
                const std::string &help)
  {
    const std::optional<double> value = member;
    add(key, unit == "1" ? "number" : "quantity", unit, range_text(min, max, unit),
        value ? quantity_text(*value, unit) : "not set", help);
  }

  void quantities(const std::string &key, const std::vector<double> &member, const std::string &unit, double min,
                  double max, const std::string &help);

  template <class Member>
  void count(const std::string &key, const Member &member, int min, int max, const std::string &help)
  {
    const std::optional<int> value = member;
    add(key, "whole number", "1", range_text(min, max, "1"), value ? std::to_string(*value) : "not set", help);
  }

  void flag(const std::string &key, bool member, const std::string &help)
  {
    add(key, "true | false", "", "", member ? "true" : "false", help);
  }
  void text(const std::string &key, const std::string &member, const std::string &help)
  {
    add(key, "text", "", "", member.empty() ? "not set" : "\"" + member + "\"", help);
  }
  void names(const std::string &key, const std::vector<std::string> &member, const std::string &help)
  {
    add(key, "list of texts", "", "", joined(member, ", "), help);
  }
  void words(const std::string &key, const std::vector<std::string> &member, const std::vector<std::string> &allowed,
             const std::string &help)
  {
    add(key, "list of words", "", joined(allowed, " | "), joined(member, ", "), help);
  }
  void setting(const std::string &key, const std::string &member, const std::string &help)
  {
    add(key, "value of the key it is about", "", "", member.empty() ? "not set" : member, help);
  }
  void settings(const std::string &key, const std::vector<std::string> &member, const std::string &help)
  {
    add(key, "list of values of the key it is about", "", "", joined(member, ", "), help);
  }

  template <class Enum>
  void choice(const std::string &key, const Enum &member,
              std::initializer_list<std::pair<const char *, std::type_identity_t<Enum>>> words, const std::string &help)
  {
    std::string allowed, value;
    for (const auto &[word, meaning] : words) {
      allowed += (allowed.empty() ? "" : " | ") + std::string(word);
      if (meaning == member)
        value = word;
    }
    add(key, "word", "", allowed, value, help);
  }

  template <class Member>
  void point(const std::string &key, const Member &member, const std::string &unit, const std::string &help)
  {
    const std::optional<std::array<double, 3>> value = member;
    add(key, "list of three quantities", unit, "",
        value ? list_text({value->begin(), value->end()}, unit) : std::string("not set"), help);
  }

  void vector(const std::string &key, const std::array<std::optional<double>, 3> &, const std::string &unit,
              const std::string &help)
  {
    for (const char *axis : {"x", "y", "z"})
      add(key + "." + axis, "quantity", unit, "any", "not set", help);
  }

  template <class Group>
  void group(const std::string &key, const Group &member, const std::string &)
  {
    descend(key, member);
  }

  template <class Group>
  void group(const std::string &key, const std::optional<Group> &member, const std::string &)
  {
    if (member || mode_ == Mode::schema)
      descend(key, member.value_or(Group{}));
  }

  template <class Group>
  void group_list(const std::string &key, const std::vector<Group> &member, const std::string &)
  {
    if (mode_ == Mode::schema)
      return descend(key + "[]", Group{});
    for (std::size_t i = 0; i < member.size(); ++i)
      descend(key + "[" + std::to_string(i) + "]", member[i]);
  }

  template <class Group>
  void named_groups(const std::string &key, const std::vector<Group> &member, const std::string &)
  {
    if (mode_ == Mode::schema)
      return descend(key + ".X", Group{});
    for (const Group &element : member)
      descend(key + "." + element.name, element);
  }

  const std::vector<KeyDescription> &rows() const { return rows_; }

private:
  template <class Group>
  void descend(const std::string &key, const Group &member)
  {
    FieldDescriber describer(mode_, prefix_ + key + ".");
    Group::fields(member, describer);
    rows_.insert(rows_.end(), describer.rows_.begin(), describer.rows_.end());
  }

  static std::string joined(const std::vector<std::string> &words, const std::string &separator);
  static std::string quantity_text(double value, const std::string &unit);
  static std::string list_text(const std::vector<double> &values, const std::string &unit);
  void add(const std::string &key, std::string type, std::string unit, std::string range, std::string default_value,
           std::string help)
  {
    rows_.push_back(
        {prefix_ + key, std::move(type), std::move(unit), std::move(range), std::move(default_value), std::move(help)});
  }

  Mode mode_;
  std::string prefix_;
  std::vector<KeyDescription> rows_;
};

} // namespace ballonet::studies
