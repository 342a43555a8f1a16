// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/simulation.h"
#include "tests/support/nodal_fields.h"
#include "tests/support/run_to_end.h"
#include "tests/support/sealed_tube.h"

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

/// The sealed tube, inflated until it presses on its ring.
struct InflatedTube {
  SealedTube tube;
  std::unique_ptr<Simulation> path;
  State state;
  InflatedTube()
  {
    tube.parameters.contact_pairs[0].friction = 0;
    path = std::make_unique<Simulation>(tube.parameters, tube.mesh, MPI_COMM_SELF);
    run_to_end(*path);
    state = path->progress().state;
    REQUIRE(path->equilibrium().contacts().summaries(state)[0].points > 0);
  }
};

/// Forces at `state` moved by `fraction` of a shape, viscosity and friction left out.
std::vector<double> forces(Equilibrium &equilibrium, const State &state, const std::vector<double> &shape,
                           double fraction)
{
  const State at = moved(state, shape, fraction);
  State copy = at;
  equilibrium.release(copy); // begins a step at rest there
  return equilibrium.reactions(at);
}

double held_part(const std::vector<double> &field, const Mesh &mesh, const std::string &surface, int direction)
{
  double largest = 0;
  for (const auto node : surface_nodes(mesh, surface))
    largest = std::max(largest, std::abs(field[3 * node + direction]));
  return largest;
}

} // namespace

TEST_CASE("modes: K shape = omega^2 M shape with K from differences of the forces, supports held")
{
  InflatedTube scene;
  Equilibrium equilibrium(scene.tube.parameters, scene.tube.mesh, MPI_COMM_SELF);
  const auto modes = equilibrium.modes(scene.state, {.count = 5});
  REQUIRE(modes.size() == 5);
  const auto &discretization = equilibrium.discretization();
  std::vector<double> mass(discretization.n_nodes());
  add_nodal_mass(discretization, 0, 1e-9, mass);
  add_nodal_mass(discretization, 1, 1e-9, mass);
  for (const auto &mode : modes) {
    CHECK(held_part(mode.shape, scene.tube.mesh, "z0", 2) == 0);
    CHECK(held_part(mode.shape, scene.tube.mesh, "ring.x0", 0) == 0);
    const double h = 1e-5;
    const auto plus = forces(equilibrium, scene.state, mode.shape, h);
    const auto minus = forces(equilibrium, scene.state, mode.shape, -h);
    double miss = 0, size = 0;
    for (std::size_t i = 0; i < plus.size(); ++i) {
      if (mode.shape[i] == 0)
        continue; // held
      const double inertia = mode.omega_squared * mass[i / 3] * mode.shape[i];
      miss += std::pow((plus[i] - minus[i]) / (2 * h) - inertia, 2);
      size += inertia * inertia;
    }
    INFO("mode of " << mode.frequency() << " Hz, relative miss " << std::sqrt(miss / size));
    CHECK(std::sqrt(miss / size) < 1e-4);
  }
}

TEST_CASE("modes: ascending, mass-orthogonal, largest node moves by one; viscosity stiffens")
{
  InflatedTube scene;
  Equilibrium equilibrium(scene.tube.parameters, scene.tube.mesh, MPI_COMM_SELF);
  const auto modes = equilibrium.modes(scene.state, {.count = 6});
  std::vector<double> mass(equilibrium.discretization().n_nodes());
  add_nodal_mass(equilibrium.discretization(), 0, 1, mass);
  add_nodal_mass(equilibrium.discretization(), 1, 1, mass);
  const auto product = [&](const Mode &a, const Mode &b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.shape.size(); ++i)
      sum += mass[i / 3] * a.shape[i] * b.shape[i];
    return sum;
  };
  for (std::size_t k = 0; k < modes.size(); ++k) {
    double largest = 0;
    for (std::size_t i = 0; i < modes[k].shape.size(); i += 3)
      largest = std::max(largest, norm(std::span(modes[k].shape).subspan(i, 3)));
    CHECK(largest == Approx(1));
    if (k > 0) {
      CHECK(modes[k].omega_squared > modes[k - 1].omega_squared);
      CHECK(std::abs(product(modes[k], modes[k - 1])) <
            1e-6 * std::sqrt(product(modes[k], modes[k]) * product(modes[k - 1], modes[k - 1])));
    }
  }
  const auto stiffened = equilibrium.modes(scene.state, {.count = 1, .dt = 1e-3});
  CHECK(stiffened[0].omega_squared > 1.1 * modes[0].omega_squared);
}

