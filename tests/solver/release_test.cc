// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/simulation.h"
#include "tests/support/cantilever_beam.h"
#include "tests/support/nodal_fields.h"
#include "tests/support/sealed_tube.h"
#include <catch2/catch.hpp>
#include <filesystem>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double g = 9810; // mm/s^2

CantileverBeam falling_beam()
{
  CantileverBeam beam;
  beam.parameters.gravity = {0, 0, -g};
  beam.parameters.path.duration = 0.02;
  beam.parameters.path.step_initial = 1e-3;
  beam.parameters.path.step_max = 2e-3;
  return beam;
}

struct Fall {
  PathResult result;
  PathProgress progress;
  std::vector<double> energy; ///< after each step, N mm: kinetic, stored and that of gravity
};

Fall fall(Simulation &simulation, const CantileverBeam &beam)
{
  const auto &discretization = simulation.equilibrium().discretization();
  std::vector<double> mass(discretization.n_nodes());
  add_nodal_mass(discretization, 0, beam.density, mass);
  Fall fall;
  const auto observe = [&](const PathPoint &point) {
    const auto &state = point.progress.state;
    const auto e = simulation.equilibrium().energies(state);
    double sum = e.kinetic + e.stored;
    for (std::size_t n = 0; n < mass.size(); ++n)
      sum += mass[n] * g * state.displacement[3 * n + 2];
    fall.energy.push_back(sum);
    return std::string();
  };
  fall.result = simulation.run(observe, [](const std::string &) {});
  fall.progress = simulation.progress();
  return fall;
}

} // namespace

TEST_CASE("release: a body at rest starts with the acceleration of gravity where nothing holds it")
{
  const auto beam = falling_beam();
  Equilibrium equilibrium(beam.parameters, beam.mesh, MPI_COMM_SELF);
  State state = equilibrium.initial_state();
  equilibrium.release(state);
  for (std::size_t n = 0; n < beam.mesh.nodes.size(); ++n)
    CHECK(state.acceleration[3 * n + 2] == Approx(beam.mesh.nodes[n][0] == 0 ? 0 : -g));
  CHECK(norm(state.velocity) == 0);
}

TEST_CASE("release: ends at path.duration, swings without a preload, and keeps its energy at spectral radius 1")
{
  auto beam = falling_beam();
  beam.parameters.path.spectral_radius = 1;
  Simulation simulation(beam.parameters, beam.mesh, MPI_COMM_SELF);
  const auto end = fall(simulation, beam);
  INFO(end.result.reason);
  CHECK(end.result.status == PathStatus::ended);
  CHECK(end.progress.state.time == Approx(0.02).epsilon(1e-12));
  CHECK(end.progress.state.load_factor == 1);
  const double fallen = *std::max_element(end.energy.begin(), end.energy.end());
  INFO("largest energy " << fallen << " N mm, kinetic at the end "
                         << simulation.equilibrium().energies(end.progress.state).kinetic);
  const double scale = simulation.equilibrium().energies(end.progress.state).stored;
  CHECK(scale > 0);
  for (const double energy : end.energy)
    CHECK(std::abs(energy) < 2e-2 * scale);
}

TEST_CASE("release: backward Euler when asked for loses energy")
{
  auto beam = falling_beam();
  beam.parameters.path.integrator = Integrator::backward_euler;
  Simulation simulation(beam.parameters, beam.mesh, MPI_COMM_SELF);
  const auto end = fall(simulation, beam);
  CHECK(end.energy.back() < -0.1 * simulation.equilibrium().energies(end.progress.state).stored);
}

TEST_CASE("release: interrupted and resumed, it ends where the whole one ends")
{
  auto beam = falling_beam();
  Simulation whole(beam.parameters, beam.mesh, MPI_COMM_SELF);
  const auto expected = fall(whole, beam);
  const auto file = (std::filesystem::temp_directory_path() / "ballonet_release_test.h5").string();
  std::filesystem::remove(file);
  beam.parameters.path.max_steps = expected.progress.step - 4;
  beam.parameters.path.checkpoint_every = 1;
  Simulation interrupted(beam.parameters, beam.mesh, MPI_COMM_SELF);
  interrupted.set_checkpoint(file);
  REQUIRE(fall(interrupted, beam).result.status == PathStatus::step_limit);
  beam.parameters.path.max_steps = 1000;
  Simulation resumed(beam.parameters, beam.mesh, MPI_COMM_SELF);
  REQUIRE(resumed.resume(file));
  const auto actual = fall(resumed, beam);
  std::filesystem::remove(file);
  CHECK(actual.progress.step == expected.progress.step);
  for (std::size_t i = 0; i < actual.progress.state.displacement.size(); ++i) {
    CHECK(actual.progress.state.displacement[i] == Approx(expected.progress.state.displacement[i]).margin(1e-9));
    CHECK(actual.progress.state.acceleration[i] == Approx(expected.progress.state.acceleration[i]).margin(1e-3));
  }
}

TEST_CASE("release: with a cavity the pressure acts from the first instant and is held")
{
  SealedTube tube;
  tube.parameters.path.control = Control::release;
  tube.parameters.path.initial_pressure = 0.01;
  tube.parameters.path.step_initial = 1e-4;
  tube.parameters.path.step_max = 5e-4;
  tube.parameters.path.duration = 3e-3;
  Simulation simulation(tube.parameters, tube.mesh, MPI_COMM_SELF);
  std::vector<double> volumes;
  const auto result = simulation.run(
      [&](const PathPoint &point) {
        CHECK(point.progress.state.pressure == 0.01);
        volumes.push_back(point.progress.volume / point.reference_volume);
        return "";
      },
      [](const std::string &) {});
  INFO(result.reason);
  CHECK(result.status == PathStatus::ended);
  CHECK(volumes.front() > 1);
  CHECK(volumes.back() > volumes.front());
}

TEST_CASE("release: what cannot be let go is refused")
{
  const auto run = [](const CantileverBeam &beam) { Simulation(beam.parameters, beam.mesh, MPI_COMM_SELF); };
  auto beam = falling_beam();
  beam.parameters.path.inertia = false;
  CHECK_THROWS_WITH(run(beam), Catch::Contains("path.inertia"));
  beam = falling_beam();
  beam.parameters.materials[0].density = 0;
  CHECK_THROWS_WITH(run(beam), Catch::Contains("density"));
  beam = falling_beam();
  beam.parameters.supports.push_back({"x1", {}, {{1., {}, {}}}});
  CHECK_THROWS_WITH(run(beam), Catch::Contains("support"));
}
