// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/results_directory.h"
#include "studies/atomic_file.h"
#include "studies/field_writer.h"
#include "studies/version.h"
#include <algorithm>
#include <cstdio>

namespace ballonet::studies
{
namespace
{

namespace fs = std::filesystem;

/// The block [run] of resolved.toml: how it was run; no input.
struct RunInformation {
  std::string version = version_text(), commit = commit_text();
  int ranks = 1;

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.text("version", self.version, "release");
    v.text("commit", self.commit, "commit it was built from");
    v.count("ranks", self.ranks, 1, 1 << 30, "MPI ranks");
  }
};

std::vector<std::pair<std::string, std::string>> variable_keys(const StudyFile &study)
{
  std::vector<std::pair<std::string, std::string>> keys;
  for (std::size_t i = 0; i < study.space().size(); ++i)
    keys.emplace_back(study.space().variable(i).key, study.space().variable(i).unit);
  return keys;
}

/// Empty, or left by a run that was killed before it had written its first file.
bool is_fresh(const fs::path &path)
{
  return std::all_of(fs::directory_iterator(path), fs::directory_iterator(),
                     [](const fs::directory_entry &entry) { return entry.path().filename() == "resolved.toml.new"; });
}

} // namespace

void ResultsDirectory::check(const fs::path &path, const StudyFile &study, bool resume)
{
  const InputError occupied({path.string()}, "", "a directory that is not empty", "a new or empty directory",
                            "--resume goes on with the run in it");
  if (!fs::exists(path))
    return;
  if (!fs::is_directory(path))
    throw InputError({path.string()}, "", "a file", "a directory");
  if (is_fresh(path))
    return;
  if (!resume)
    throw occupied;
  if (!fs::exists(path / "resolved.toml"))
    throw InputError({path.string()}, "", "a directory without resolved.toml", "a results directory to resume");
  if (variable_keys(StudyFile::open((path / "resolved.toml").string())) != variable_keys(study))
    throw InputError({(path / "resolved.toml").string()}, "variable", "results of a study with other variables",
                     "the same variables, or another directory");
}

ResultsDirectory::ResultsDirectory(fs::path path, const StudyFile &study, int ranks) : path_(std::move(path))
{
  fs::create_directories(path_);
  RunInformation run;
  run.ranks = ranks;
  write_atomically(path_ / "resolved.toml", resolved_text(study.study()) + "\n[run]\n" + write_fields(run));
  fs::create_directories(path_ / "evaluations");
  find_begun();
}

fs::path ResultsDirectory::folder(int number) const
{
  char name[16];
  std::snprintf(name, sizeof name, "%04d", number);
  return path_ / "evaluations" / name;
}

void ResultsDirectory::find_begun()
{
  for (const auto &entry : fs::directory_iterator(path_ / "evaluations")) {
    const std::string name = entry.path().filename().string();
    if (name.empty() || name.size() > 9 ||
        !std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c); }))
      continue;
    const int number = std::stoi(name);
    next_ = std::max(next_, number + 1);
    if (fs::exists(entry.path() / "hash"))
      numbers_[read_text_file((entry.path() / "hash").string())] = number;
  }
}

int ResultsDirectory::number_of(const std::string &hash)
{
  const auto [entry, is_new] = numbers_.try_emplace(hash, next_);
  next_ += is_new;
  return entry->second;
}

void ResultsDirectory::begin(int number, const std::string &hash, const Study &study) const
{
  fs::create_directories(folder(number));
  write_atomically(folder(number) / "study.toml", resolved_text(study));
  write_atomically(folder(number) / "hash", hash);
}

} // namespace ballonet::studies
