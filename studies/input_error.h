// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

namespace ballonet::studies
{

/// Where an input came from: a file and line, or the command line ("--set ...", line 0).
struct Place {
  std::string file;
  unsigned line = 0;
};

/// Wrong input of the user (exit code 2). what() is the one message shown.
class InputError : public std::runtime_error
{
public:
  /// `given`: what stands there; `allowed`: what may; `hint`: nearest known key or another help, may be empty.
  InputError(Place place, std::string key, std::string given, std::string allowed, std::string hint = {});

  const Place place;
  const std::string key, given, allowed, hint;
};

/// "nearest known key: X" for the word of `known` with the fewest edits to `word` if it is close, else the list of all.
std::string nearest_hint(const std::string &word, const std::vector<std::string> &known);

/// Insertions, deletions, replacements and swaps of neighbours that turn `a` into `b` (optimal string alignment).
std::size_t edit_distance(const std::string &a, const std::string &b);

} // namespace ballonet::studies
