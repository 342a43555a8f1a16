// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/simulation.h"
#include "tests/support/nodal_fields.h"
#include "tests/support/shallow_arch.h"
#include <catch2/catch.hpp>
#include <filesystem>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

struct Row {
  bool at_rest;
  double dissipated_share;
  State state;
};

struct Walk {
  std::vector<Row> rows;
  std::string log;
  PathResult result;
  PathProgress progress;
};

Walk walk(Simulation &simulation)
{
  Walk walk;
  walk.result = simulation.run(
      [&](const PathPoint &point) {
        walk.rows.push_back({point.at_rest, point.dissipated_share, point.progress.state});
        return "";
      },
      [&](const std::string &line) { walk.log += line + '\n'; });
  walk.progress = simulation.progress();
  return walk;
}

/// How far a state moves when it is left alone at its pressure, mm; infinity where it does not come to rest nearby.
double unrest(const ShallowArch &arch, const State &at)
{
  Equilibrium equilibrium(arch.parameters, arch.mesh, MPI_COMM_SELF);
  State state = at;
  const auto outcome = equilibrium.solve(state, {infinity, 1, false, false}, {.parameter = at.pressure});
  return !outcome.converged ? infinity : largest_difference(state.displacement, at.displacement);
}

} // namespace

TEST_CASE("regularisation: static steps are tried again after the more rests the more often they failed")
{
  Regularisation r;
  CHECK_FALSE(r.seeks_rest());
  r.set_in_motion(3);
  r.moved();
  CHECK(r.seeks_rest()); // at once after a single event
  r.sought_rest(true, 3);
  CHECK_FALSE(r.moving);
  r.set_in_motion(3);
  r.moved();
  CHECK_FALSE(r.seeks_rest());
  r.moved(), r.moved();
  CHECK(r.seeks_rest());
  r.sought_rest(true, 3);
  CHECK(r.moving); // two rests this time
  CHECK_FALSE(r.seeks_rest());
  r.moved(), r.moved(), r.moved();
  r.sought_rest(false, 3);
  CHECK(r.moving);
  r.moved(), r.moved(), r.moved();
  CHECK_FALSE(r.seeks_rest()); // the search waits twice as long after one in vain
  r.moved(), r.moved(), r.moved();
  CHECK(r.seeks_rest());
  r.sought_rest(true, 3);
  CHECK_FALSE(r.moving);
}

// The pressure passes the arch's limit, where no equilibrium is near.
TEST_CASE("regularisation: an arch snaps through in motion and comes to rest; what is called an equilibrium is one")
{
  const ShallowArch arch;
  Simulation simulation(arch.parameters, arch.mesh, MPI_COMM_SELF);
  const auto snapped = walk(simulation);
  INFO(snapped.log << snapped.result.reason);
  REQUIRE(snapped.result.status == PathStatus::ended);
  REQUIRE(snapped.rows.front().at_rest);
  REQUIRE(snapped.rows.back().at_rest);
  int moving = 0;
  for (const Row &row : snapped.rows) {
    INFO("at p " << 1e3 * row.state.pressure << " kPa");
    if (row.at_rest) {
      CHECK(unrest(arch, row.state) < 1e-7);
      continue;
    }
    ++moving;
    CHECK(row.dissipated_share > 0.01);
    CHECK(unrest(arch, row.state) > 1e-3);
  }
  CHECK(moving > 0);
  const auto middle = surface_nodes(arch.mesh, "x1").front();
  CHECK(snapped.rows.back().state.displacement[3 * middle + 1] < -3); // below the clamp
}

TEST_CASE("regularisation: without anything that feels rates there are static steps only")
{
  ShallowArch arch;
  arch.parameters.materials[0].relaxation_time = 0;
  arch.parameters.path.step_min = 1e-4;
  Simulation simulation(arch.parameters, arch.mesh, MPI_COMM_SELF);
  const auto stopped = walk(simulation);
  INFO(stopped.log);
  CHECK(stopped.result.status == PathStatus::diverged); // at the limit
  for (const Row &row : stopped.rows)
    CHECK(row.at_rest);
}

TEST_CASE("regularisation: rates = always is a motion from its first step after the preload on")
{
  ShallowArch arch;
  arch.parameters.path.rates = Rates::always;
  Simulation simulation(arch.parameters, arch.mesh, MPI_COMM_SELF);
  const auto moved = walk(simulation);
  INFO(moved.log << moved.result.reason);
  REQUIRE(moved.result.status == PathStatus::ended);
  CHECK(moved.rows.front().at_rest);
  for (std::size_t i = 1; i < moved.rows.size(); ++i)
    CHECK_FALSE(moved.rows[i].at_rest);
}

TEST_CASE("regularisation: one and two ranks snap alike", "[mpi]")
{
  const ShallowArch arch;
  Simulation alone(arch.parameters, arch.mesh, MPI_COMM_SELF), together(arch.parameters, arch.mesh, MPI_COMM_WORLD);
  const auto a = walk(alone), b = walk(together);
  REQUIRE(a.rows.size() == b.rows.size());
  for (std::size_t i = 0; i < a.rows.size(); ++i) {
    CHECK(a.rows[i].at_rest == b.rows[i].at_rest);
    CHECK(largest_difference(a.rows[i].state.displacement, b.rows[i].state.displacement) < 1e-8);
  }
}

TEST_CASE("regularisation: interrupted in motion and resumed, the path is the same")
{
  ShallowArch arch;
  Simulation whole(arch.parameters, arch.mesh, MPI_COMM_SELF);
  const auto expected = walk(whole);
  const auto first_in_motion =
      std::find_if(expected.rows.begin(), expected.rows.end(), [](const Row &r) { return !r.at_rest; });
  REQUIRE(first_in_motion != expected.rows.end());

  const auto file = (std::filesystem::temp_directory_path() / "ballonet_motion_checkpoint_test.h5").string();
  std::filesystem::remove(file);
  arch.parameters.path.max_steps = 1 + (first_in_motion - expected.rows.begin());
  arch.parameters.path.checkpoint_every = 1;
  Simulation interrupted(arch.parameters, arch.mesh, MPI_COMM_SELF);
  interrupted.set_checkpoint(file);
  REQUIRE(walk(interrupted).result.status == PathStatus::step_limit);
  arch.parameters.path.max_steps = 1000;
  Simulation resumed(arch.parameters, arch.mesh, MPI_COMM_SELF);
  REQUIRE(resumed.resume(file));
  const auto rest = walk(resumed);
  CHECK(rest.progress.step == expected.progress.step);
  CHECK(rest.progress.factorisations == expected.progress.factorisations);
  CHECK(largest_difference(rest.progress.state.displacement, expected.progress.state.displacement) < 1e-8);
  std::filesystem::remove(file);
}
