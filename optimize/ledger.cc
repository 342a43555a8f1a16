// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/ledger.h"
#include <stdexcept>

namespace ballonet::optimize
{

Ledger::Ledger(const Problem &problem, Evaluator &evaluator, const OnFinished &on_finished, std::size_t budget)
    : evaluator_(evaluator), on_finished_(on_finished), budget_(budget), record_(problem)
{
}

bool Ledger::reserve(const Design &design)
{
  const std::string hash = evaluator_.content_hash(design);
  if (reserved_.count(hash))
    return true;
  if (remaining() == 0)
    return false;
  reserved_.insert(hash);
  return true;
}

std::vector<Assessment> Ledger::evaluate(const std::vector<Design> &designs)
{
  std::vector<Assessment> assessments;
  for (const Evaluation &evaluation : evaluator_.evaluate(designs, on_finished_)) {
    if (!reserved_.count(evaluation.hash))
      throw std::logic_error("evaluation " + evaluation.hash + " is outside the budget");
    assessments.push_back(record_.add(evaluation));
  }
  return assessments;
}

} // namespace ballonet::optimize
