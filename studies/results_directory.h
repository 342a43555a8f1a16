// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/study_file.h"
#include <filesystem>
#include <map>
#include <string>

namespace ballonet::studies
{

/// The directory of a run: resolved.toml, journal.jsonl, summary.json, results.h5, report.html and
/// evaluations/NNNN/.
///
/// A directory that holds anything is taken only with `resume`, and then only if it is a results directory with the
/// same variables; other keys may change, because every evaluation is known by the hash of all its inputs.
class ResultsDirectory
{
public:
  /// Throws InputError if the directory cannot be used for this study. Changes nothing on disk.
  static void check(const std::filesystem::path &path, const StudyFile &study, bool resume);

  /// Creates what is missing, writes resolved.toml and looks which evaluations were begun before.
  ResultsDirectory(std::filesystem::path path, const StudyFile &study, int ranks);

  const std::filesystem::path &path() const { return path_; }
  std::filesystem::path journal() const { return path_ / "journal.jsonl"; }

  /// evaluations/NNNN
  std::filesystem::path folder(int number) const;

  /// The number of the evaluation with this hash: that of a folder begun before, else a new one.
  int number_of(const std::string &hash);

  /// Creates the folder of an evaluation, with its hash and its study.
  void begin(int number, const std::string &hash, const Study &study) const;

private:
  void find_begun();

  std::filesystem::path path_;
  std::map<std::string, int> numbers_; // by hash
  int next_ = 1;
};

} // namespace ballonet::studies
