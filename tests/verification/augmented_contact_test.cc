// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/comparison.h"
#include "tests/support/pressed_blocks.h"
#include "tests/support/reaction.h"
#include "tests/support/run_to_end.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double tolerance = 1e-3; // mm

ContactPair augmented(ContactPair pair)
{
  pair.enforcement = Enforcement::augmented_lagrangian;
  pair.augmentation_tolerance = tolerance;
  pair.max_augmentations = 50;
  return pair;
}

double mean_height(const Mesh &mesh, const State &state, const std::string &surface)
{
  double sum = 0;
  const auto nodes = surface_nodes(mesh, surface);
  for (const auto node : nodes)
    sum += mesh.nodes[node][2] + state.displacement[3 * node + 2];
  return sum / static_cast<double>(nodes.size());
}

} // namespace

// Without penetration the stack is two bars in series, whatever the stiffness of the contact. The kink of the
// displacement at the contact's depth makes the discrete one 0.4 % too stiff, as in the patch test of the penalty.
TEST_CASE("augmented contact: patch test of two pressed blocks with a soft penalty")
{
  constexpr double side = PressedBlocks::side;
  PressedBlocks blocks;
  ContactPair &pair = blocks.parameters.contact_pairs[0];
  pair.stiffness = 10; // of the penalty alone it takes 750 to keep to the tolerance
  pair = augmented(pair);
  Simulation simulation(blocks.parameters, blocks.mesh, MPI_COMM_SELF);
  run_to_end(simulation);
  const auto &state = simulation.progress().state;
  const auto &equilibrium = simulation.equilibrium();

  const auto summary = equilibrium.contacts().summaries(state)[0];
  double volume = 0, area = 0;
  const auto points = equilibrium.contacts().points(state);
  for (const auto &point : points[0])
    volume += point.area * point.penetration, area += point.area;
  const double exact = blocks.pressure([](double) { return 0; });
  const double penalty = blocks.pressure([&](double P) { return P / pair.stiffness + pair.onset / 2; });
  const char *source = "closed form: two bars in series, no penetration";
  const auto case_of = [](const char *what) { return std::string("augmented patch test: ") + what; };
  compare({case_of("mean penetration"), source, 0, volume / area, tolerance, "mm", Comparison::Kind::absolute});
  compare({case_of("mean pressure"), source, exact, -summary.primary_force[0][2] / (side * side), 1e-2, "MPa"});
  compare({case_of("pressure over that of the penalty alone"), "at least 1.3, else the case shows nothing", 1.3,
           exact / penalty, 0, "1", Comparison::Kind::at_least});
  const double below = reaction(blocks.mesh, equilibrium, state, "lower.z0")[2];
  const double above = reaction(blocks.mesh, equilibrium, state, "upper.z1")[2];
  compare({case_of("reaction over the area"), source, exact, below / (side * side), 1e-2, "MPa"});
  compare({case_of("sum of the reactions"), "equilibrium", 0, below + above, 1e-10, "N", Comparison::Kind::absolute});
}

namespace
{

/// A block of 1 mm on a rigid plane under a dead load on its top; it stands 1 um deep at rest, so that it is held.
struct LoadedBlock {
  static constexpr double modulus = 10, traction = 0.3, deep = 1e-3; // MPa, mm
  Mesh mesh = box_mesh(
      2, 2, 1,
      [](Point3 p) {
        return Point3{p[0], p[1], p[2] - deep};
      },
      "block", "");
  Parameters parameters;

  explicit LoadedBlock(double stiffness)
  {
    parameters.materials.resize(1);
    auto &m = parameters.materials[0];
    m.name = "foam", m.law = Law::saint_venant, m.youngs_modulus = modulus, m.poisson_ratio = 0;
    parameters.bodies = {{"block", "foam"}};
    parameters.supports = {{"x0", {"x"}}, {"y0", {"y"}}};
    parameters.loads = {{"z1", {0, 0, -traction}}};
    parameters.rigid_bodies.resize(1);
    parameters.rigid_bodies[0].name = "floor";
    parameters.contact_pairs = {{"pair", {"z0"}, {"floor"}, 0, 5, stiffness, 0, 2}}; // up to 2 mm deep
    parameters.path.control = Control::load;
    parameters.path.load_steps = 1;
    parameters.newton = {.tolerance = 1e-10, .force_floor = 1e-3};
  }

  double top() const
  {
    Simulation simulation(parameters, mesh, MPI_COMM_SELF);
    run_to_end(simulation);
    return mean_height(mesh, simulation.progress().state, "z1");
  }
};

} // namespace

TEST_CASE("augmented contact: a block on a rigid plane stands where it should, whatever the stiffness")
{
  const double exact = PressedBlocks::stretch(LoadedBlock::traction);
  for (const double stiffness : {0.3, 3., 30.}) {
    LoadedBlock block(stiffness);
    const std::string what = "block on a plane, " + std::to_string(stiffness).substr(0, 4) + " MPa/mm: ";
    compare({what + "top, penalty", "closed form: a bar and the contact law", exact - block.traction / stiffness,
             block.top(), 1e-6, "mm", Comparison::Kind::absolute});
    block.parameters.contact_pairs[0] = augmented(block.parameters.contact_pairs[0]);
    compare({what + "top, augmented", "closed form: a bar", exact, block.top(), tolerance, "mm",
             Comparison::Kind::absolute});
  }
}
