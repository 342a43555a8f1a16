// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

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

struct Outcome {
  int code;
  std::string out, err;
  std::string text() const { return out + err; }
};

/// Runs `ballonet ARGUMENTS` in this process.
Outcome run_program(const std::vector<std::string> &arguments);

/// A study file in a folder, run as often as a test calls it; results in the folder's "results".
struct StudyRun {
  StudyRun(const Folder &folder, const std::string &text);

  /// Exit code of `ballonet run STUDY -o RESULTS MORE`; the output is in `text`.
  int operator()(const std::vector<std::string> &more = {});

  std::vector<nlohmann::json> journal() const;
  nlohmann::json summary() const;

  std::filesystem::path results;
  std::string study, text;
};

/// The bar's study with `more` behind it, and its mesh.
StudyRun bar_run(const Folder &folder, const std::string &more = "");

} // namespace ballonet::tests
