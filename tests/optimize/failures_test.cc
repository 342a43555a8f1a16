// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/algorithm.h"
#include "optimize/presentation.h"
#include "optimize/search.h"
#include "tests/optimize/formula_model.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace ballonet::optimize;

namespace
{
/// A bowl whose minimum 0 at (0.5, -0.4) lies next to a region, a third of the space, where nothing can be computed.
Evaluation bowl_beside_failures(const Design &d)
{
  if (d[0] > 2.0 / 3.0)
    return d[1] > 0 ? failure(Status::diverged, "no equilibrium") : failure(Status::mesh_failed, "folds overlap");
  return ok({{"f", std::pow(d[0] - 0.5, 2) + std::pow(d[1] + 0.4, 2)}, {"sum", d[0] + d[1]}});
}

Problem bowl_problem()
{
  Problem problem;
  problem.space = square();
  problem.objective = Objective{"f", Goal::minimize};
  return problem;
}

std::size_t count_of(const Result &result, Status status)
{
  const auto found = result.counts.by_status.find(status);
  return found == result.counts.by_status.end() ? 0 : found->second;
}
} // namespace

TEST_CASE("failing designs in a third of the space do not stop a search")
{
  for (const Algorithm &algorithm : algorithms()) {
    INFO(algorithm.name);
    SearchOptions options;
    options.algorithm = algorithm.name;
    options.max_evaluations = algorithm.is_global() ? 3000 : 400;
    options.initial = 12;
    options.x_tolerance = 1e-6;
    FormulaModel model(bowl_beside_failures);
    Evaluator evaluator(model);
    const Result result = search(bowl_problem(), options, evaluator);
    REQUIRE(result.feasible);
    CHECK(result.best->status == Status::ok);
    CHECK(result.best->responses.at("f") < (algorithm.is_global() ? 1e-2 : 1e-3));
    CHECK(count_of(result, Status::diverged) > 0);
    CHECK(count_of(result, Status::mesh_failed) > 0);
    std::size_t sum = 0;
    for (const auto &[status, n] : result.counts.by_status)
      sum += n;
    CHECK(sum == result.counts.total);
    CHECK(sum == result.evaluations.size());
    for (const Evaluation &evaluation : result.evaluations)
      CHECK((evaluation.status == Status::ok) == (evaluation.responses.count("f") == 1)); // no substitute is recorded
  }
}

TEST_CASE("failing designs and a constraint together")
{
  Problem problem = bowl_problem();
  Constraint line;
  line.response = "sum";
  line.min = 0.5; // the optimum moves to (0.7, -0.2), which fails: what is left is the end of the line at x = 2/3
  problem.constraints = {line};
  for (const char *algorithm : {"LN_COBYLA", "GN_ISRES", "LN_NELDERMEAD"}) {
    INFO(algorithm);
    SearchOptions options;
    options.algorithm = algorithm;
    options.max_evaluations = 2000;
    options.initial = 12;
    FormulaModel model(bowl_beside_failures);
    Evaluator evaluator(model);
    const Result result = search(problem, options, evaluator);
    REQUIRE(result.feasible);
    const double x = 2.0 / 3.0, optimum = std::pow(x - 0.5, 2) + std::pow(0.5 - x + 0.4, 2);
    CHECK(result.best->responses.at("f") >= optimum - 1e-4);
    CHECK(result.best->responses.at("f") < optimum + 0.02);
    CHECK(result.counts.substituted > 0);
  }
}

TEST_CASE("a search in which everything fails ends without a best design")
{
  for (const char *algorithm : {"LN_COBYLA", "LN_SBPLX", "GN_DIRECT_L"}) {
    SearchOptions options;
    options.algorithm = algorithm;
    options.max_evaluations = 30;
    FormulaModel model([](const Design &) { return failure(Status::time_limit, "too slow"); });
    Evaluator evaluator(model);
    const Result result = search(bowl_problem(), options, evaluator);
    CHECK(!result.best);
    CHECK(!result.feasible);
    CHECK(count_of(result, Status::time_limit) == result.counts.total);
    CHECK(std::isnan(result.history.back().objective));
  }
}

TEST_CASE("an ok evaluation whose objective is no number counts as unusable")
{
  FormulaModel model([](const Design &d) {
    return ok({{"f", d[0] < -1 ? std::numeric_limits<double>::quiet_NaN() : d[0] * d[0] + d[1] * d[1]}});
  });
  Evaluator evaluator(model);
  SearchOptions options;
  options.initial = 20;
  const Result result = search(bowl_problem(), options, evaluator);
  CHECK(result.counts.unusable >= 4); // a quarter of the sample
  CHECK(result.best->responses.at("f") < 1e-3);
}

TEST_CASE("a failed answer is never better than a usable one")
{
  Assessment good, poor, failed;
  good.usable = poor.usable = true;
  good.cost = 1;
  poor.cost = 5;
  good.violations = poor.violations = {0.25};
  Presentation without(1, false), with(1, true);
  for (Presentation *presentation : {&without, &with}) {
    presentation->learn({0.0, 0.0}, good);
    presentation->learn({0.5, 0.5}, poor);
  }
  CHECK(without.answer({1.0, 1.0}, failed).cost == Approx(5 + 4 * 0.5));
  CHECK(without.answer({0.5, 0.5}, failed).cost == 5);
  CHECK(with.answer({1.0, 1.0}, failed).constraints == std::vector<double>({0.25, 1.5}));
  CHECK(with.answer({0.0, 0.0}, good).constraints == std::vector<double>({0.25, -1}));
  CHECK(with.n_substituted() == 1);
  CHECK(without.n_substituted() == 2);
}
