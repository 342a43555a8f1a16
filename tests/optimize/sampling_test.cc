// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/sampling.h"
#include "optimize/search.h"
#include "tests/optimize/formula_model.h"
#include <catch2/catch.hpp>
#include <set>

using namespace ballonet::optimize;

TEST_CASE("a Latin hypercube has one point in every interval of every coordinate")
{
  for (const std::size_t n : {1, 7, 40}) {
    const std::vector<Point> points = latin_hypercube(n, 3, 5);
    REQUIRE(points.size() == n);
    for (std::size_t i = 0; i < 3; ++i) {
      std::set<std::size_t> intervals;
      for (const Point &point : points)
        intervals.insert(static_cast<std::size_t>(point[i] * n));
      CHECK(intervals.size() == n);
      CHECK(*intervals.rbegin() == n - 1);
    }
  }
  CHECK(latin_hypercube(10, 2, 3) == latin_hypercube(10, 2, 3));
  CHECK(latin_hypercube(10, 2, 3) != latin_hypercube(10, 2, 4));
}

TEST_CASE("a grid takes ends and choices")
{
  const DesignSpace space({{.key = "x"}, {.key = "n", .min = 1, .max = 2, .integer = true}});
  const auto designs = designs_at(space, full_factorial(space, {3, 0}));
  CHECK(designs == std::vector<Design>{{0, 1}, {0, 2}, {0.5, 1}, {0.5, 2}, {1, 1}, {1, 2}});
  CHECK_THROWS_AS(full_factorial(space, {0, 0}), std::invalid_argument);
  CHECK_THROWS_AS(full_factorial(space, {3}), std::invalid_argument);
}

TEST_CASE("a sample is evaluated in batches and returned whole")
{
  Problem problem;
  problem.space = square();
  FormulaModel model(
      [](const Design &d) {
        return d[0] > 1 ? failure(Status::inverted, "cell 3") : ok({{"f", d[0]}});
      },
      4);
  Evaluator evaluator(model);
  const auto designs = designs_at(problem.space, latin_hypercube(10, 2, 1));
  std::size_t announced = 0;
  const Result plain = sample(problem, designs, evaluator, [&](const Evaluation &) { ++announced; });
  CHECK(model.batches == std::vector<std::size_t>{4, 4, 2});
  CHECK(announced == 10);
  REQUIRE(plain.evaluations.size() == 10);
  for (std::size_t i = 0; i < 10; ++i)
    CHECK(plain.evaluations[i].design == designs[i]);
  CHECK(plain.counts.by_status.at(Status::inverted) >= 2);
  CHECK(!plain.best);

  problem.objective = Objective{"f", Goal::minimize};
  const Result judged = sample(problem, designs, evaluator);
  CHECK(model.sequence.size() == 10);
  CHECK(judged.best->design[0] < -1.6);
  CHECK_THROWS_AS(sample(problem, {{0, 9}}, evaluator), std::invalid_argument);
}
