// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/cell_inversion.h"
#include "solver/penetration_check.h"
#include "tests/support/contact_scene.h"
#include <algorithm>
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

/// A closed plate of 6 x 6 x 0.4 mm, coarse, and a thin bar standing upright above it, moved down until its lower end
/// is at `height` over the plate's lower side, `x` from the plate's edge.
ContactScene bar_and_plate(double height, double x = 2.95)
{
  ContactScene scene;
  add_block(scene.mesh, "bar", {1, 1, 2}, [&](auto p) {
    return std::array<double, 3>{x + 0.1 * p[0], 2.95 + 0.1 * p[1], 1 + 4 * p[2]};
  });
  const std::size_t bar_nodes = scene.mesh.nodes.size();
  add_block(scene.mesh, "plate", {2, 2, 1}, [](auto p) {
    return std::array<double, 3>{6 * p[0], 6 * p[1], 0.4 * p[2]};
  });
  scene.pair = {"pair", all_sides("plate"), all_sides("bar"), 0, 0.3, 9, 0.06};
  scene.state.displacement.assign(3 * scene.mesh.nodes.size(), 0.);
  for (std::size_t n = 0; n < bar_nodes; ++n)
    scene.state.displacement[3 * n + 2] = height - 1;
  return scene;
}

std::vector<Violation> violations(const ContactScene &scene, double tolerance = 0.1)
{
  return PenetrationCheck(scene.mesh, scene.pair, tolerance).find(scene.state);
}

/// How many nodes of the plate lie inside the block.
std::ptrdiff_t in_block(const std::vector<Violation> &found)
{
  return std::count_if(found.begin(), found.end(), [](const Violation &v) { return v.body == "block"; });
}

} // namespace

TEST_CASE("bodies apart or touching are not reported")
{
  CHECK(violations(bar_and_plate(0.5)).empty());
  CHECK(violations(bar_and_plate(0.35)).empty()); // 0.05 mm deep, tolerated
}

TEST_CASE("a bar that slipped through a plate between the contact points is found though its energy is zero")
{
  const ContactScene scene = bar_and_plate(-1.9); // its end has come out below, its middle ring of nodes is above
  ContactPair plate_pair = scene.pair;
  plate_pair.passes = 1;
  ContactWork work(scene.mesh, plate_pair, all_owned);
  work.begin_step(scene.state, {.dt = 1e-3});
  CHECK(work.energy(scene.state) == 0);

  ContactScene half = bar_and_plate(0.15); // end face inside the wall
  const auto found = violations(half);
  REQUIRE(found.size() == 9);
  CHECK(found.front().body == "plate");
  CHECK(found.front().depth == Approx(0.15).margin(1e-9));

  ContactScene open = scene; // only the upper side encloses: whatever is below it has gone through
  open.pair.secondary = {"plate.z1"};
  const auto through = violations(open);
  REQUIRE(through.size() == 25);
  CHECK(std::max_element(through.begin(), through.end(), [](auto &a, auto &b) { return a.depth < b.depth; })->depth ==
        Approx(2.3).epsilon(1e-9));
}

TEST_CASE("beside an open side of the surface nothing is reported")
{
  ContactScene scene = bar_and_plate(-1.9, 7);
  scene.pair.secondary = {"plate.z1"};
  CHECK(violations(scene).empty());
}

TEST_CASE("a secondary node inside a primary cell is found")
{
  ContactScene scene = contact_scene(Vector({1, 1, 1.2}), Vector({0, 0, 1}), 1.2, 0);
  scene.state = with_plate_moved(scene, Vector({0, 0, -0.5}));
  CHECK(in_block(violations(scene)) == 9);
  CHECK(violations(scene, 0.35).empty());
}

TEST_CASE("in the corner of a rounded edge the depth counts from the rounding")
{
  // 0.2 mm behind both faces; the edge is rounded by 0.3 mm, so 0.3 - 0.1 sqrt(2) = 0.159 mm behind the rounding
  ContactScene scene = contact_scene(Vector({2.8, 1, 1.8}), Vector({1, 0, 1}), 0.01, 0);
  scene.state = with_plate_moved(scene, Vector({-1, 0, -1}));
  CHECK(in_block(violations(scene, 0.18)) == 0);
  CHECK(in_block(violations(scene, 0.14)) == 9);
  scene.pair.thickness = 0.05; // hardly rounded
  CHECK(in_block(violations(scene, 0.18)) == 9);
}

TEST_CASE("inverse mapping of a distorted cell")
{
  Mesh mesh;
  add_block(mesh, "block", {1, 1, 1}, [](auto p) { return p; });
  distort(mesh, 0.05, 4);
  contact::CellNodes nodes;
  for (int a = 0; a < 27; ++a)
    nodes[a] = Vector({mesh.nodes[a][0], mesh.nodes[a][1], mesh.nodes[a][2]});
  const auto corner = contact::local_coordinates(nodes, nodes[26]);
  REQUIRE(corner);
  CHECK((*corner - Vector({1, 1, 1})).norm() < 1e-7);
  CHECK((*contact::local_coordinates(nodes, nodes[13]) - Vector({0.5, 0.5, 0.5})).norm() < 1e-10);
  CHECK_FALSE(contact::local_coordinates(nodes, Vector({1.3, 0.5, 0.5})));
}
