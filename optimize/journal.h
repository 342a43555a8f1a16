// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/evaluation.h"
#include "optimize/line_file.h"
#include <functional>
#include <string>
#include <unordered_map>

namespace ballonet::optimize
{

/// How an evaluation is written as one line of text and read again. Reading gives back every bit of every number that
/// was written; it throws std::invalid_argument if the line is no evaluation.
struct LineFormat {
  std::function<std::string(const Evaluation &)> write;
  std::function<Evaluation(const std::string &)> read;
};

/// The finished evaluations of a study on disk, one line each, found again by hash. Failed evaluations are kept like
/// all others. Survives a kill at any moment: an evaluation is on disk when append() returns, or not in the file.
class Journal
{
public:
  /// Opens or creates the file and reads all evaluations. Throws std::invalid_argument naming the line if one cannot be
  /// read, and as LineFile does.
  Journal(const std::filesystem::path &path, LineFormat format);

  /// The evaluation of a hash, nullptr if there is none.
  const Evaluation *find(const std::string &hash) const;

  /// Adds a finished evaluation. Throws std::logic_error if its hash is empty or known: nothing is computed twice.
  void append(const Evaluation &evaluation);

  std::size_t size() const { return evaluations_.size(); }

  /// Lines found on opening whose hash was already there; the first of them counts.
  std::size_t n_duplicates() const { return n_duplicates_; }

  /// Bytes of an unfinished last line cut off on opening.
  std::size_t torn_bytes() const { return file_.torn_bytes(); }

private:
  LineFile file_;
  LineFormat format_;
  std::unordered_map<std::string, Evaluation> evaluations_;
  std::size_t n_duplicates_ = 0;
};

} // namespace ballonet::optimize
