// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/journal.h"
#include "optimize/search.h"
#include "tests/optimize/formula_model.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <sys/wait.h>

using namespace ballonet::optimize;
using Catch::Matchers::Contains;

namespace
{
Evaluation numbered(int i)
{
  Evaluation evaluation = i % 3 == 0 ? failure(Status::step_limit, "1000 steps") : ok({{"f", 1.0 / (i + 1)}});
  evaluation.hash = std::to_string(i);
  evaluation.design = {i / 7.0, 0.1};
  evaluation.seconds = 0.25;
  return evaluation;
}

void append_text(const std::filesystem::path &path, const std::string &text)
{
  std::ofstream(path, std::ios::app) << text;
}

Evaluation cone(const Design &d)
{
  return d[0] < -1 ? failure(Status::diverged, "no equilibrium") : ok({{"f", std::hypot(d[0] - 0.7, d[1])}});
}

Problem cone_problem()
{
  Problem problem;
  problem.space = square();
  problem.objective = Objective{"f", Goal::minimize};
  return problem;
}
} // namespace

TEST_CASE("a journal gives back what was put in, to the last bit")
{
  const TemporaryFolder folder;
  const auto path = folder / "journal.txt";
  {
    Journal journal(path, tab_separated());
    for (int i = 0; i < 5; ++i)
      journal.append(numbered(i));
    CHECK_THROWS_AS(journal.append(numbered(3)), std::logic_error);
  }
  const Journal journal(path, tab_separated());
  CHECK(journal.size() == 5);
  CHECK(journal.torn_bytes() == 0);
  for (int i = 0; i < 5; ++i) {
    const Evaluation *found = journal.find(std::to_string(i));
    REQUIRE(found != nullptr);
    CHECK(found->design == numbered(i).design);
    CHECK(found->status == numbered(i).status);
    CHECK(found->reason == numbered(i).reason);
    CHECK(found->responses == numbered(i).responses);
  }
  CHECK(journal.find("5") == nullptr);
}

TEST_CASE("a torn last line is cut off at every length")
{
  const TemporaryFolder folder;
  const auto path = folder / "journal.txt";
  const std::string torn = tab_separated().write(numbered(2));
  for (std::size_t length = 1; length <= torn.size(); ++length) {
    std::filesystem::remove(path);
    {
      Journal journal(path, tab_separated());
      journal.append(numbered(0));
      journal.append(numbered(1));
    }
    append_text(path, torn.substr(0, length));
    {
      Journal journal(path, tab_separated());
      CHECK(journal.size() == 2);
      CHECK(journal.torn_bytes() == length);
      journal.append(numbered(2));
    }
    const Journal journal(path, tab_separated());
    CHECK(journal.size() == 3);
    CHECK(journal.torn_bytes() == 0);
  }
}

TEST_CASE("damage inside a journal is an error that names the line, a repeated line is counted")
{
  const TemporaryFolder folder;
  const auto path = folder / "journal.txt";
  const std::string line = tab_separated().write(numbered(1)) + "\n";
  append_text(path, line + line);
  {
    const Journal journal(path, tab_separated());
    CHECK(journal.size() == 1);
    CHECK(journal.n_duplicates() == 1);
  }
  append_text(path, "nonsense\n");
  CHECK_THROWS_WITH(Journal(path, tab_separated()), Contains("journal.txt:3:"));
  CHECK_THROWS_AS(Journal(folder / "no/such/folder", tab_separated()), std::system_error);
  LineFile file(folder / "lines.txt");
  CHECK_THROWS_AS(file.append("a\nb"), std::invalid_argument);
}

TEST_CASE("a journal is open in one process at a time")
{
  const TemporaryFolder folder;
  const auto path = folder / "journal.txt";
  Journal journal(path, tab_separated());
  const pid_t child = fork();
  if (child == 0) {
    try {
      Journal(path, tab_separated());
    } catch (const std::system_error &) {
      _exit(7);
    }
    _exit(0);
  }
  int state = 0;
  waitpid(child, &state, 0);
  REQUIRE(WIFEXITED(state));
  CHECK(WEXITSTATUS(state) == 7);
}

TEST_CASE("a repeated search computes nothing and ends the same")
{
  const TemporaryFolder folder;
  SearchOptions options;
  options.initial = 8;
  options.starts = 2;
  options.max_evaluations = 40;
  for (const char *algorithm : {"LN_COBYLA", "GN_ISRES", "GN_ESCH"}) {
    INFO(algorithm);
    options.algorithm = algorithm;
    const auto run = [&](FormulaModel &model) {
      Journal journal(folder / algorithm, tab_separated());
      Evaluator evaluator(model, &journal);
      return search(cone_problem(), options, evaluator);
    };
    FormulaModel first(cone, 4), second(cone, 3), longer(cone, 4), fresh(cone, 4);
    const Result a = run(first), b = run(second);
    CHECK(first.sequence.size() == a.counts.total);
    CHECK(second.sequence.empty());
    CHECK(b.counts.replayed == b.counts.total);
    CHECK(b.best->design == a.best->design);
    CHECK(b.counts.by_status == a.counts.by_status);
    CHECK(b.stop_reason == a.stop_reason);

    SearchOptions more = options;
    more.max_evaluations = 60; // a larger budget goes on where the smaller ended
    Journal journal(folder / algorithm, tab_separated());
    Evaluator resumed(longer, &journal), unbroken(fresh);
    const Result c = search(cone_problem(), more, resumed), d = search(cone_problem(), more, unbroken);
    CHECK(longer.sequence.size() + a.counts.total == fresh.sequence.size());
    CHECK(c.best->design == d.best->design);
  }
}

TEST_CASE("evaluations of an interrupted batch are kept")
{
  const TemporaryFolder folder;
  const auto path = folder / "journal.txt";
  FormulaModel breaking(
      [n = 0](const Design &d) mutable {
        if (n++ == 2)
          throw std::domain_error("power cut");
        return cone(d);
      },
      4);
  const std::vector<Design> designs = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
  {
    Journal journal(path, tab_separated());
    Evaluator evaluator(breaking, &journal);
    CHECK_THROWS_AS(evaluator.evaluate(designs, {}), std::domain_error);
  }
  FormulaModel whole(cone, 4);
  Journal journal(path, tab_separated());
  CHECK(journal.size() == 2);
  Evaluator evaluator(whole, &journal);
  const auto evaluations = evaluator.evaluate({designs[3], designs[0], designs[1], designs[2], designs[0]}, {});
  CHECK(whole.sequence == std::vector<Design>{designs[3], designs[2]});
  CHECK(evaluations[1].design == designs[0]);
  CHECK(evaluations[4].hash == evaluations[1].hash);
  CHECK(evaluations[1].replayed);
  CHECK(evaluator.n_computed() == 2);
  CHECK(evaluator.n_replayed() == 2);
}
