// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/search.h"
#include "tests/optimize/formula_model.h"
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <csignal>
#include <fcntl.h>
#include <fstream>
#include <map>
#include <random>
#include <sys/wait.h>
#include <thread>

using namespace ballonet::optimize;

namespace
{
constexpr int budget = 200;
constexpr int kills = 20;

/// Tells a pipe of every design when its computation starts; slow enough to be hit in the middle of anything.
class WatchedModel : public FormulaModel
{
public:
  explicit WatchedModel(int pipe)
      : FormulaModel(
            [pipe](const Design &d) {
              const std::string line = text_of(d) + "\n";
              if (::write(pipe, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
                _exit(9);
              std::this_thread::sleep_for(std::chrono::milliseconds(1));
              return d[0] < -1.5 ? failure(Status::diverged, "no equilibrium")
                                 : ok({{"f", std::pow(d[0] - 0.3, 2) + std::pow(d[1] + 0.9, 2)}});
            },
            3)
  {
  }
};

Result run(const std::filesystem::path &path, int pipe, const OnFinished &on_finished)
{
  Problem problem;
  problem.space = square();
  problem.objective = Objective{"f", Goal::minimize};
  SearchOptions options;
  options.algorithm = "GN_CRS2_LM";
  options.x_tolerance = 0;
  options.initial = 10;
  options.starts = 3;
  options.max_evaluations = budget;
  WatchedModel model(pipe);
  Journal journal(path, tab_separated());
  Evaluator evaluator(model, &journal);
  return search(problem, options, evaluator, on_finished);
}

/// Waits until a file has grown by some bytes, or the child has ended.
void wait_for_growth(const std::filesystem::path &path, std::uintmax_t growth, pid_t child)
{
  const std::uintmax_t before = std::filesystem::file_size(path);
  siginfo_t info = {};
  while (std::filesystem::file_size(path) < before + growth && info.si_pid == 0) {
    std::this_thread::sleep_for(std::chrono::microseconds(50));
    waitid(P_PID, child, &info, WEXITED | WNOHANG | WNOWAIT);
  }
}

/// Runs the search in a child process and kills it some time after it has started to compute. True if it was killed,
/// false if it came to its end first.
bool run_and_kill(const TemporaryFolder &folder, int started, int finished, std::mt19937 &engine)
{
  const pid_t child = fork();
  if (child == 0) {
    run(folder / "journal", started, [&](const Evaluation &evaluation) {
      const std::string line = evaluation.hash + "\n";
      if (!evaluation.replayed && ::write(finished, line.data(), line.size()) < 0)
        _exit(9);
    });
    _exit(0);
  }
  wait_for_growth(folder / "started", 1 + engine() % 200, child); // a line has about 40 bytes
  std::this_thread::sleep_for(std::chrono::microseconds(engine() % 2000));
  kill(child, SIGKILL);
  int state = 0;
  waitpid(child, &state, 0);
  return WIFSIGNALED(state);
}

std::map<std::string, int> count_lines(const std::filesystem::path &path)
{
  std::map<std::string, int> counts;
  std::ifstream file(path);
  for (std::string line; std::getline(file, line);)
    ++counts[line];
  return counts;
}

int open_log(const std::filesystem::path &path) { return ::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0666); }
} // namespace

TEST_CASE("a search killed twenty times at random moments loses and repeats nothing that was finished")
{
  const TemporaryFolder folder;
  const int started = open_log(folder / "started"), finished = open_log(folder / "finished");
  const auto seed = std::random_device{}();
  INFO("seed " << seed);
  std::mt19937 engine(seed);
  for (int i = 0; i < kills; ++i)
    REQUIRE(run_and_kill(folder, started, finished, engine));
  const std::size_t kept = count_lines(folder / "journal").size();
  CHECK(kept > 0);
  CHECK(kept < budget);
  const auto result = run(folder / "journal", started, {});
  const int unbroken_log = open_log(folder / "unbroken");
  const auto unbroken = run(folder / "other", unbroken_log, {});

  CHECK(result.counts.replayed == kept);
  CHECK(result.counts.total == budget);
  CHECK(result.best->design == unbroken.best->design);
  const auto journal = count_lines(folder / "journal");
  CHECK(journal.size() == budget); // every line is there once
  for (const auto &[line, n] : journal)
    CHECK(n == 1);
  // What was announced as finished is in the journal and was finished only once.
  const auto announced = count_lines(folder / "finished");
  const Journal again(folder / "journal", tab_separated());
  CHECK(again.n_duplicates() == 0);
  for (const auto &[hash, n] : announced) {
    CHECK(n == 1);
    CHECK(again.find(hash) != nullptr);
  }
  int starts = 0;
  for (const auto &[design, n] : count_lines(folder / "started"))
    starts += n;
  CHECK(starts <= budget + kills); // at most one unfinished computation is lost per kill
  close(started);
  close(finished);
  close(unbroken_log);
}
