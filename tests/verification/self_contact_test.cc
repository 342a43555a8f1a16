// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/box_mesh.h"
#include "tests/support/comparison.h"
#include "tests/support/reaction.h"
#include "tests/support/run_to_end.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double arm = 4, bend = 0.4, wall = 0.3, width = 0.3;  // mm
constexpr double stiffness = 60, onset = 0.02, pressure = 0.04; // MPa/mm, mm, MPa

/// A strip along a midline: from the clamped end at x = arm, y = bend straight to x = 0, around a half circle to y =
/// -bend and straight back. `share` 1: all of it; 1/2: up to the plane of symmetry y = 0. Side y0 is the inner one.
Mesh fold(double share, int cells)
{
  const double half = arm + M_PI / 2 * bend;
  return box_mesh(
      cells, 1, 1,
      [=](Point3 p) {
        const double s = 2 * half * share * p[0], r = wall * (p[1] - 0.5), z = -width * p[2];
        if (s <= arm)
          return Point3{arm - s, bend + r, z};
        if (s >= 2 * half - arm)
          return Point3{s - (2 * half - arm), -bend - r, z};
        const double angle = M_PI / 2 + (s - arm) / bend;
        return Point3{(bend + r) * std::cos(angle), (bend + r) * std::sin(angle), z};
      },
      "fold", "fold.");
}

Parameters squeezed()
{
  Parameters p;
  p.materials.resize(1);
  auto &m = p.materials[0];
  m.name = "rubber", m.law = Law::saint_venant, m.youngs_modulus = 10, m.poisson_ratio = 0.3;
  p.bodies = {{"fold", "rubber"}};
  p.supports = {{"fold.x0", {"x", "y", "z"}}, {"fold.z0", {"z"}}, {"fold.z1", {"z"}}};
  p.loads = {{"fold.y1", {0, 0, 0}, pressure}};
  p.path.control = Control::load;
  p.path.load_steps = 5;
  p.newton = {.tolerance = 1e-9, .force_floor = 1e-2};
  return p;
}

/// All of the strip, its inner side in contact with itself.
Parameters touching_itself()
{
  Parameters p = squeezed();
  p.supports.push_back({"fold.x1", {"x", "y", "z"}});
  p.contact_pairs = {{"pair", {"fold.y0"}, {"fold.y0"}, 0, 0.1, stiffness, onset}};
  return p;
}

/// Half of it on a rigid plane in the middle, which has half the penetration under the same pressure.
Parameters on_plane()
{
  Parameters p = squeezed();
  p.supports.push_back({"fold.x1", {"y"}});
  p.rigid_bodies.resize(1);
  p.rigid_bodies[0].name = "middle", p.rigid_bodies[0].axis = {0, 1, 0};
  p.contact_pairs = {{"pair", {"fold.y0"}, {"middle"}, 0, 0.1, 2 * stiffness, onset / 2}};
  return p;
}

struct Closed {
  ContactSummary contact;
  Vector3 reaction = {}; ///< N, of the clamped end above
};

Closed close(const Mesh &mesh, const Parameters &parameters)
{
  Simulation simulation(parameters, mesh, MPI_COMM_SELF);
  run_to_end(simulation);
  const auto &state = simulation.progress().state;
  Closed closed;
  closed.contact = simulation.equilibrium().contacts().summaries(state)[0];
  closed.reaction = reaction(mesh, simulation.equilibrium(), state, "fold.x0");
  return closed;
}

} // namespace

// A U-shaped strip, both ends clamped, is pressed shut by a follower pressure from outside: its arms meet. By symmetry
// each arm does what half the strip does on a rigid plane in the middle. The contact of two bodies acts at the depth
// `thickness` in one of them, hence the tolerance.
TEST_CASE("self-contact: a fold that closes on itself does what its half does on a rigid plane")
{
  const auto whole = close(fold(1, 24), touching_itself()), half = close(fold(0.5, 12), on_plane());
  const char *source = "symmetry: half of it on a rigid plane";
  REQUIRE(half.contact.normal_force > 0.01);
  compare({"fold closing on itself: contact force", source, half.contact.normal_force, whole.contact.normal_force, 2e-3,
           "N"});
  compare({"fold closing on itself: area in contact", source, half.contact.area, whole.contact.area, 2e-2, "mm^2"});
  compare({"fold closing on itself: penetration", source, 2 * half.contact.penetration, whole.contact.penetration, 2e-2,
           "mm"});
  compare(
      {"fold closing on itself: reaction of the clamped end", source, half.reaction[1], whole.reaction[1], 2e-3, "N"});
  const auto &force = whole.contact.secondary_force, &back = whole.contact.primary_force[0];
  compare({"fold closing on itself: sum of its contact forces", "action and reaction", 0,
           std::hypot(force[0] + back[0], force[1] + back[1], force[2] + back[2]), 1e-10, "N",
           Comparison::Kind::absolute});
}
