// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/discrete_plan.h"
#include "optimize/search.h"
#include "tests/optimize/formula_model.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

using namespace ballonet::optimize;
using Catch::Matchers::Contains;

namespace
{
Variable integer(const std::string &key, double min, double max)
{
  return {.key = key, .min = min, .max = max, .integer = true};
}

Variable length() { return {.key = "length", .min = 0, .max = 10}; }

/// The best length depends on the number n; the best pair is n = 4, length = 3.4, f = 0.
Evaluation mixed(const Design &d) { return ok({{"f", std::pow(d[1] - 3 - 0.1 * d[0], 2) + std::pow(d[0] - 4, 2)}}); }

Result minimum(DesignSpace space, Evaluation (*formula)(const Design &), const SearchOptions &options)
{
  Problem problem;
  problem.space = std::move(space);
  problem.objective = Objective{"f", Goal::minimize};
  FormulaModel model(formula);
  Evaluator evaluator(model);
  return search(problem, options, evaluator);
}
} // namespace

TEST_CASE("few combinations are enumerated, each with its own runs")
{
  SearchOptions options;
  options.max_evaluations = 200;
  const Result result = minimum(DesignSpace({integer("n", 1, 5), length()}), mixed, options);
  CHECK_THAT(result.discrete_treatment, Contains("enumerated") && Contains("5 combinations"));
  CHECK(result.best->design[0] == 4);
  CHECK(result.best->design[1] == Approx(3.4).margin(0.02));
  std::set<double> tried;
  for (const Evaluation &evaluation : result.evaluations)
    tried.insert(evaluation.design[0]);
  CHECK(tried == std::set<double>{1, 2, 3, 4, 5});
}

TEST_CASE("many combinations are rounded")
{
  SearchOptions options;
  options.max_evaluations = 400;
  options.algorithm = "GN_DIRECT_L";
  const Result result = minimum(DesignSpace({integer("n", 1, 40), length()}), mixed, options);
  CHECK_THAT(result.discrete_treatment, Contains("rounded") && Contains("40 combinations"));
  CHECK(result.best->design[0] == 4);
  CHECK(result.best->design[1] == Approx(3.4).margin(0.1));
  for (const Evaluation &evaluation : result.evaluations)
    CHECK(evaluation.design[0] == std::round(evaluation.design[0]));
}

TEST_CASE("a space of choices only is evaluated completely if the budget allows")
{
  const Variable material = {.key = "hardness", .values = {10, 30, 50}};
  const auto formula = [](const Design &d) { return ok({{"f", std::abs(d[0] - 4) + std::abs(d[1] - 30)}}); };
  SearchOptions options;
  options.max_evaluations = 15;
  const Result all = minimum(DesignSpace({integer("n", 1, 5), material}), formula, options);
  CHECK(all.counts.total == 15);
  CHECK(all.best->design == Design{4, 30});
  CHECK_THAT(all.discrete_treatment, Contains("exhaustive"));
  options.max_evaluations = 14;
  const Result some = minimum(DesignSpace({integer("n", 1, 5), material}), formula, options);
  CHECK_THAT(some.discrete_treatment, Contains("rounded"));
  CHECK(some.counts.total <= 14);
}

TEST_CASE("too small a budget per combination means rounding")
{
  const DesignSpace space({integer("n", 1, 5), length()});
  CHECK(plan_discrete(space, 8, 1, 30).treatment == DiscreteTreatment::enumerated);
  CHECK(plan_discrete(space, 8, 1, 29).treatment == DiscreteTreatment::rounded);
  CHECK(plan_discrete(space, 4, 1, 1000).treatment == DiscreteTreatment::rounded);
  CHECK(plan_discrete(space, 8, 2, 59).treatment == DiscreteTreatment::rounded);
}

TEST_CASE("a search over repeated designs ends")
{
  SearchOptions options;
  options.max_evaluations = 10;
  options.algorithm = "GN_CRS2_LM";
  options.x_tolerance = 0;
  const auto formula = [](const Design &d) { return ok({{"f", d[0] + d[1]}}); };
  const Result result = minimum(DesignSpace({integer("n", 1, 4), integer("m", 1, 4)}), formula, options);
  CHECK(result.counts.total <= 10);
  CHECK(!result.stop_reason.empty());
}
