// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/simulation.h"
#include "tests/support/contact_scene.h"
#include "tests/support/sealed_tube.h"
#include <catch2/catch.hpp>
#include <filesystem>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

struct Followed {
  PathResult result;
  std::vector<std::string> log;
  std::vector<std::vector<double>> residuals; ///< of each step
  PathProgress progress;
};

Followed follow(Simulation &simulation)
{
  Followed followed;
  followed.result = simulation.run(
      [&](const PathPoint &point) {
        followed.residuals.push_back(point.newton.residuals);
        return std::string();
      },
      [&](const std::string &line) { followed.log.push_back(line); });
  followed.progress = simulation.progress();
  return followed;
}

/// A thin bar above the middle of a coarse plate, driven down through it between the contact points of one pass.
struct BarThroughPlate {
  Mesh mesh;
  Parameters parameters;
  BarThroughPlate()
  {
    add_block(mesh, "bar", {1, 1, 2}, [](auto p) {
      return std::array<double, 3>{2.95 + 0.1 * p[0], 2.95 + 0.1 * p[1], 0.5 + 4 * p[2]};
    });
    add_block(mesh, "plate", {2, 2, 1}, [](auto p) { return std::array<double, 3>{6 * p[0], 6 * p[1], 0.4 * p[2]}; });
    parameters.materials.resize(1);
    auto &m = parameters.materials[0];
    m.name = "plastic", m.law = Law::saint_venant, m.youngs_modulus = 100, m.poisson_ratio = 0.3;
    parameters.bodies = {{"bar", "plastic"}, {"plate", "plastic"}};
    parameters.supports = {{"bar.z1", {"x", "y"}, {{{}, {}, -2.}}}, {"plate.x0", {"x", "y", "z"}}};
    parameters.contact_pairs = {{"bar in plate", {"plate.z1"}, all_sides("bar"), 0}};
    parameters.contact_pairs[0].passes = 1;
    parameters.path.control = Control::load;
  }
};

} // namespace

TEST_CASE("path: a body that passes through another one between the contact points is stopped, with the reason")
{
  const BarThroughPlate scene;
  Simulation simulation(scene.parameters, scene.mesh, MPI_COMM_SELF);
  const auto followed = follow(simulation);
  INFO(followed.result.reason);
  CHECK(followed.result.status == PathStatus::diverged);
  CHECK_THAT(followed.result.reason, Catch::Contains("inside or beyond body \"plate\""));
  CHECK(followed.progress.cuts > 0);
  const double end = 0.5 - 2 * followed.progress.state.load_factor; // height of the bar's end, plate from 0 to 0.4 mm
  INFO("stopped at height " << end);
  CHECK(end > 0.4 - scene.parameters.contact_pairs[0].penetration_limit - 0.05); // the bar's edges count as rounded
  CHECK(end < 0.4);
}

TEST_CASE("path: one that hardly gets on is ended by path.max_setbacks, long before the smallest step")
{
  BarThroughPlate scene;
  scene.parameters.path.max_setbacks = 1000;
  Simulation patient(scene.parameters, scene.mesh, MPI_COMM_SELF);
  const auto crept = follow(patient);
  CHECK_THAT(crept.result.reason, Catch::Contains("smaller than allowed"));
  scene.parameters.path.max_setbacks = 4;
  Simulation impatient(scene.parameters, scene.mesh, MPI_COMM_SELF);
  const auto ended = follow(impatient);
  CHECK(ended.result.status == PathStatus::diverged);
  CHECK_THAT(ended.result.reason, Catch::Contains("standstill") && Catch::Contains("inside or beyond"));
  CHECK(2 * ended.progress.cuts <= 4 + ended.progress.step + 2);
  CHECK(ended.progress.cuts < crept.progress.cuts - 5);
}

TEST_CASE("path: too deep a penetration is refused, with the reason")
{
  Mesh mesh;
  add_block(mesh, "lower", {1, 1, 1}, [](auto p) { return std::array<double, 3>{p[0], p[1], p[2]}; });
  add_block(mesh, "upper", {1, 1, 1}, [](auto p) { return std::array<double, 3>{p[0], p[1], 1.1 + p[2]}; });
  BarThroughPlate scene;
  auto &parameters = scene.parameters;
  parameters.bodies = {{"lower", "plastic"}, {"upper", "plastic"}};
  parameters.supports = {{"lower.z0", {"x", "y", "z"}}, {"upper.z1", {"x", "y"}, {{{}, {}, -0.4}}}};
  parameters.contact_pairs = {{"blocks", {"upper.z0"}, {"lower.z1"}, 0}};
  parameters.contact_pairs[0].penetration_limit = 0.05;
  Simulation simulation(parameters, mesh, MPI_COMM_SELF);
  const auto followed = follow(simulation);
  INFO(followed.result.reason);
  CHECK(followed.result.status == PathStatus::diverged);
  CHECK_THAT(followed.result.reason, Catch::Contains("\"blocks\" penetrates by") || Catch::Contains("lie inside"));
  CHECK(followed.progress.state.load_factor > 0.25); // 0.1 mm until they meet
  CHECK(followed.progress.state.load_factor < 1);
}

