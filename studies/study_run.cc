// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/study_run.h"
#include "optimize/sampling.h"
#include <algorithm>
#include <cmath>

namespace ballonet::studies
{
namespace
{

optimize::Result solve(const optimize::Problem &problem, optimize::Evaluator &evaluator,
                       const optimize::OnFinished &on_finished)
{
  optimize::Record record(problem);
  for (const optimize::Evaluation &evaluation : evaluator.evaluate({optimize::Design{}}, on_finished))
    record.add(evaluation);
  optimize::Result result = record.result();
  result.best = result.evaluations.front();
  result.feasible = record.assessments().front().feasible;
  result.stop_reason = result.best->reason;
  return result;
}

/// The largest number of levels per continuous variable whose combinations stay within the budget.
std::size_t levels_within(const optimize::DesignSpace &space, std::size_t budget)
{
  std::size_t n_continuous = 0;
  for (std::size_t i = 0; i < space.size(); ++i)
    n_continuous += !space.is_discrete(i);
  std::size_t levels = 1;
  const double combinations = static_cast<double>(space.n_combinations());
  while (n_continuous > 0 && combinations * std::pow(levels + 1, n_continuous) <= static_cast<double>(budget))
    ++levels;
  return levels;
}

std::vector<optimize::Design> sampled_designs(const StudyFile &file)
{
  const Method &method = file.study().method;
  const auto budget = static_cast<std::size_t>(method.search.max_evaluations);
  const optimize::DesignSpace &space = file.space();
  if (method.sampling == Sampling::latin_hypercube)
    return designs_at(space,
                      optimize::latin_hypercube(budget, space.size(), static_cast<std::uint64_t>(method.search.seed)));
  const std::vector<std::size_t> levels(space.size(), levels_within(space, budget));
  return designs_at(space, optimize::full_factorial(space, levels));
}

} // namespace

optimize::Problem problem_of(const StudyFile &file)
{
  optimize::Problem problem;
  problem.space = file.space();
  problem.objective = file.study().objective;
  for (const Constraint &constraint : file.study().constraints)
    problem.constraints.push_back({constraint.response, constraint.min, constraint.max});
  return problem;
}

optimize::Result run_method(const StudyFile &file, optimize::Evaluator &evaluator,
                            const optimize::OnFinished &on_finished)
{
  const optimize::Problem problem = problem_of(file);
  switch (file.study().method.kind) {
  case MethodKind::sample:
    return optimize::sample(problem, sampled_designs(file), evaluator, on_finished);
  case MethodKind::optimize:
    return optimize::search(problem, file.study().method.search, evaluator, on_finished);
  default:
    return solve(problem, evaluator, on_finished);
  }
}

bool has_result(const Study &study, const optimize::Result &result)
{
  if (study.method.kind == MethodKind::optimize)
    return result.best && result.feasible;
  return std::any_of(result.evaluations.begin(), result.evaluations.end(),
                     [](const auto &evaluation) { return evaluation.status == optimize::Status::ok; });
}

std::size_t largest_number_of_evaluations(const StudyFile &file)
{
  if (file.study().method.kind == MethodKind::sample)
    return sampled_designs(file).size();
  if (file.study().method.kind == MethodKind::optimize)
    return static_cast<std::size_t>(file.study().method.search.max_evaluations);
  return 1;
}

} // namespace ballonet::studies
