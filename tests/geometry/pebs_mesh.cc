// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/boundary.h"
#include "geometry/measures.h"
#include "tests/geometry/built_mesh.h"
#include <numbers>

using namespace ballonet::geometry;
using std::numbers::pi;

namespace
{

double disc(double radius) { return pi * radius * radius; }
double annulus(double inner, double outer) { return disc(outer) - disc(inner); }

/// Share of the circle the wall's land takes.
double land_share(const Pebs &pebs)
{
  return pebs.wall.width / (pebs.ribs.inner_radius + pebs.wall.thickness / 2) / (2 * pi);
}

/// Area of one rib seen along the axis.
double rib_area(const Pebs &pebs)
{
  const double inner = pebs.ribs.inner_radius, land = land_share(pebs);
  return (1 - land) * annulus(inner, inner + pebs.ribs.thickness) + land * annulus(inner, inner + pebs.wall.thickness);
}

double backbone_volume(const Pebs &pebs)
{
  const double outer = pebs.ribs.inner_radius + pebs.ribs.thickness;
  const double strip = pebs.wall.width * pebs.wall.thickness * pi * pebs.wall.rise.front();
  return pebs.ribs.count * (pebs.ribs.width * rib_area(pebs) + strip) +
         disc(outer) * (pebs.head.thickness + pebs.base.thickness);
}

double balloon_volume(const Balloon &balloon)
{
  const double outer = balloon.diameter / 2, inner = outer - balloon.wall;
  return annulus(inner, outer) * (balloon.length - outer) + 2 * pi / 3 * (std::pow(outer, 3) - std::pow(inner, 3));
}

} // namespace

TEST_CASE("the default mesh has the volumes of the drawing")
{
  const Pebs pebs;
  const PebsMesh built_mesh = built(pebs, {});
  CHECK(2 * volume(built_mesh.mesh, "backbone") == Approx(backbone_volume(pebs)).epsilon(3e-4));
  CHECK(2 * volume(built_mesh.mesh, "balloon") == Approx(balloon_volume(pebs.balloon)).epsilon(3e-4));
  CHECK(balloon_volume(pebs.balloon) * 1.08e-3 == Approx(1.02).epsilon(5e-3)); // g, latex of 1080 kg/m^3
}

TEST_CASE("with thick lands the backbone has the 5584 mm^3 of the reference design")
{
  Pebs pebs;
  pebs.wall.thickness = 0.8; // before it was trimmed to the droop
  pebs.wall.thick_land = true;
  CHECK(2 * volume(built(pebs, {}).mesh, "backbone") == Approx(5584).epsilon(1e-3));
  pebs.wall.thick_land = false;
  CHECK(2 * volume(built(pebs, {}).mesh, "backbone") == Approx(5584).epsilon(0.05));
}

TEST_CASE("the default half model has about the wanted size")
{
  const Mesh mesh = built(Pebs{}, {}).mesh;
  std::size_t backbone = 0;
  for (const std::uint32_t body : mesh.cell_body)
    backbone += mesh.bodies[body].name == "backbone" ? 1 : 0;
  CHECK(backbone > 900);
  CHECK(backbone < 1100);
  CHECK(mesh.cells.size() - backbone > 550);
  CHECK(mesh.cells.size() - backbone < 750);
}

TEST_CASE("half a model is half the full one")
{
  const Pebs pebs = short_pebs();
  const PebsMesh half = built(pebs, {}), full = built(pebs, full_model());
  CHECK(2 * half.mesh.cells.size() == full.mesh.cells.size());
  for (const char *body : {"backbone", "balloon"})
    CHECK(2 * volume(half.mesh, body) == Approx(volume(full.mesh, body)).epsilon(1e-12));
  for (const char *surface : {"balloon_inner", "wall", "head_contact", "backbone_contact", "rib_02"})
    CHECK(2 * area(half.mesh, surface) == Approx(area(full.mesh, surface)).epsilon(1e-12));
  CHECK(find_surface(full.mesh, "symmetry") == nullptr);
}

TEST_CASE("surfaces have the areas of the drawing")
{
  const Pebs pebs = short_pebs();
  const Mesh mesh = built(pebs, full_model()).mesh;
  const double inner = pebs.ribs.inner_radius, outer = inner + pebs.ribs.thickness, width = pebs.ribs.width;
  const double tube = pebs.balloon.length - 3.6;
  CHECK(area(mesh, "balloon_inner") == Approx(2 * pi * 3.1 * tube + 2 * disc(3.1)).epsilon(1e-3));
  CHECK(area(mesh, "balloon_outer") == Approx(2 * pi * 3.6 * tube + 2 * disc(3.6)).epsilon(1e-3));
  CHECK(area(mesh, "balloon_base") == Approx(annulus(3.1, 3.6)).epsilon(1e-3));
  CHECK(area(mesh, "base_bottom") == Approx(disc(outer)).epsilon(1e-3));
  CHECK(area(mesh, "head_top") == Approx(disc(outer)).epsilon(1e-3));
  CHECK(area(mesh, "head_contact") == Approx(disc(outer) - rib_area(pebs)).epsilon(1e-3));
  const double land = land_share(pebs) * annulus(inner, inner + pebs.wall.thickness);
  CHECK(area(mesh, "base_contact") == Approx(disc(outer) - land).epsilon(1e-3));
  CHECK(area(mesh, "rib_inner_02") == Approx(2 * pi * inner * width).epsilon(1e-3));
  const double lands = land_share(pebs) * 2 * pi * (inner + pebs.wall.thickness) * width;
  const double steps = 2 * (pebs.ribs.thickness - pebs.wall.thickness) * width;
  const double rims = (1 - land_share(pebs)) * 2 * pi * outer * width;
  CHECK(area(mesh, "rib_02") ==
        Approx(2 * pi * inner * width + rims + lands + steps + 2 * (rib_area(pebs) - land)).epsilon(1e-3));
}

