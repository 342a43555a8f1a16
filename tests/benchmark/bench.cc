// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/simulation.h"
#include "tests/benchmark/benchmark_case.h"
#include "tests/benchmark/calculix_input.h"
#include <deal.II/base/mpi.h>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr const char *usage =
    R"(usage: bench solve CASE CELLS FILE                     solves with Ballonet, writes the displacements
       bench write CASE CELLS FILE ELEMENT BULK_RATIO  writes the input of CalculiX, prints its number of nodes
       bench error CASE CELLS FILE                     prints the error of displacements as either program wrote them
scripts/bench calls it. CASE: tube, sphere, cook or cantilever.
)";

/// One line per node: number from 1, displacement.
void write_displacements(const std::string &file, const std::vector<double> &u)
{
  std::ofstream out(file);
  out << std::setprecision(12);
  for (std::size_t node = 0; node < u.size() / 3; ++node)
    out << node + 1 << ' ' << u[3 * node] << ' ' << u[3 * node + 1] << ' ' << u[3 * node + 2] << '\n';
}

/// Lines of four numbers; others, such as CalculiX's headings, are skipped.
std::vector<double> read_displacements(const std::string &file, std::size_t n_nodes)
{
  std::vector<double> u(3 * n_nodes);
  std::ifstream in(file);
  std::size_t found = 0;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::size_t node;
    double x, y, z;
    if (words >> node >> x >> y >> z) {
      u.at(3 * node - 3) = x, u.at(3 * node - 2) = y, u.at(3 * node - 1) = z;
      ++found;
    }
  }
  if (found == 0)
    throw std::runtime_error("there are no displacements in " + file);
  return u;
}

int solve(const BenchmarkCase &problem, const std::string &file)
{
  Simulation simulation(problem.parameters, problem.mesh, MPI_COMM_SELF);
  const auto result = simulation.run([](const PathPoint &) { return ""; }, [](const std::string &) {});
  if (result.status != PathStatus::ended) {
    std::cerr << "bench: " << result.reason << '\n';
    return 1;
  }
  const auto &progress = simulation.progress();
  write_displacements(file, progress.state.displacement);
  std::cout << "{\"nodes\": " << problem.mesh.nodes.size() << ", \"steps\": " << progress.step
            << ", \"iterations\": " << progress.iterations << "}\n";
  return 0;
}

int run(const std::vector<std::string> &words)
{
  if (words.size() < 4 || (words[0] == "write" && words.size() < 6)) {
    std::cerr << usage;
    return 2;
  }
  const auto problem = benchmark_case(words[1], std::stoi(words[2]));
  if (words[0] == "solve")
    return solve(problem, words[3]);
  if (words[0] == "write") {
    std::ofstream out(words[3]);
    write_calculix_input(out, problem.mesh, problem.parameters, words[4], std::stod(words[5]));
    std::cout << shared_nodes(problem.mesh).size() << '\n';
    return out ? 0 : 1;
  }
  std::cout << std::setprecision(10) << problem.error(read_displacements(words[3], problem.mesh.nodes.size())) << '\n';
  return 0;
}

} // namespace

int main(int argc, char *argv[])
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  try {
    return run({argv + 1, argv + argc});
  } catch (const std::exception &error) {
    std::cerr << "bench: " << error.what() << '\n';
    return 2;
  }
}
