// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/box_mesh.h"
#include "tests/support/comparison.h"
#include "tests/verification/staged_assembly.h"
#include <catch2/catch.hpp>
#include <cmath>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double radius = 10, thickness = 0.1, width = 1, lead = 4, overlap = 2e-3;   // mm
constexpr double friction = 0.3, wrap = M_PI / 2, tension = 0.1, elastic_slip = 1e-4; // N, mm

/// A point at the distance `s` (mm) along the belt's inner side from its lower end, `out` outside of it: up along a
/// straight lead, a quarter around the drum's axis y, and on along -x.
Point3 on_belt(double s, double y, double out)
{
  const double r = radius - overlap + out, arc = radius * wrap;
  if (s < lead)
    return {r, y, s - lead};
  if (s > lead + arc)
    return {-(s - lead - arc), y, r};
  const double angle = (s - lead) / radius;
  return {r * std::cos(angle), y, r * std::sin(angle)};
}

/// The belt rests without stress on a drum of which a ring from -30 to 120 degrees is there.
Mesh belt_on_drum()
{
  constexpr int in_lead = 4, around = 16;
  const auto belt = [](Point3 p) {
    const double cells = p[0] * (2 * in_lead + around);
    const double s = cells < in_lead            ? lead * cells / in_lead
                     : cells < in_lead + around ? lead + radius * wrap * (cells - in_lead) / around
                                                : lead + radius * wrap + lead * (cells - in_lead - around) / in_lead;
    return on_belt(s, width * (1 - p[1]), thickness * p[2]);
  };
  const auto drum = [](Point3 p) {
    const double angle = (p[0] * 150 - 30) * M_PI / 180, r = radius - 2 * (1 - p[2]);
    return Point3{r * std::cos(angle), width * (1.25 - 1.5 * p[1]), r * std::sin(angle)};
  };
  return beside(box_mesh(2 * in_lead + around, 1, 1, belt, "belt", "belt."), box_mesh(18, 1, 1, drum, "drum", "drum."));
}

Parameters wrapped()
{
  Parameters p;
  p.materials.resize(2);
  auto &strip = p.materials[0], &steel = p.materials[1];
  strip.name = "strip", strip.law = Law::saint_venant, strip.youngs_modulus = 500, strip.poisson_ratio = 0;
  steel.name = "steel", steel.law = Law::saint_venant, steel.youngs_modulus = 2e5, steel.poisson_ratio = 0;
  p.bodies = {{"belt", "strip"}, {"drum", "steel"}};
  p.supports = {{"drum.z0", {"x", "y", "z"}}, {"belt.y0", {"y"}}, {"belt.y1", {"y"}}, {"belt.x1", {}, {{0, {}, {}}}}};
  p.loads = {{"belt.x0", {0, 0, 0}, 0}};
  p.contact_pairs = {{"pair", {"belt.z0"}, {"drum.z1"}, friction, 0.3, 20, 2e-3}};
  p.contact_pairs[0].elastic_slip = elastic_slip;
  p.newton = {.tolerance = 1e-8, .force_floor = 1e-2};
  return p;
}

} // namespace

// The slack end carries a dead load, the other one is pulled by 100 times the elastic slip a step until all of the
// belt slides. The belt's thickness lets friction act at radius R where the tension acts at R + h / 2 (0.5 %), and its
// bending stiffness carries a share of about E I / (T R^2) = 4e-3 of what it is wound around.
TEST_CASE("belt: the pulled end of a sliding belt carries exp(mu phi) times the slack end's tension")
{
  const auto mesh = belt_on_drum();
  StagedAssembly assembly(mesh, wrapped());
  for (const double share : {0.1, 0.3, 0.6, 1.}) {
    assembly.parameters.loads[0].traction = {0, 0, -share * tension / (thickness * width)};
    assembly.step(1);
  }
  for (int i = 1; i <= 16; ++i) {
    assembly.parameters.supports[3].move[0] = -i * 100 * elastic_slip;
    assembly.step(0.1);
  }
  const double pulled = -assembly.force_on("belt.x1")[0];
  compare({"belt around a quarter of a drum, friction 0.3: tight over slack tension",
           "Euler and Eytelwein, exp(mu phi)", std::exp(friction * wrap), pulled / tension, 1e-2});
}