TEST_CASE("what the balloon may touch is the union of its parts")
{
  const Mesh mesh = built(short_pebs(), full_model()).mesh;
  double strips = area(mesh, "wall"), sum = area(mesh, "head_contact") + area(mesh, "base_contact");
  for (const Face &face : find_surface(mesh, "rib_01")->faces)
    CHECK(mesh.bodies[mesh.cell_body[face.cell]].name == "backbone");
  const double land = land_share(Pebs{}), inner_rib = 2 * pi * 8 * 2,
               sides = 2 * (rib_area(Pebs{}) - land * annulus(8, 8.9));
  strips -= 3 * land * inner_rib;
  sum += strips + 3 * inner_rib + 3 * sides - (1 - land) * annulus(8, 9.5); // the head covers the top rib's upper side
  CHECK(area(mesh, "backbone_contact") == Approx(sum).epsilon(1e-3));
}

TEST_CASE("the half model ends in the plane y = 0")
{
  const Mesh mesh = built(short_pebs(), {}).mesh;
  for (const Point &node : mesh.nodes)
    REQUIRE(node[1] >= 0);
  for (const Face &face : find_surface(mesh, "symmetry")->faces)
    for (const std::uint32_t node : nodes_of(mesh, face))
      REQUIRE(mesh.nodes[node][1] == 0);
  const double balloon = 2 * 0.5 * (10 - 3.6) + pi / 2 * (3.6 * 3.6 - 3.1 * 3.1);
  const double fold = pi * 1.4 * 0.9, land = 2 * 0.9, rib = 2 * 1.5, discs = 19 * 6;
  CHECK(area(mesh, "symmetry") == Approx(balloon + 3 * (fold + land + rib) + discs).epsilon(2e-3));
}

TEST_CASE("layout points at the right nodes")
{
  const auto [mesh, layout] = built(Pebs{}, {});
  REQUIRE(layout.ribs.size() == 20);
  CHECK(layout.height == Approx(96));
  CHECK(layout.pitch == Approx(4.8));
  for (const RibLayout &rib : layout.ribs) {
    CHECK(rib.land.size() < rib.nodes.size());
    for (const std::uint32_t node : rib.nodes)
      REQUIRE(std::abs(mesh.nodes[node][2] - rib.centre_z) < 1 + 1e-9);
    for (const std::uint32_t node : rib.land)
      REQUIRE(mesh.nodes[node][0] < 0); // the back wall is on the -x side
  }
  for (const std::uint32_t node : layout.head)
    REQUIRE(mesh.nodes[node][2] >= 96 - 1e-9);
  double highest = 0;
  for (const BalloonNode &outer : layout.balloon_outer) {
    const Point expected = {-3.6 * std::cos(outer.angle), 3.6 * std::sin(outer.angle), outer.z};
    if (outer.z < 86.4)
      REQUIRE(std::hypot(expected[0] - mesh.nodes[outer.node][0], expected[1] - mesh.nodes[outer.node][1]) < 1e-9);
    highest = std::max(highest, outer.z);
  }
  CHECK(highest == Approx(90));
  for (const std::uint32_t node : layout.balloon_tip)
    REQUIRE(mesh.nodes[node][2] > 86.4);
}

TEST_CASE("curved nodes lie exactly on their cylinders and on the dome's sphere")
{
  const Mesh mesh = built(short_pebs(), full_model()).mesh;
  for (const Face &face : find_surface(mesh, "rib_inner_02")->faces)
    for (const std::uint32_t node : nodes_of(mesh, face))
      REQUIRE(std::hypot(mesh.nodes[node][0], mesh.nodes[node][1]) == Approx(8).epsilon(1e-12));
  for (const Face &face : find_surface(mesh, "balloon_outer")->faces)
    for (const std::uint32_t node : nodes_of(mesh, face)) {
      const Point &p = mesh.nodes[node];
      REQUIRE(std::hypot(p[0], p[1], std::max(p[2] - 6.4, 0.)) == Approx(3.6).epsilon(1e-12));
    }
}

TEST_CASE("balloon and backbone can be meshed alone")
{
  Pebs bare = short_pebs();
  bare.with_balloon = false;
  const Mesh backbone = built(bare, {}).mesh;
  REQUIRE(backbone.bodies.size() == 1);
  CHECK(backbone.bodies[0].name == "backbone");
  CHECK(find_surface(backbone, "balloon_inner") == nullptr);
  const BalloonAlone alone;
  const PebsMesh balloon = built(alone, {});
  REQUIRE(balloon.mesh.bodies.size() == 1);
  CHECK(2 * volume(balloon.mesh, "balloon") == Approx(balloon_volume(alone.balloon)).epsilon(3e-4));
  CHECK_FALSE(balloon.layout.balloon_tip.empty());
}

TEST_CASE("coarse meshes for quick studies are accepted")
{
  MeshSizes sizes;
  sizes.along_fold = 6;
  sizes.across_wall = 2;
  sizes.around_ring = 16;
  sizes.balloon_around = 8;
  sizes.balloon_per_pitch = 2;
  sizes.dome_rings = 1;
  const Mesh mesh = built(short_pebs(), sizes).mesh;
  CHECK(mesh.cells.size() == 45 + 18 + 2 * 32 + 12 + 6); // ribs, strips, discs, tube, dome
  CHECK(2 * volume(mesh, "backbone") == Approx(backbone_volume(short_pebs())).epsilon(2e-3));
}
