// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/result.h"
#include <limits>

namespace ballonet::optimize
{

Assessment Record::add(const Evaluation &evaluation)
{
  const auto [place, is_new] = index_.emplace(evaluation.hash, assessments_.size());
  if (!is_new)
    return assessments_[place->second];
  const Assessment assessment = assess(problem_, evaluation);
  assessments_.push_back(assessment);
  result_.evaluations.push_back(evaluation);
  count(evaluation, assessment);
  if (problem_.objective) {
    if (assessment.usable && (!best_ || is_better(assessment, assessments_[*best_])))
      best_ = assessments_.size() - 1;
    result_.history.push_back(history_entry());
  }
  return assessment;
}

void Record::count(const Evaluation &evaluation, const Assessment &assessment)
{
  ++result_.counts.total;
  ++result_.counts.by_status[evaluation.status];
  result_.counts.replayed += evaluation.replayed ? 1 : 0;
  result_.counts.unusable += evaluation.status == Status::ok && !assessment.usable ? 1 : 0;
}

HistoryEntry Record::history_entry() const
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  if (!best_)
    return {0, nan, nan, false};
  const Assessment &best = assessments_[*best_];
  const double sign = problem_.objective->goal == Goal::maximize ? -1 : 1;
  return {*best_, sign * best.cost, best.worst_violation, best.feasible};
}

Result Record::result() const
{
  Result result = result_;
  if (best_) {
    result.best = result.evaluations[*best_];
    result.feasible = assessments_[*best_].feasible;
  }
  return result;
}

} // namespace ballonet::optimize
