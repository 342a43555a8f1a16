// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/search.h"
#include "tests/optimize/formula_model.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace ballonet::optimize;
using Catch::Matchers::Contains;

namespace
{
/// Maximize x + y on the disc x^2 + y^2 <= 1: the optimum is sqrt(2) at x = y = sqrt(1/2).
Problem disc()
{
  Problem problem;
  problem.space = square();
  problem.objective = Objective{"sum", Goal::maximize};
  Constraint inside;
  inside.response = "radius2";
  inside.max = 1;
  problem.constraints = {inside};
  return problem;
}

Evaluation on_disc(const Design &d) { return ok({{"sum", d[0] + d[1]}, {"radius2", d[0] * d[0] + d[1] * d[1]}}); }

Result best_on_disc(const std::string &algorithm, int budget)
{
  SearchOptions options;
  options.algorithm = algorithm;
  options.max_evaluations = budget;
  options.x_tolerance = 1e-6;
  FormulaModel model(on_disc);
  Evaluator evaluator(model);
  return search(disc(), options, evaluator);
}
} // namespace

TEST_CASE("constrained optimum on a disc")
{
  struct Expected {
    std::string algorithm;
    int budget;
    double error;
  };
  for (const Expected &expected : {Expected{"LN_COBYLA", 200, 1e-4},
                                   {"GN_ISRES", 4000, 2e-3},
                                   {"GN_ORIG_DIRECT", 3000, 2e-2},
                                   {"GN_ORIG_DIRECT_L", 3000, 2e-2},
                                   {"LN_BOBYQA", 1000, 1e-3},
                                   {"LN_NELDERMEAD", 2000, 1e-3},
                                   {"LN_SBPLX", 2000, 1e-3}}) {
    INFO(expected.algorithm);
    const Result result = best_on_disc(expected.algorithm, expected.budget);
    REQUIRE(result.feasible);
    CHECK(result.best->responses.at("radius2") <= 1 + 1e-6);
    CHECK(result.best->responses.at("sum") == Approx(std::sqrt(2.0)).margin(expected.error));
  }
}

TEST_CASE("two-sided constraint away from the unconstrained optimum")
{
  // Minimize x^2 + y^2 with 1 <= x + y <= 1.5: the optimum is 0.5 at x = y = 0.5.
  Problem problem;
  problem.space = square();
  problem.objective = Objective{"f", Goal::minimize};
  Constraint band;
  band.response = "sum";
  band.min = 1;
  band.max = 1.5;
  problem.constraints = {band};
  CHECK(n_bounds(problem) == 2);
  FormulaModel model([](const Design &d) { return ok({{"f", d[0] * d[0] + d[1] * d[1]}, {"sum", d[0] + d[1]}}); });
  Evaluator evaluator(model);
  SearchOptions options;
  options.x_tolerance = 1e-6;
  const Result result = search(problem, options, evaluator);
  CHECK(result.feasible);
  CHECK(result.best->responses.at("f") == Approx(0.5).margin(1e-4));
}

TEST_CASE("without a feasible design the least infeasible is reported as infeasible")
{
  Problem problem = disc();
  problem.constraints.front().max.reset();
  problem.constraints.front().min = 20; // the corners have radius2 = 8
  FormulaModel model(on_disc);
  Evaluator evaluator(model);
  SearchOptions options;
  options.initial = 10;
  const Result result = search(problem, options, evaluator);
  CHECK(!result.feasible);
  CHECK(result.best->responses.at("radius2") == Approx(8).margin(1e-2));
  CHECK(result.history.back().violation == Approx(0.6).margin(1e-3));
}

TEST_CASE("wrong constraints and responses are refused")
{
  FormulaModel model(on_disc);
  Evaluator evaluator(model);
  Problem problem = disc();
  const auto run = [&](const SearchOptions &options = {}) { return search(problem, options, evaluator); };
  SearchOptions global;
  global.algorithm = "GN_CRS2_LM";
  CHECK_THROWS_WITH(run(global), Contains("takes no constraints"));
  problem.objective->response = "summ";
  CHECK_THROWS_WITH(run(), Contains("no response 'summ'") && Contains("radius2"));
  problem = disc();
  problem.constraints.front().min = 2;
  CHECK_THROWS_WITH(run(), Contains("min is above max"));
  problem.constraints.front().min.reset();
  problem.constraints.front().max = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(run(), Contains("finite"));
  problem.constraints.front().max.reset();
  CHECK_THROWS_WITH(run(), Contains("neither min nor max"));
  problem = disc();
  problem.objective.reset();
  CHECK_THROWS_WITH(run(), Contains("objective"));
  problem = disc();
  SearchOptions options;
  options.max_evaluations = 5;
  options.initial = 6;
  CHECK_THROWS_AS(run(options), std::invalid_argument);
  options.initial = 0;
  options.start = Design{0, 3};
  CHECK_THROWS_WITH(run(options), Contains("'y'") && Contains("outside"));
  CHECK(model.sequence.size() == 1); // the one that showed that there is no response 'summ'
}