TEST_CASE("modes: at held volume the shapes keep it, and none is lower than at held pressure")
{
  InflatedTube scene;
  Equilibrium equilibrium(scene.tube.parameters, scene.tube.mesh, MPI_COMM_SELF);
  const auto free = equilibrium.modes(scene.state, {.count = 4});
  const auto held = equilibrium.modes(scene.state, {.count = 4, .volume_held = true});
  double largest_change = 0;
  for (std::size_t k = 0; k < held.size(); ++k) {
    const auto change = [&](const Mode &mode) {
      return (equilibrium.volume(moved(scene.state, mode.shape, 1e-4)) -
              equilibrium.volume(moved(scene.state, mode.shape, -1e-4))) /
             2e-4;
    };
    CHECK(std::abs(change(held[k])) < 1e-5);
    largest_change = std::max(largest_change, std::abs(change(free[k])));
    CHECK(held[k].omega_squared >= free[k].omega_squared * (1 - 1e-8));
    if (k + 1 < free.size())
      CHECK(held[k].omega_squared <= free[k + 1].omega_squared * (1 + 1e-8)); // one constraint: interlaced
  }
  CHECK(largest_change > 1);
}

TEST_CASE("modes: do not disturb a path that goes on", "[mpi]")
{
  SealedTube tube;
  tube.parameters.path.rates = Rates::always; // static steps end where rounding decides about one more iteration
  const auto end_of_path = [&](bool with_modes) {
    Equilibrium equilibrium(tube.parameters, tube.mesh, MPI_COMM_WORLD);
    PathFollower follower(equilibrium, tube.parameters.path, MPI_COMM_WORLD);
    auto progress = follower.start();
    std::vector<double> frequencies;
    follower.run(
        progress,
        [&](const PathPoint &point) {
          if (with_modes)
            for (const auto &mode : equilibrium.modes(point.progress.state, {.count = 2, .volume_held = true}))
              frequencies.push_back(mode.frequency());
          return "";
        },
        [](const std::string &) {});
    return std::pair(progress, frequencies);
  };
  const auto [plain, none] = end_of_path(false);
  const auto [watched, frequencies] = end_of_path(true);
  CHECK(none.empty());
  REQUIRE(!frequencies.empty());
  CHECK(frequencies.back() > frequencies.front()); // the ring stiffens it
  CHECK(watched.step == plain.step);
  CHECK(watched.iterations == plain.iterations);
  CHECK(watched.state.pressure == Approx(plain.state.pressure).epsilon(1e-10));
}

TEST_CASE("modes: one and two ranks find the same", "[mpi]")
{
  InflatedTube scene;
  Equilibrium alone(scene.tube.parameters, scene.tube.mesh, MPI_COMM_SELF),
      together(scene.tube.parameters, scene.tube.mesh, MPI_COMM_WORLD);
  for (const bool held : {false, true}) {
    const auto a = alone.modes(scene.state, {.count = 3, .volume_held = held});
    const auto b = together.modes(scene.state, {.count = 3, .volume_held = held});
    for (int k = 0; k < 3; ++k) {
      CHECK(b[k].omega_squared == Approx(a[k].omega_squared).epsilon(1e-7));
      CHECK(std::abs(dot(a[k].shape, b[k].shape)) == Approx(dot(a[k].shape, a[k].shape)).epsilon(1e-5));
    }
  }
}

TEST_CASE("modes: without mass or without a volume to hold they are refused")
{
  SealedTube tube;
  tube.parameters.cavity.reset();
  Equilibrium open(tube.parameters, tube.mesh, MPI_COMM_SELF);
  CHECK_THROWS_WITH(open.modes(open.initial_state(), {.volume_held = true}), Catch::Contains("cavity"));
  for (auto &material : tube.parameters.materials)
    material.density = 0;
  Equilibrium massless(tube.parameters, tube.mesh, MPI_COMM_SELF);
  CHECK_THROWS_WITH(massless.modes(massless.initial_state(), {}), Catch::Contains("density"));
}
