// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/algorithm.h"
#include "optimize/search.h"
#include "tests/optimize/formula_model.h"
#include <catch2/catch.hpp>
#include <cmath>

using namespace ballonet::optimize;
using Catch::Matchers::Contains;

namespace
{
Evaluation bowl(const Design &d) { return ok({{"f", 3 + std::pow(d[0] - 0.6, 2) + 2 * std::pow(d[1] + 0.3, 2)}}); }

Evaluation rosenbrock(const Design &d)
{
  return ok({{"f", 100 * std::pow(d[1] - d[0] * d[0], 2) + std::pow(1 - d[0], 2)}});
}

Result minimum(Evaluation (*formula)(const Design &), const std::string &algorithm, int budget)
{
  Problem problem;
  problem.space = square();
  problem.objective = Objective{"f", Goal::minimize};
  SearchOptions options;
  options.algorithm = algorithm;
  options.max_evaluations = budget;
  options.x_tolerance = 1e-7;
  FormulaModel model(formula);
  Evaluator evaluator(model);
  return search(problem, options, evaluator);
}
} // namespace

TEST_CASE("every algorithm finds the minimum of a bowl")
{
  for (const Algorithm &algorithm : algorithms()) {
    INFO(algorithm.name);
    const Result result = minimum(bowl, algorithm.name, algorithm.is_global() ? 4000 : 400);
    const double error = algorithm.is_global() ? 0.05 : 1e-3;
    REQUIRE(result.feasible);
    CHECK(std::abs(result.best->design[0] - 0.6) < error);
    CHECK(std::abs(result.best->design[1] + 0.3) < error);
    CHECK(result.best->responses.at("f") < 3 + error * error * 3);
    CHECK(!result.stop_reason.empty());
  }
}

TEST_CASE("algorithms find the end of Rosenbrock's valley")
{
  for (const Algorithm &algorithm : algorithms()) {
    INFO(algorithm.name);
    const Result result = minimum(rosenbrock, algorithm.name, algorithm.is_global() ? 8000 : 3000);
    // COBYLA works with linear models and creeps along a curved valley; evolution without recombination only comes
    // near.
    const double value = algorithm.name == "GN_ESCH"                              ? 0.1
                         : algorithm.is_global() || algorithm.name == "LN_COBYLA" ? 0.01
                                                                                  : 1e-6;
    CHECK(result.best->responses.at("f") < value);
  }
}

TEST_CASE("a maximum is a minimum of the negative")
{
  Problem problem;
  problem.space = square();
  problem.objective = Objective{"f", Goal::maximize};
  FormulaModel model([](const Design &d) { return ok({{"f", 5 - d[0] * d[0] - std::pow(d[1] - 1, 2)}}); });
  Evaluator evaluator(model);
  const Result result = search(problem, {}, evaluator);
  CHECK(result.best->responses.at("f") == Approx(5).margin(1e-4));
  CHECK(result.history.back().objective == result.best->responses.at("f"));
}

TEST_CASE("algorithms are found by name")
{
  CHECK(algorithm_named("NLOPT_LN_COBYLA").name == "LN_COBYLA");
  CHECK(algorithm_named("gn_isres").name == "GN_ISRES");
  CHECK_THROWS_WITH(algorithm_named("LN_COBILA"), Contains("LN_COBILA") && Contains("mean LN_COBYLA") &&
                                                      Contains("GN_DIRECT_L") && Contains("LN_SBPLX"));
  CHECK_THROWS_WITH(check(algorithm_named("GN_CRS2_LM"), 2, 1), Contains("GN_ISRES") && Contains("GN_ORIG_DIRECT"));
  CHECK_THROWS_WITH(check(algorithm_named("LN_BOBYQA"), 1, 0), Contains("LN_COBYLA"));
}
