// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/box_mesh.h"
#include "tests/support/comparison.h"
#include "tests/verification/staged_assembly.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double width = 4, block_height = 1, friction = 0.3, pressure = 0.05, elastic_slip = 2.5e-3; // mm, MPa
constexpr double normal_force = pressure * width * width, limit = friction * normal_force;            // N
constexpr double touching = 0.01; // mm, penetration at the start: the block has no other support in z

/// A rubber block on a stiff plate twice as long and wider, meshes not matching.
Mesh block_on_plate()
{
  const auto block = [](Point3 p) {
    return Point3{1 + width * p[0], 1 + width * p[1], block_height * p[2] - touching};
  };
  const auto plate = [](Point3 p) { return Point3{2 * width * p[0], (width + 2) * p[1], p[2] - 1}; };
  return beside(box_mesh(3, 2, 1, block, "block", "block."), box_mesh(5, 3, 1, plate, "plate", "plate."));
}

/// What the block lies on, with tolerances. With two passes points of the plate up to sqrt(2 d g) = 0.09 mm beyond the
/// block's rim feel it, at an angle: 2 % of the width on each side.
struct Ground {
  const char *surface;
  int passes;
  const char *name;
  double force_tolerance;
};
constexpr Ground grounds[] = {
    {"plate.z1", 1, "", 2e-4}, {"plate.z1", 2, ", two passes", 2e-3}, {"floor", 1, ", rigid plane", 2e-4}};

Parameters pressed(const Ground &ground, double c10 = 0.2)
{
  Parameters p;
  p.materials.resize(2);
  auto &rubber = p.materials[0], &steel = p.materials[1];
  rubber.name = "rubber", rubber.c10 = c10, rubber.d1 = 0.1 / c10;
  steel.name = "steel", steel.law = Law::saint_venant, steel.youngs_modulus = 2e4, steel.poisson_ratio = 0.3;
  p.bodies = {{"block", "rubber"}, {"plate", "steel"}};
  p.supports = {{"plate.z0", {"x", "y", "z"}}, {"block.z1", {"y"}, {{0, {}, {}}}}};
  p.loads = {{"block.z1", {0, 0, -pressure}, 0}};
  p.contact_pairs = {{"pair", {"block.z0"}, {ground.surface}, friction, 0.3, 20, 0.02}};
  p.contact_pairs[0].elastic_slip = elastic_slip;
  p.contact_pairs[0].passes = ground.passes;
  p.rigid_bodies.resize(1);
  p.rigid_bodies[0].name = "floor"; // the plane z = 0
  p.newton = {.tolerance = 1e-10, .force_floor = 1e-2};
  return p;
}

/// The tangential force on the ground along the block's motion, N.
double drag(const StagedAssembly &assembly)
{
  return assembly.equilibrium().contacts().summaries(assembly.state)[0].primary_force[0][0];
}

} // namespace

// Pressed by a dead pressure and pulled along by 0.25 mm a step, ten times the elastic slip s = 0.0025 mm. Friction
// remembered from the steps before (at most 0.995 of the limit) brings the slip that counts to 0.275 mm,
//   T = mu N e / sqrt(e^2 + s^2),  here 4e-5 below Coulomb's limit.
TEST_CASE("friction: a sliding block is held back by mu N")
{
  const auto mesh = block_on_plate();
  for (const Ground &ground : grounds) {
    StagedAssembly assembly(mesh, pressed(ground));
    for (int i = 0; i < 3; ++i)
      assembly.step(1);
    for (int i = 1; i <= 10; ++i) {
      assembly.parameters.supports[1].move[0] = 0.25 * i;
      assembly.step(0.25);
    }
    const auto contact = assembly.equilibrium().contacts().summaries(assembly.state)[0];
    const std::string name = ground.name;
    const char *coulomb = "Coulomb's law, mu N";
    compare({"friction: normal force under a block" + name, "equilibrium", normal_force, contact.secondary_force[2],
             1e-6, "N"});
    compare({"friction: drag on the block after 2.5 mm of sliding" + name, coulomb, limit, drag(assembly),
             ground.force_tolerance, "N"});
    compare({"friction: force that pulls the block" + name, coulomb, limit, assembly.force_on("block.z1")[0],
             ground.force_tolerance, "N"});
  }
}

// Below the limit the block sticks for ever, and comes back when it is let go. It is stiff, so that all of it slips
// alike.
TEST_CASE("friction: a block pulled by less than mu N sticks")
{
  const auto mesh = block_on_plate();
  for (const Ground &ground : grounds) {
    StagedAssembly assembly(mesh, pressed(ground, 50));
    for (int i = 0; i < 3; ++i)
      assembly.step(1);
    const double share = 0.5, rest = assembly.displacement_of("block.z0")[0];
    const auto pull = [&](double traction) {
      assembly.parameters.loads[0].traction[0] = traction;
      assembly.step(5);
      return assembly.displacement_of("block.z0")[0] - rest;
    };
    assembly.parameters.supports[1] = {"block.z1", {"y"}};
    const double pulled = pull(share * limit / (width * width));
    double later = 0;
    for (int i = 0; i < 8; ++i)
      later = pull(share * limit / (width * width));
    const std::string name = ground.name;
    const auto kind = Comparison::Kind::absolute;
    compare({"friction: drag on a block pulled by mu N / 2" + name, "equilibrium", share * limit, drag(assembly), 1e-6,
             "N"});
    compare({"friction: slip of that block against the elastic slip" + name, "law of friction, r / sqrt(1 - r^2)",
             share / std::sqrt(1 - share * share), pulled / elastic_slip, 0.02, "1", kind});
    compare({"friction: creep of that block over 40 s" + name, "it sticks", 0, later - pulled, 1e-6, "mm", kind});
    compare({"friction: where it is when let go" + name, "it has stuck", 0, pull(0), 1e-4, "mm", kind});
  }
}