TEST_CASE("path: step limit, time limit and the observer end it")
{
  SealedTube tube;
  tube.parameters.path.max_steps = 6;
  Simulation limited(tube.parameters, tube.mesh, MPI_COMM_SELF);
  CHECK(follow(limited).result.status == PathStatus::step_limit);
  tube.parameters.path.time_limit = 0;
  Simulation late(tube.parameters, tube.mesh, MPI_COMM_SELF);
  CHECK(follow(late).result.status == PathStatus::time_limit);
  tube.parameters.path.time_limit = infinity;
  Simulation watched(tube.parameters, tube.mesh, MPI_COMM_SELF);
  const auto result = watched.run([](const PathPoint &) { return std::string("enough"); }, [](const std::string &) {});
  CHECK(result.status == PathStatus::ended);
  CHECK(result.reason == "enough");
  CHECK(watched.progress().step == 1);
}

TEST_CASE("path: inconsistent input is refused")
{
  SealedTube tube;
  tube.parameters.cavity.reset();
  CHECK_THROWS_WITH(Simulation(tube.parameters, tube.mesh, MPI_COMM_SELF), Catch::Contains("cavity"));
  tube.parameters.supports[0].surface = "nowhere";
  tube.parameters.path.control = Control::load;
  const auto build_and_run = [&] {
    Simulation simulation(tube.parameters, tube.mesh, MPI_COMM_SELF);
    follow(simulation);
  };
  CHECK_THROWS_WITH(build_and_run(), Catch::Contains("nowhere"));
}

TEST_CASE("path: one and two ranks go the same way", "[mpi]")
{
  const SealedTube tube;
  Simulation alone(tube.parameters, tube.mesh, MPI_COMM_SELF), together(tube.parameters, tube.mesh, MPI_COMM_WORLD);
  const auto a = follow(alone), b = follow(together);
  INFO(a.result.reason << " / " << b.result.reason);
  REQUIRE(a.result.status == PathStatus::ended);
  REQUIRE(b.result.status == PathStatus::ended);
  CHECK(a.progress.step == b.progress.step);
  const double difference = largest_difference(a.progress.state.displacement, b.progress.state.displacement);
  INFO("displacements differ by " << difference << " mm, pressures " << a.progress.state.pressure << " and "
                                  << b.progress.state.pressure);
  CHECK(difference < 1e-8);
  CHECK(b.progress.state.pressure == Approx(a.progress.state.pressure).epsilon(1e-8));
  const auto contact = alone.equilibrium().contacts().summaries(a.progress.state);
  INFO("contact points " << contact[0].points);
  CHECK(contact[0].points > 0); // the case has contact at its end
  CHECK(together.equilibrium().contacts().summaries(b.progress.state)[0].points == contact[0].points);
}

TEST_CASE("path: interrupted and resumed, it ends where the whole one ends")
{
  SealedTube tube;
  Simulation whole(tube.parameters, tube.mesh, MPI_COMM_SELF);
  const auto expected = follow(whole);
  REQUIRE(expected.result.status == PathStatus::ended);

  const auto file = (std::filesystem::temp_directory_path() / "ballonet_checkpoint_test.h5").string();
  std::filesystem::remove(file);
  tube.parameters.path.max_steps = expected.progress.step - 3;
  tube.parameters.path.checkpoint_every = 1;
  Simulation interrupted(tube.parameters, tube.mesh, MPI_COMM_SELF);
  CHECK_FALSE(interrupted.resume(file));
  interrupted.set_checkpoint(file);
  REQUIRE(follow(interrupted).result.status == PathStatus::step_limit);

  tube.parameters.path.max_steps = 1000;
  Simulation resumed(tube.parameters, tube.mesh, MPI_COMM_SELF);
  REQUIRE(resumed.resume(file));
  const auto actual = follow(resumed);
  CHECK(actual.progress.step == expected.progress.step);
  const double difference =
      largest_difference(actual.progress.state.displacement, expected.progress.state.displacement);
  INFO("displacements differ by " << difference << " mm");
  CHECK(difference < 1e-8);
  CHECK(actual.progress.state.pressure == Approx(expected.progress.state.pressure).epsilon(1e-8));
  CHECK(actual.progress.iterations == expected.progress.iterations);

  const auto other = box_mesh(1, 1, 1);
  auto parameters = BarThroughPlate().parameters;
  parameters.bodies = {{"body", "plastic"}};
  parameters.supports = {{"x0", {"x", "y", "z"}}};
  parameters.contact_pairs = {};
  Simulation stranger(parameters, other, MPI_COMM_SELF);
  CHECK_THROWS_WITH(stranger.resume(file), Catch::Contains("another mesh"));
  std::filesystem::remove(file);
}
