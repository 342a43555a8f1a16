// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/toml_document.h"
#include <algorithm>
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

/// The visitor of field lists that fills a parameter struct from a TOML table. Keys that are absent leave their member
/// alone; wrong types, units, ranges and unknown keys throw InputError.
class FieldReader
{
public:
  /// `prefix`: path of `table` in the document with a final ".", empty for the root.
  FieldReader(const TomlDocument &document, const toml::table &table, std::string prefix = {});

  template <class Member>
  void quantity(const std::string &key, Member &member, const std::string &unit, double min, double max,
                const std::string &)
  {
    if (const toml::node *node = find(key))
      member = number(*node, key, {unit, min, max, is_unlimited(member)});
  }

  void quantities(const std::string &key, std::vector<double> &member, const std::string &unit, double min, double max,
                  const std::string &);

  template <class Member>
  void count(const std::string &key, Member &member, int min, int max, const std::string &)
  {
    if (const toml::node *node = find(key))
      member = integer(*node, key, min, max);
  }

  void flag(const std::string &key, bool &member, const std::string &);
  void text(const std::string &key, std::string &member, const std::string &);
  void names(const std::string &key, std::vector<std::string> &member, const std::string &);
  void words(const std::string &key, std::vector<std::string> &member, const std::vector<std::string> &allowed,
             const std::string &);

  /// The value of another key, written as it is there: a number or a text with unit.
  void setting(const std::string &key, std::string &member, const std::string &);
  void settings(const std::string &key, std::vector<std::string> &member, const std::string &);

  template <class Enum>
  void choice(const std::string &key, Enum &member,
              std::initializer_list<std::pair<const char *, std::type_identity_t<Enum>>> words, const std::string &)
  {
    const toml::node *node = find(key);
    if (!node)
      return;
    std::vector<std::string> allowed;
    for (const auto &[word, value] : words)
      allowed.emplace_back(word);
    member = words.begin()[word_index(*node, key, allowed)].second;
  }

  template <class Member>
  void point(const std::string &key, Member &member, const std::string &unit, const std::string &)
  {
    if (const toml::node *node = find(key))
      member = three_numbers(*node, key, unit);
  }

  void vector(const std::string &key, std::array<std::optional<double>, 3> &member, const std::string &unit,
              const std::string &);

  template <class Group>
  void group(const std::string &key, Group &member, const std::string &)
  {
    if (const toml::node *node = find(key))
      read_group(as_table(*node, key), key, member);
  }

  /// A table that may be missing.
  template <class Group>
  void group(const std::string &key, std::optional<Group> &member, const std::string &)
  {
    if (const toml::node *node = find(key))
      read_group(as_table(*node, key), key, member.emplace());
  }

  template <class Group>
  void group_list(const std::string &key, std::vector<Group> &member, const std::string &)
  {
    const toml::node *node = find(key);
    if (!node)
      return;
    member.clear();
    const toml::array &list = as_array(*node, key, "a list of tables [[" + key + "]]");
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::string path = key + "[" + std::to_string(i) + "]";
      read_group(as_table(*list.get(i), path), path, member.emplace_back());
    }
  }

  /// Tables [key.NAME]: each fills the element of that name, which is added if there is none.
  template <class Group>
  void named_groups(const std::string &key, std::vector<Group> &member, const std::string &)
  {
    const toml::node *node = find(key);
    if (!node)
      return;
    for (const auto &[name_key, child] : as_table(*node, key)) {
      const std::string name(name_key.str());
      auto element = std::find_if(member.begin(), member.end(), [&](const Group &g) { return g.name == name; });
      if (element == member.end()) {
        element = member.emplace(member.end());
        element->name = name;
      }
      read_group(as_table(child, key + "." + name), key + "." + name, *element);
    }
  }

  /// Throws InputError for the first key of the table that no field asked for.
  void finish() const;

private:
  struct Range {
    std::string unit;
    double min, max;
    bool unlimited; ///< the word "unlimited" is a value
  };

  template <class Member>
  static bool is_unlimited(const Member &member)
  {
    if constexpr (std::is_same_v<Member, double>)
      return std::isinf(member);
    else
      return false;
  }

  template <class Group>
  void read_group(const toml::table &table, const std::string &key, Group &member)
  {
    FieldReader reader(document_, table, prefix_ + key + ".");
    Group::fields(member, reader);
    reader.finish();
  }

  /// The node at `key` or null; remembers the key as known.
  const toml::node *find(const std::string &key);
  double number(const toml::node &node, const std::string &key, const Range &range) const;
  int integer(const toml::node &node, const std::string &key, int min, int max) const;
  std::string string(const toml::node &node, const std::string &key) const;
  std::size_t word_index(const toml::node &node, const std::string &key, const std::vector<std::string> &allowed) const;
  std::array<double, 3> three_numbers(const toml::node &node, const std::string &key, const std::string &unit) const;
  const toml::table &as_table(const toml::node &node, const std::string &key) const;
  const toml::array &as_array(const toml::node &node, const std::string &key, const std::string &allowed) const;
  InputError error(const toml::node &node, const std::string &key, const std::string &allowed,
                   const std::string &hint = {}) const;

  const TomlDocument &document_;
  const toml::table &table_;
  std::string prefix_;
  std::vector<std::string> known_;
};

/// Fills `target` from the whole document.
template <class Group>
void read_fields(const TomlDocument &document, Group &target)
{
  FieldReader reader(document, document.root());
  Group::fields(target, reader);
  reader.finish();
}

} // namespace ballonet::studies
