// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/algorithm.h"
#include "optimize/coroutine.h"
#include "optimize/search.h"
#include "tests/optimize/formula_model.h"
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <thread>

using namespace ballonet::optimize;

namespace
{
/// Two minima; the lower one, -1.25, near (-1, 0).
Evaluation two_valleys(const Design &d)
{
  return ok({{"f", std::pow(d[0] * d[0] - 1, 2) + d[1] * d[1] + 0.25 * d[0] - 1}});
}

Problem valleys()
{
  Problem problem;
  problem.space = square();
  problem.objective = Objective{"f", Goal::minimize};
  return problem;
}

SearchOptions two_starts()
{
  SearchOptions options;
  options.starts = 2;
  options.initial = 6;
  options.max_evaluations = 60;
  return options;
}
} // namespace

TEST_CASE("lockstep batches have one design per run")
{
  for (const int starts : {1, 2, 3}) {
    SearchOptions options = two_starts();
    options.starts = starts;
    options.initial = 0;
    options.max_evaluations = 10 * starts;
    options.x_tolerance = 0;
    options.algorithm = "GN_CRS2_LM"; // never stops by itself here
    FormulaModel model(two_valleys, 8);
    Evaluator evaluator(model);
    const Result result = search(valleys(), options, evaluator);
    CHECK(model.batches == std::vector<std::size_t>(10, starts));
    CHECK(result.counts.total == 10u * starts);
  }
}

TEST_CASE("the model is called from the calling thread only")
{
  const auto caller = std::this_thread::get_id();
  bool elsewhere = false;
  FormulaModel model([&](const Design &d) {
    elsewhere = elsewhere || std::this_thread::get_id() != caller;
    return two_valleys(d);
  });
  Evaluator evaluator(model);
  search(valleys(), two_starts(), evaluator);
  CHECK(!elsewhere);
}

TEST_CASE("timing and batch size change nothing")
{
  for (const char *algorithm : {"LN_COBYLA", "GN_ISRES", "GN_ESCH", "GN_CRS2_LM", "LN_PRAXIS"}) {
    INFO(algorithm);
    SearchOptions options = two_starts();
    options.algorithm = algorithm;
    FormulaModel plain(two_valleys, 2), sleepy(
                                            [n = 0](const Design &d) mutable {
                                              std::this_thread::sleep_for(std::chrono::microseconds(n++ * 7919 % 900));
                                              return two_valleys(d);
                                            },
                                            5);
    Evaluator first(plain), second(sleepy);
    const Result a = search(valleys(), options, first), b = search(valleys(), options, second);
    CHECK(plain.sequence == sleepy.sequence);
    CHECK(a.best->design == b.best->design);
    CHECK(a.stop_reason == b.stop_reason);
    options.seed = 2;
    FormulaModel other(two_valleys, 2);
    Evaluator third(other);
    search(valleys(), options, third);
    CHECK(other.sequence != plain.sequence);
  }
}

TEST_CASE("several starts find the better of two valleys")
{
  SearchOptions options = two_starts();
  options.initial = 12;
  options.starts = 4;
  options.max_evaluations = 200;
  FormulaModel model(two_valleys, 4);
  Evaluator evaluator(model);
  const Result result = search(valleys(), options, evaluator);
  CHECK(result.best->design[0] == Approx(-1.03).margin(0.02));
}

TEST_CASE("an exception of the model ends all runs and reaches the caller")
{
  for (int good = 0; good < 12; good += 3) {
    FormulaModel model([&, n = 0](const Design &d) mutable {
      if (n++ >= good)
        throw std::domain_error("a bug in the model");
      return two_valleys(d);
    });
    Evaluator evaluator(model);
    SearchOptions options = two_starts();
    options.initial = 0;
    options.starts = 3;
    CHECK_THROWS_AS(search(valleys(), options, evaluator), std::domain_error);
  }
}

TEST_CASE("the budget is kept exactly")
{
  for (const Algorithm &algorithm : algorithms())
    for (const int budget : {1, 2, 7, 33}) {
      INFO(algorithm.name << " " << budget);
      SearchOptions options;
      options.algorithm = algorithm.name;
      options.max_evaluations = budget;
      options.starts = 2;
      options.x_tolerance = 0;
      FormulaModel model(two_valleys, 4);
      Evaluator evaluator(model);
      const Result result = search(valleys(), options, evaluator);
      CHECK(result.counts.total == static_cast<std::size_t>(budget));
      CHECK(model.sequence.size() == static_cast<std::size_t>(budget));
      CHECK_THAT(result.stop_reason, Catch::Matchers::Contains("budget of " + std::to_string(budget)));
    }
}

TEST_CASE("a coroutine can be left at any moment")
{
  using Doubler = Coroutine<int, int>;
  const auto body = [](const Doubler::Yield &yield) {
    for (int i = 0; i < 3; ++i)
      if (yield(i) != 2 * i)
        throw std::domain_error("wrong answer");
  };
  for (int steps = 0; steps < 6; ++steps) {
    Doubler doubler(body);
    for (int i = 0; i < steps; ++i) {
      const auto request = doubler.resume();
      CHECK(request.has_value() == (i < 3));
      doubler.answer(request ? 2 * *request : 0);
    }
  }
  Doubler doubler(body);
  doubler.resume();
  doubler.answer(1);
  CHECK_THROWS_AS(doubler.resume(), std::domain_error);
  CHECK(!doubler.resume());
}
