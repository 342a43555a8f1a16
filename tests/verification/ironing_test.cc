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

constexpr double way = 2.5, indentation = 0.3; // mm
constexpr int steps = 10;

/// A soft slab, symmetric about x = 0, and a harder block on it whose middle stands at x = -way / 2.
Mesh block_on_slab()
{
  const auto slab = [](Point3 p) { return Point3{6 * (p[0] - 0.5), 2 * p[1], p[2] - 1}; };
  const auto block = [](Point3 p) { return Point3{1.2 * (p[0] - 0.5) - way / 2, 0.4 + 1.2 * p[1], 0.8 * p[2]}; };
  return beside(box_mesh(9, 2, 1, slab, "slab", "slab."), box_mesh(2, 2, 1, block, "block", "block."));
}

Parameters frictionless()
{
  Parameters p;
  p.materials.resize(2);
  p.materials[0].name = "soft", p.materials[0].c10 = 0.1, p.materials[0].d1 = 2;
  p.materials[1].name = "hard", p.materials[1].c10 = 1, p.materials[1].d1 = 0.2;
  p.bodies = {{"slab", "soft"}, {"block", "hard"}};
  p.supports = {{"slab.z0", {"x", "y", "z"}}, {"block.z1", {}, {{0, 0, 0}}}};
  p.contact_pairs = {
      {"pair", {"block.z0", "block.x0", "block.x1", "block.y0", "block.y1"}, {"slab.z1"}, 0, 0.35, 10, 0.2}};
  p.newton = {.tolerance = 1e-10, .force_floor = 1e-2};
  return p;
}

/// Largest distance between the displacement of a node on the slab's upper side and the mirror image of that of its
/// mirror node in another state, mm.
double distance_from_mirror(const Mesh &mesh, const State &state, const State &other)
{
  const auto nodes = surface_nodes(mesh, "slab.z1");
  double largest = 0;
  std::size_t pairs = 0;
  for (const auto a : nodes)
    for (const auto b : nodes) {
      const auto &X = mesh.nodes[a], &Y = mesh.nodes[b];
      if (std::hypot(X[0] + Y[0], X[1] - Y[1]) > 1e-9)
        continue;
      ++pairs;
      const double *u = &state.displacement[3 * a], *v = &other.displacement[3 * b];
      largest = std::max(largest, std::hypot(u[0] + v[0], u[1] - v[1], u[2] - v[2]));
    }
  REQUIRE(pairs == nodes.size());
  return largest;
}

} // namespace

// A block pressed 0.3 mm deep into a slab of 1 mm slides over it by twice its own width without friction, from x =
// -1.25 to 1.25 mm: what it reaches must mirror what it started from. On the way only the discretisation makes a
// lateral force, as cell after cell of the slab comes into contact.
TEST_CASE("ironing: a frictionless slide ends in the mirror image of its start")
{
  const auto mesh = block_on_slab();
  StagedAssembly assembly(mesh, frictionless());
  for (int i = 1; i <= 3; ++i) {
    assembly.parameters.supports[1].move[2] = -indentation * i / 3;
    assembly.step(1);
  }
  const auto start = assembly.state;
  const auto force = assembly.force_on("slab.z0");
  const double energy = assembly.equilibrium().energies(start).stored;
  double lateral = 0;
  for (int i = 1; i <= steps; ++i) {
    assembly.parameters.supports[1].move[0] = way * i / steps;
    assembly.step(1);
    const auto present = assembly.force_on("slab.z0");
    lateral = std::max(lateral, std::abs(present[0] / present[2]));
  }
  const auto end = assembly.force_on("slab.z0");
  const char *source = "symmetry";
  const auto kind = Comparison::Kind::absolute;
  compare({"ironing: normal force at the end", source, force[2], end[2], 1e-8, "N"});
  compare({"ironing: lateral force at the end", source, -force[0], end[0], 1e-8, "N", kind});
  compare({"ironing: stored energy at the end", source, energy, assembly.equilibrium().energies(assembly.state).stored,
           1e-8, "N mm"});
  compare({"ironing: distance of the slab's surface from the mirror image", source, 0,
           distance_from_mirror(mesh, assembly.state, start), 1e-8, "mm", kind});
  compare({"ironing: largest lateral over normal force on the way", "no friction", 0, lateral, 0.01, "1", kind});
}
