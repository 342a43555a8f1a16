// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/problem.h"
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ballonet::optimize
{

/// How many evaluations of a run ended how.
struct Counts {
  std::map<Status, std::size_t> by_status;
  std::size_t total = 0;       ///< different designs asked for
  std::size_t replayed = 0;    ///< of these, answered from the journal of an earlier run
  std::size_t unusable = 0;    ///< of these, ok, but with a response of the problem that is not a finite number
  std::size_t substituted = 0; ///< answers given to an algorithm in place of a failed evaluation
};

/// The best so far after an evaluation.
struct HistoryEntry {
  std::size_t best; ///< index of the best evaluation so far in Result::evaluations
  double objective; ///< its objective, as the response is given; NaN as long as none is usable
  double violation; ///< its worst scaled violation; NaN as long as none is usable
  bool feasible;    ///< whether it keeps all constraints
};

/// What came out of a run.
struct Result {
  std::vector<Evaluation> evaluations; ///< all different ones in the order in which they were asked for
  std::vector<HistoryEntry> history;   ///< one per evaluation; empty without an objective
  std::optional<Evaluation> best;      ///< best feasible; if there is none, the least infeasible; if all failed, none
  bool feasible = false;               ///< whether best keeps all constraints
  Counts counts;
  std::string stop_reason;        ///< why the run ended, in words
  std::string discrete_treatment; ///< how integers and lists of values were searched, in words
  std::string failure_treatment;  ///< what the algorithm was shown in place of failed evaluations, in words
};

/// Collects evaluations into a result.
class Record
{
public:
  explicit Record(const Problem &problem) : problem_(problem) {}

  /// Adds an evaluation unless its hash is already there. Returns how the problem sees it.
  Assessment add(const Evaluation &evaluation);

  /// Index into the assessments() and Result::evaluations of the best so far, if any is usable.
  std::optional<std::size_t> best() const { return best_; }

  const std::vector<Evaluation> &evaluations() const { return result_.evaluations; }
  const std::vector<Assessment> &assessments() const { return assessments_; }

  /// The result so far; stop_reason and the treatments are left to the caller.
  Result result() const;

private:
  void count(const Evaluation &evaluation, const Assessment &assessment);
  HistoryEntry history_entry() const;

  const Problem &problem_;
  Result result_;
  std::vector<Assessment> assessments_;
  std::map<std::string, std::size_t> index_; // by hash
  std::optional<std::size_t> best_;
};

} // namespace ballonet::optimize
