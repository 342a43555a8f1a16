// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/box_mesh.h"
#include "tests/support/comparison.h"
#include "tests/verification/staged_assembly.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double width = 4, block_height = 1, friction = 0.3, pressure = 0.05, slip_velocity = 0.01; // mm, MPa, mm/s
constexpr double normal_force = pressure * width * width, limit = friction * normal_force;           // N
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
  double force_tolerance, creep_tolerance;
};
constexpr Ground grounds[] = {{"plate.z1", 1, "", 2e-4, 1e-4},
                              {"plate.z1", 2, ", two passes", 2e-3, 1e-3},
                              {"floor", 1, ", rigid plane", 2e-4, 1e-4}};

Parameters pressed(const Ground &ground)
{
  Parameters p;
  p.materials.resize(2);
  auto &rubber = p.materials[0], &steel = p.materials[1];
  rubber.name = "rubber", rubber.c10 = 0.2, rubber.d1 = 0.5;
  steel.name = "steel", steel.law = Law::saint_venant, steel.youngs_modulus = 2e4, steel.poisson_ratio = 0.3;
  p.bodies = {{"block", "rubber"}, {"plate", "steel"}};
  p.supports = {{"plate.z0", {"x", "y", "z"}}, {"block.z1", {"y"}, {{0, {}, {}}}}};
  p.loads = {{"block.z1", {0, 0, -pressure}, 0}};
  p.contact_pairs = {{"pair", {"block.z0"}, {ground.surface}, friction, 0.3, 20, 0.02}};
  p.contact_pairs[0].slip_velocity = slip_velocity;
  p.contact_pairs[0].passes = ground.passes;
  p.rigid_bodies.resize(1);
  p.rigid_bodies[0].name = "floor"; // the plane z = 0
  p.newton = {.tolerance = 1e-10, .force_floor = 1e-2};
  return p;
}

/// The tangential force on the ground along the block's motion, N.
double drag(const StagedAssembly &assembly)
{
  return assembly.equilibrium().contact(assembly.state)[0].primary_force[0][0];
}

} // namespace

// Pressed by a dead pressure and pulled along at v = 100 times the slip velocity v_s of the regularised law
//   T = mu N v / sqrt(v^2 + v_s^2),  here 5e-5 below Coulomb's limit.
TEST_CASE("friction: a sliding block is held back by mu N")
{
  const auto mesh = block_on_plate();
  for (const Ground &ground : grounds) {
    StagedAssembly assembly(mesh, pressed(ground));
    for (int i = 0; i < 3; ++i)
      assembly.step(1);
    const double speed = 100 * slip_velocity, dt = 0.25;
    for (int i = 1; i <= 10; ++i) {
      assembly.parameters.supports[1].move[0] = i * speed * dt;
      assembly.step(dt);
    }
    const auto contact = assembly.equilibrium().contact(assembly.state)[0];
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

// Below the limit the regularised law lets the block creep at v_s r / sqrt(1 - r^2), r = T / (mu N): slow beside every
// motion of interest when v_s is. The steps are long against the relaxation time of the block on its sticking contact,
// (height / shear modulus) mu p / v_s = 4 s.
TEST_CASE("friction: a block pulled by less than mu N sticks")
{
  const auto mesh = block_on_plate();
  for (const Ground &ground : grounds) {
    StagedAssembly assembly(mesh, pressed(ground));
    for (int i = 0; i < 3; ++i)
      assembly.step(1);
    const double share = 0.5, dt = 5;
    assembly.parameters.supports[1] = {"block.z1", {"y"}};
    assembly.parameters.loads[0].traction[0] = share * limit / (width * width);
    for (int i = 0; i < 8; ++i)
      assembly.step(dt);
    const double before = assembly.displacement_of("block.z0")[0];
    assembly.step(dt);
    const double creep = (assembly.displacement_of("block.z0")[0] - before) / dt;
    const std::string name = ground.name;
    compare({"friction: drag on a block pulled by mu N / 2" + name, "equilibrium", share * limit, drag(assembly), 1e-6,
             "N"});
    compare({"friction: creep of that block, slip velocity 0.01 mm/s" + name, "regularised Coulomb law in closed form",
             slip_velocity * share / std::sqrt(1 - share * share), creep, ground.creep_tolerance, "mm/s"});
  }
}
