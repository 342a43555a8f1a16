// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/boundary.h"
#include "geometry/measures.h"
#include "tests/geometry/built_mesh.h"
#include <numbers>

using namespace ballonet::geometry;

namespace
{

constexpr double degree = std::numbers::pi / 180;

Pebs six_ribs()
{
  Pebs pebs;
  pebs.ribs.count = 6;
  pebs.balloon.length = 24;
  return pebs;
}

/// Every free face belongs to a closed surface: the divergence theorem gives the cells' volume from the faces.
double volume_from_faces(const Mesh &mesh)
{
  double sum = 0;
  for (const Face &face : free_faces(mesh)) {
    const auto n = nodes_of(mesh, face);
    for (const unsigned c : {0U, 1U, 3U, 4U})
      for (const auto &[a, b] : {std::pair(c + 1, c + 4), std::pair(c + 4, c + 3)}) {
        const Point &p = mesh.nodes[n[c]], &q = mesh.nodes[n[a]], &r = mesh.nodes[n[b]];
        sum += (p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) +
                p[2] * (q[0] * r[1] - q[1] * r[0])) /
               6;
      }
  }
  return sum;
}

void check_mesh(const Pebs &pebs)
{
  const Mesh mesh = built(pebs, full_model()).mesh;
  CHECK(mesh.quality.smallest_scaled_jacobian > 0.1);
  CHECK(mesh.quality.largest_aspect_ratio < 15);
  CHECK(volume_from_faces(mesh) == Approx(volume(mesh, "balloon") + volume(mesh, "backbone")).epsilon(0.01));
}

/// Mean height of a rib's inner nodes near an angle about the axis.
double rib_height(const PebsMesh &built_mesh, std::size_t rib, double angle)
{
  double sum = 0;
  int count = 0;
  for (const std::uint32_t node : built_mesh.layout.ribs[rib].nodes) {
    const Point &p = built_mesh.mesh.nodes[node];
    if (std::abs(std::remainder(std::atan2(p[1], -p[0]) - angle, 2 * std::numbers::pi)) < 1e-6) {
      sum += p[2];
      ++count;
    }
  }
  REQUIRE(count > 0);
  return sum / count;
}

} // namespace

TEST_CASE("sloping ribs are tilted about the diameter through the wall")
{
  Pebs pebs = six_ribs();
  pebs.ribs.slope = {5};
  check_mesh(pebs);
  const PebsMesh mesh = built(pebs, full_model());
  CHECK(rib_height(mesh, 2, 0) == Approx(3 * 4.8 - 1));
  double highest = 0;
  for (const std::uint32_t node : mesh.layout.ribs[2].nodes)
    highest = std::max(highest, mesh.mesh.nodes[node][2]);
  CHECK(highest == Approx(3 * 4.8 + 8 * std::tan(5 * degree)).epsilon(5e-3));
  CHECK(rib_height(mesh, 5, std::numbers::pi) == Approx(6 * 4.8 - 1)); // the top rib stays level
}

TEST_CASE("steep slopes need room at both ends")
{
  Pebs pebs = six_ribs();
  pebs.ribs.slope = {30};
  pebs.ribs.position = {9, 13, 17, 21, 25, 34};
  pebs.wall.rise = {0.3};
  check_mesh(pebs);
}

TEST_CASE("V-shaped ribs and reversed ones rise towards the front and keep the wall")
{
  const double angle = GENERATE(5., -5.);
  Pebs pebs = six_ribs();
  pebs.ribs.v_angle = {angle};
  check_mesh(pebs);
  const PebsMesh mesh = built(pebs, full_model());
  const double land = 8.3 / 2 / 8.45, rise = 8 * std::tan(angle * degree) * (std::numbers::pi - land);
  CHECK(rib_height(mesh, 2, std::numbers::pi) == Approx(3 * 4.8 - 1 + rise));
  CHECK(rib_height(mesh, 2, 0) == Approx(3 * 4.8 - 1));
  CHECK(built(pebs, {}).mesh.cells.size() * 2 == mesh.mesh.cells.size());
}

TEST_CASE("ribs can be gathered: dense below, sparse above")
{
  Pebs pebs = six_ribs();
  pebs.ribs.position = {2.6, 6.2, 9.8, 15.4, 21.4, 28.4};
  pebs.wall.rise = {0.3, 0.3, 0.3, 1.4, 1.4, 1.4};
  check_mesh(pebs);
  CHECK(built(pebs, {}).layout.height == Approx(29.4));
}

TEST_CASE("open ribs leave a slit at the front")
{
  Pebs pebs = six_ribs();
  pebs.ribs.arc = {GENERATE(240., 345.)};
  check_mesh(pebs);
  const Mesh mesh = built(pebs, full_model()).mesh;
  CHECK(area(mesh, "rib_inner_03") == Approx(2 * std::numbers::pi * 8 * 2 * pebs.ribs.arc[0] / 360).epsilon(1e-3));
  CHECK(built(pebs, {}).mesh.cells.size() * 2 == mesh.cells.size());
}

TEST_CASE("a continuous change of orientation twists the wall")
{
  Pebs pebs = six_ribs();
  pebs.ribs.orientation = {0, 6, 12, 18, 24, 30};
  check_mesh(pebs);
  const PebsMesh mesh = built(pebs, full_model());
  for (const std::uint32_t node : mesh.layout.ribs[5].land) {
    const Point &p = mesh.mesh.nodes[node];
    REQUIRE(std::abs(std::atan2(p[1], -p[0]) - 30 * degree) < 8.3 / 2 / 8.4 + 1e-9);
  }
}

TEST_CASE("a sudden change of orientation gives the rib below it a second land")
{
  Pebs pebs = six_ribs();
  const double turn = GENERATE(90., 180.);
  pebs.ribs.orientation = {0, 0, 0, turn, turn, turn};
  check_mesh(pebs);
  const PebsMesh mesh = built(pebs, full_model());
  CHECK(mesh.layout.ribs[2].land.size() == 2 * mesh.layout.ribs[1].land.size());
}

TEST_CASE("a plain wall and a deep fold can be meshed")
{
  Pebs pebs = six_ribs();
  pebs.wall.rise = {GENERATE(0., 0.7, 2.2)};
  check_mesh(pebs);
}
