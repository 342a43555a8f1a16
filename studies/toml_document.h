// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/input_error.h"
#include <string>
#include <toml++/toml.h>
#include <vector>

namespace ballonet::studies
{

/// One `--set key=value`: `value` is TOML, or a bare text such as 7.2 mm.
struct Override {
  std::string key, value;
};

/// Splits "path.to.key=value"; throws InputError when there is no "=" or no key.
Override parse_override(const std::string &text);

/// A parsed study file with its overrides applied. Every node knows where it came from.
class TomlDocument
{
public:
  /// `file` is the name shown in messages. Throws InputError for an empty, binary or malformed text and for an override
  /// whose key has no place in the document.
  TomlDocument(std::string file, const std::string &text, const std::vector<Override> &overrides = {});

  const toml::table &root() const { return root_; }
  const std::string &file() const { return file_; }

  /// Drops a top-level key that is for others than the reader.
  void remove(const std::string &key) { root_.erase(key); }

  Place place(const toml::node &node) const;

  /// Place of the node at `key` ("actuator.ribs.gap", "body[0].name"), else of its nearest existing parent.
  Place place(std::string key) const;

  /// An error about `key`, placed where that key stands.
  InputError error(const std::string &key, const std::string &given, const std::string &allowed,
                   const std::string &hint = {}) const;

private:
  std::string file_;
  toml::table root_;
};

/// The text of a file; throws InputError when it cannot be read.
std::string read_text_file(const std::string &file);

/// A value as it stands in the file, shortened to one line.
std::string given_text(const toml::node &node);

} // namespace ballonet::studies
