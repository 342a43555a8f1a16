// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/problem.h"
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ballonet::optimize
{

namespace
{
double response_of(const Evaluation &evaluation, const std::string &name)
{
  const auto found = evaluation.responses.find(name);
  if (found != evaluation.responses.end())
    return found->second;
  std::string message = "no response '" + name + "'; there are:";
  for (const auto &response : evaluation.responses)
    message += " " + response.first;
  throw std::invalid_argument(message);
}

/// Reads a response of an ok evaluation; marks the assessment unusable if it is not a finite number.
double finite_response(const Evaluation &evaluation, const std::string &name, Assessment &assessment)
{
  const double value = response_of(evaluation, name);
  if (!std::isfinite(value)) {
    assessment.usable = false;
    assessment.reason = "response '" + name + "' is not a finite number";
  }
  return value;
}

void add_violations(const Constraint &constraint, double value, std::vector<double> &violations)
{
  if (constraint.min)
    violations.push_back((*constraint.min - value) / constraint.scale());
  if (constraint.max)
    violations.push_back((value - *constraint.max) / constraint.scale());
}
} // namespace

double Constraint::scale() const
{
  if (min && max && *min < *max)
    return *max - *min;
  const double size = std::abs(min ? *min : *max);
  return size > 0 ? size : 1;
}

void check(const Problem &problem)
{
  if (problem.space.size() == 0)
    throw std::invalid_argument("there is no variable");
  if (!(problem.tolerance >= 0 && std::isfinite(problem.tolerance)))
    throw std::invalid_argument("the tolerance of the constraints must be a finite number, not negative");
  for (const Constraint &constraint : problem.constraints) {
    const std::string name = "constraint on '" + constraint.response + "': ";
    if (!constraint.min && !constraint.max)
      throw std::invalid_argument(name + "neither min nor max is given");
    if ((constraint.min && !std::isfinite(*constraint.min)) || (constraint.max && !std::isfinite(*constraint.max)))
      throw std::invalid_argument(name + "min and max must be finite numbers");
    if (constraint.min && constraint.max && *constraint.min > *constraint.max)
      throw std::invalid_argument(name + "min is above max");
  }
}

std::size_t n_bounds(const Problem &problem)
{
  std::size_t n = 0;
  for (const Constraint &constraint : problem.constraints)
    n += std::size_t(constraint.min.has_value()) + std::size_t(constraint.max.has_value());
  return n;
}

Assessment assess(const Problem &problem, const Evaluation &evaluation)
{
  Assessment assessment;
  if (evaluation.status != Status::ok) {
    assessment.reason = std::string(word_of(evaluation.status)) + ": " + evaluation.reason;
    return assessment;
  }
  assessment.usable = true;
  if (problem.objective) {
    const double value = finite_response(evaluation, problem.objective->response, assessment);
    assessment.cost = problem.objective->goal == Goal::maximize ? -value : value;
  }
  for (const Constraint &constraint : problem.constraints)
    add_violations(constraint, finite_response(evaluation, constraint.response, assessment), assessment.violations);
  for (const double violation : assessment.violations)
    assessment.worst_violation = std::max(assessment.worst_violation, violation);
  assessment.feasible = assessment.usable && assessment.worst_violation <= problem.tolerance;
  return assessment;
}

bool is_better(const Assessment &a, const Assessment &b)
{
  if (!a.usable || !b.usable)
    return a.usable && !b.usable;
  if (a.feasible != b.feasible)
    return a.feasible;
  return a.feasible ? a.cost < b.cost : a.worst_violation < b.worst_violation;
}

} // namespace ballonet::optimize
