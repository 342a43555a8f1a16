// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/search.h"
#include "optimize/discrete_plan.h"
#include "optimize/lockstep.h"
#include "optimize/sampling.h"
#include "optimize/starting_points.h"
#include <stdexcept>

namespace ballonet::optimize
{

namespace
{
/// An algorithm that was asked so often, mostly for designs it knows after rounding, makes no progress.
constexpr int requests_per_evaluation = 20;

void check(const Problem &problem, const SearchOptions &options)
{
  check(problem);
  if (!problem.objective)
    throw std::invalid_argument("a search needs an objective");
  if (options.max_evaluations < 1 || options.starts < 1 || options.initial < 0)
    throw std::invalid_argument("max_evaluations and starts must be at least 1, initial at least 0");
  if (options.initial > options.max_evaluations)
    throw std::invalid_argument("initial = " + std::to_string(options.initial) +
                                " is above max_evaluations = " + std::to_string(options.max_evaluations));
  if (!(options.initial_step > 0 && options.initial_step <= 1 && options.x_tolerance >= 0 && options.f_tolerance >= 0))
    throw std::invalid_argument("initial_step must be above 0 and at most 1, tolerances must not be negative");
}

Presentation presentation_for(const Algorithm &algorithm, std::size_t bounds)
{
  const bool takes_constraints = algorithm.constraints == Constraints::native || bounds > 0;
  return Presentation(bounds, takes_constraints);
}

OptimizerSettings settings_for(const Problem &problem, const SearchOptions &options)
{
  OptimizerSettings settings;
  settings.constraint_tolerance = problem.tolerance;
  settings.initial_step = options.initial_step;
  settings.x_tolerance = options.x_tolerance;
  settings.f_tolerance = options.f_tolerance;
  settings.max_requests = requests_per_evaluation * options.max_evaluations;
  settings.population = options.population;
  return settings;
}

/// Points to start from, before anything is evaluated: the given design, or the middle if there is no sample, then the
/// sample.
std::vector<Point> first_points(const Problem &problem, const SearchOptions &options)
{
  std::vector<Point> points;
  if (options.start)
    points.push_back(problem.space.point_of(*options.start));
  else if (options.initial == 0)
    points.push_back(Point(problem.space.size(), 0.5));
  const std::size_t n = options.initial - (options.start && options.initial > 0 ? 1 : 0);
  const auto sample = latin_hypercube(n, problem.space.size(), options.seed);
  points.insert(points.end(), sample.begin(), sample.end());
  return points;
}

std::vector<Design> reserved(Ledger &ledger, std::vector<Design> designs)
{
  std::erase_if(designs, [&](const Design &design) { return !ledger.reserve(design); });
  return designs;
}

/// Evaluates points and gives back those that could be, in the order in which runs should start from them.
std::vector<Point> evaluated_in_order(const std::vector<Point> &points, const DesignSpace &space, Ledger &ledger,
                                      Lockstep &lockstep)
{
  const std::vector<Design> designs = reserved(ledger, designs_at(space, points));
  const std::vector<Assessment> assessments = ledger.evaluate(designs);
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < designs.size(); ++i) {
    candidates.push_back({space.point_of(designs[i]), assessments[i]});
    lockstep.learn(candidates.back().point, assessments[i]);
  }
  return starting_order(std::move(candidates));
}

void add_runs(Lockstep &lockstep, const Algorithm &algorithm, const SearchOptions &options,
              const OptimizerSettings &settings, const DiscretePlan &plan, const std::vector<Point> &candidates)
{
  unsigned long seed = options.seed;
  for (const Point &combination : plan.combinations) {
    const std::vector<Point> starts = moved_to(combination, plan.free, candidates);
    for (int i = 0; i < options.starts; ++i) {
      OptimizerSettings own = settings;
      own.seed = seed++;
      lockstep.add(algorithm, own, starts[i], plan.free);
    }
  }
}

Result exhaustive_result(const DiscretePlan &plan, const Problem &problem, Ledger &ledger)
{
  ledger.evaluate(reserved(ledger, designs_at(problem.space, plan.combinations)));
  Result result = ledger.record().result();
  result.stop_reason = "all combinations were evaluated";
  result.failure_treatment = "no algorithm was used";
  return result;
}

Result algorithm_result(const DiscretePlan &plan, const Problem &problem, const SearchOptions &options, Ledger &ledger)
{
  const Algorithm &algorithm = algorithm_named(options.algorithm);
  check(algorithm, plan.free.size(), n_bounds(problem));
  Lockstep lockstep(problem.space, ledger, presentation_for(algorithm, n_bounds(problem)));
  std::vector<Point> candidates = first_points(problem, options);
  if (options.initial > 0)
    candidates = evaluated_in_order(candidates, problem.space, ledger, lockstep);
  const auto more = latin_hypercube(options.starts, problem.space.size(), options.seed + 1);
  candidates.insert(candidates.end(), more.begin(), more.end());
  add_runs(lockstep, algorithm, options, settings_for(problem, options), plan, candidates);
  lockstep.run();

  Result result = ledger.record().result();
  result.stop_reason = lockstep.stop_reason();
  result.counts.substituted = lockstep.presentation().n_substituted();
  result.failure_treatment = lockstep.presentation().description();
  return result;
}
} // namespace

Result search(const Problem &problem, const SearchOptions &options, Evaluator &evaluator, const OnFinished &on_finished)
{
  check(problem, options);
  algorithm_named(options.algorithm); // wrong even if it turns out not to be needed
  Ledger ledger(problem, evaluator, on_finished, options.max_evaluations);
  const DiscretePlan plan = plan_discrete(problem.space, options.enumeration_limit, options.starts,
                                          options.max_evaluations - options.initial);
  Result result = plan.treatment == DiscreteTreatment::exhaustive ? exhaustive_result(plan, problem, ledger)
                                                                  : algorithm_result(plan, problem, options, ledger);
  result.discrete_treatment = plan.description;
  return result;
}

Result sample(const Problem &problem, const std::vector<Design> &designs, Evaluator &evaluator,
              const OnFinished &on_finished)
{
  check(problem);
  for (const Design &design : designs)
    problem.space.point_of(design); // throws if it lies outside
  Ledger ledger(problem, evaluator, on_finished, designs.size());
  for (const Design &design : designs)
    ledger.reserve(design);
  ledger.evaluate(designs);
  Result result = ledger.record().result();
  result.stop_reason = "all designs of the sample were evaluated";
  return result;
}

} // namespace ballonet::optimize
