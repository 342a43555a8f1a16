// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/evaluator.h"
#include "optimize/result.h"
#include <set>

namespace ballonet::optimize
{

/// The evaluations of one search within its budget. The budget counts different designs, whether they are computed or
/// replayed from a journal: only then does a resumed search repeat itself.
class Ledger
{
public:
  /// Everything referred to must outlive the ledger.
  Ledger(const Problem &problem, Evaluator &evaluator, const OnFinished &on_finished, std::size_t budget);

  /// Whether a design can be evaluated: it is known, or the budget has room for it, which is then taken.
  bool reserve(const Design &design);

  /// Evaluates reserved designs as one batch. Throws std::logic_error if one was not reserved.
  std::vector<Assessment> evaluate(const std::vector<Design> &designs);

  const Record &record() const { return record_; }
  std::size_t budget() const { return budget_; }
  std::size_t remaining() const { return budget_ - reserved_.size(); }

private:
  Evaluator &evaluator_;
  const OnFinished &on_finished_;
  std::size_t budget_;
  Record record_;
  std::set<std::string> reserved_; // hashes
};

} // namespace ballonet::optimize
