// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <filesystem>
#include <string>

namespace ballonet::tests
{

/// A folder in the system's temporary directory, empty at first and gone at the end.
class Folder
{
public:
  explicit Folder(const std::string &name);
  ~Folder();
  Folder(const Folder &) = delete;
  Folder &operator=(const Folder &) = delete;

  /// Writes a file and returns its path.
  std::string write(const std::string &name, const std::string &text) const;

  const std::filesystem::path path;
};

/// Writes the mesh of a box of length `length` along x (2 x 1 x 1 cells, 1 mm thick, body "bar", surfaces x0 and x1).
void write_bar(const std::filesystem::path &file, double length);

/// A study of kind mesh about that bar, in "bar.msh": held at x0, pulled at x1 by a dead traction of 10 kPa.
extern const char *const bar_study;

} // namespace ballonet::tests
