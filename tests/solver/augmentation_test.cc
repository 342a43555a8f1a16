// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/simulation.h"
#include "tests/support/nodal_fields.h"
#include "tests/support/pressed_blocks.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

/// Pressed blocks that slide with friction, in many steps.
struct AugmentedBlocks : PressedBlocks {
  AugmentedBlocks() : PressedBlocks(0.2)
  {
    ContactPair &pair = parameters.contact_pairs[0];
    pair.enforcement = Enforcement::augmented_lagrangian;
    pair.stiffness = 5;
    pair.friction = 0.2;
    parameters.path.load_steps = 6;
    parameters.path.checkpoint_every = 1;
  }
};

struct Followed {
  PathProgress progress;
  double largest = 0; ///< mm, mean penetration after any step
  bool shortfall = false;
};

Followed follow(Simulation &simulation)
{
  Followed followed;
  const auto observe = [&](const PathPoint &point) {
    followed.largest = std::max(followed.largest, point.newton.mean_penetration);
    followed.shortfall = followed.shortfall || !point.newton.shortfall.empty();
    return "";
  };
  simulation.run(observe, [&](const std::string &line) {
    if (line.starts_with("step") && line.find("asked for") != std::string::npos)
      CHECK_THAT(line, Catch::Contains("contact pair \"pair\"") && Catch::Contains("0.01"));
  });
  followed.progress = simulation.progress();
  return followed;
}

} // namespace

TEST_CASE("augmentation: every step keeps the tolerance, or says that it does not")
{
  AugmentedBlocks blocks;
  Simulation patient(blocks.parameters, blocks.mesh, MPI_COMM_SELF);
  const Followed kept = follow(patient);
  CHECK(kept.progress.state.load_factor == 1);
  CHECK(kept.largest < blocks.parameters.contact_pairs[0].augmentation_tolerance);
  CHECK(kept.largest > 0);
  CHECK_FALSE(kept.shortfall);

  blocks.parameters.contact_pairs[0].max_augmentations = 0;
  Simulation once(blocks.parameters, blocks.mesh, MPI_COMM_SELF);
  const Followed missed = follow(once);
  CHECK(missed.progress.state.load_factor == 1);
  CHECK(missed.largest > blocks.parameters.contact_pairs[0].augmentation_tolerance);
  CHECK(missed.shortfall);
  CHECK(missed.progress.factorisations < kept.progress.factorisations);
}

TEST_CASE("augmentation: the shifts grow to what the pressure takes, and are gone when the blocks are apart")
{
  AugmentedBlocks blocks;
  Simulation simulation(blocks.parameters, blocks.mesh, MPI_COMM_SELF);
  const State pressed = follow(simulation).progress.state;
  const ContactPair &pair = blocks.parameters.contact_pairs[0];
  const double taken = blocks.pressure([](double) { return 0; }) / pair.stiffness + pair.onset / 2;
  REQUIRE_FALSE(pressed.contact_shift.empty());
  for (const double shift : pressed.contact_shift)
    CHECK(shift == Approx(taken).margin(0.1 * taken));

  blocks.parameters.supports.back().move[2] = 0.3; // lifted
  Equilibrium equilibrium(blocks.parameters, blocks.mesh, MPI_COMM_SELF);
  State lifted = pressed;
  for (int k = 0; k < 2; ++k) // the first one ends with the shifts of its start, without contact
    REQUIRE(equilibrium.solve(lifted, {.dt = 1}, {}).converged);
  CHECK(*std::ranges::max_element(lifted.contact_shift) == 0);
}

TEST_CASE("augmentation: one and two ranks go the same way", "[mpi]")
{
  const AugmentedBlocks blocks;
  Simulation alone(blocks.parameters, blocks.mesh, MPI_COMM_SELF),
      together(blocks.parameters, blocks.mesh, MPI_COMM_WORLD);
  const Followed a = follow(alone), b = follow(together);
  CHECK(a.progress.state.load_factor == 1);
  CHECK(a.progress.step == b.progress.step);
  CHECK(a.progress.iterations == b.progress.iterations);
  CHECK(largest_difference(a.progress.state.displacement, b.progress.state.displacement) < 1e-8);
  CHECK(largest_difference(a.progress.state.contact_shift, b.progress.state.contact_shift) < 1e-8);
}

TEST_CASE("augmentation: interrupted and resumed, a path ends where the whole one ends")
{
  AugmentedBlocks blocks;
  Simulation whole(blocks.parameters, blocks.mesh, MPI_COMM_SELF);
  const PathProgress expected = follow(whole).progress;
  const auto file = (std::filesystem::temp_directory_path() / "ballonet_augmentation_test.h5").string();
  std::filesystem::remove(file);
  blocks.parameters.path.max_steps = expected.step - 3;
  Simulation interrupted(blocks.parameters, blocks.mesh, MPI_COMM_SELF);
  interrupted.set_checkpoint(file);
  const PathProgress middle = follow(interrupted).progress;
  REQUIRE(*std::ranges::max_element(middle.state.contact_shift) > 0);

  blocks.parameters.path.max_steps = 1000;
  Simulation resumed(blocks.parameters, blocks.mesh, MPI_COMM_SELF);
  REQUIRE(resumed.resume(file));
  const PathProgress actual = follow(resumed).progress;
  CHECK(actual.step == expected.step);
  CHECK(actual.iterations == expected.iterations);
  CHECK(largest_difference(actual.state.displacement, expected.state.displacement) < 1e-8);
  CHECK(largest_difference(actual.state.contact_shift, expected.state.contact_shift) < 1e-8);
  std::filesystem::remove(file);
}
