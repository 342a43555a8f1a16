// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <initializer_list>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace ballonet::studies
{

/// The visitor of field lists that writes a parameter struct as TOML: every key with its value in the internal unit and
/// so many digits that reading gives the same bits. What is not set appears as a comment.
class FieldWriter
{
public:
  /// `prefix`: path of the written table with a final ".", empty for the root.
  explicit FieldWriter(std::string prefix = {}) : prefix_(std::move(prefix)) {}

  template <class Member>
  void quantity(const std::string &key, const Member &member, const std::string &unit, double, double,
                const std::string &)
  {
    const std::optional<double> value = member;
    value ? line(key, toml_quantity(*value, unit)) : not_set(key);
  }

  void quantities(const std::string &key, const std::vector<double> &member, const std::string &unit, double, double,
                  const std::string &);

  template <class Member>
  void count(const std::string &key, const Member &member, int, int, const std::string &)
  {
    const std::optional<int> value = member;
    value ? line(key, std::to_string(*value)) : not_set(key);
  }

  void flag(const std::string &key, bool member, const std::string &) { line(key, member ? "true" : "false"); }
  void text(const std::string &key, const std::string &member, const std::string &) { line(key, toml_text(member)); }
  void names(const std::string &key, const std::vector<std::string> &member, const std::string &);
  void words(const std::string &key, const std::vector<std::string> &member, const std::vector<std::string> &,
             const std::string &help)
  {
    names(key, member, help);
  }
  void setting(const std::string &key, const std::string &member, const std::string &);
  void settings(const std::string &key, const std::vector<std::string> &member, const std::string &);

  template <class Enum>
  void choice(const std::string &key, const Enum &member,
              std::initializer_list<std::pair<const char *, std::type_identity_t<Enum>>> words, const std::string &)
  {
    for (const auto &[word, value] : words)
      if (value == member)
        return line(key, toml_text(word));
  }

  template <class Member>
  void point(const std::string &key, const Member &member, const std::string &unit, const std::string &)
  {
    const std::optional<std::array<double, 3>> value = member;
    value ? quantities(key, {value->begin(), value->end()}, unit, 0, 0, {}) : not_set(key);
  }

  void vector(const std::string &key, const std::array<std::optional<double>, 3> &member, const std::string &unit,
              const std::string &);

  template <class Group>
  void group(const std::string &key, const Group &member, const std::string &)
  {
    write_group("[" + prefix_ + key + "]", prefix_ + key + ".", member);
  }

  template <class Group>
  void group(const std::string &key, const std::optional<Group> &member, const std::string &help)
  {
    if (member)
      group(key, *member, help);
  }

  template <class Group>
  void group_list(const std::string &key, const std::vector<Group> &member, const std::string &)
  {
    for (const Group &element : member)
      write_group("[[" + prefix_ + key + "]]", prefix_ + key + ".", element);
  }

  template <class Group>
  void named_groups(const std::string &key, const std::vector<Group> &member, const std::string &)
  {
    for (const Group &element : member) {
      const std::string path = prefix_ + key + "." + toml_key(element.name);
      write_group("[" + path + "]", path + ".", element);
    }
  }

  /// The TOML text of everything visited: plain keys first, then the tables.
  std::string str() const { return lines_ + tables_; }

private:
  static std::string toml_text(const std::string &text);
  static std::string toml_key(const std::string &name);
  static std::string toml_quantity(double value, const std::string &unit);
  static std::string toml_setting(const std::string &text);

  template <class Group>
  void write_group(const std::string &header, const std::string &prefix, const Group &member)
  {
    FieldWriter writer(prefix);
    Group::fields(member, writer);
    tables_ += "\n" + header + "\n" + writer.str();
  }

  void line(const std::string &key, const std::string &value) { lines_ += key + " = " + value + "\n"; }
  void not_set(const std::string &key) { lines_ += "# " + key + " is not set\n"; }
  void list(const std::string &key, const std::vector<std::string> &values);

  std::string prefix_, lines_, tables_;
};

/// The whole of `source` as TOML.
template <class Group>
std::string write_fields(const Group &source)
{
  FieldWriter writer;
  Group::fields(source, writer);
  return writer.str();
}

} // namespace ballonet::studies
