// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_pair_patches.h"
#include "solver/contact_quadrature.h"
#include "solver/simulation.h"
#include "tests/support/contact_scene.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

/// Two cubes of the same size on each other, 0.1 mm into one another.
ContactScene cubes(int passes)
{
  ContactScene scene;
  add_block(scene.mesh, "lower", {3, 2, 1}, [](auto p) { return p; });
  add_block(scene.mesh, "upper", {1, 1, 1}, [](auto p) { return std::array<double, 3>{p[0], p[1], 0.9 + p[2]}; });
  scene.pair = {"pair", {"upper.z0"}, {"lower.z1"}, 0.3, 0.3, 9, 0.06};
  scene.pair.passes = passes;
  scene.pair.elastic_slip = 3e-6;
  scene.state.displacement.assign(3 * scene.mesh.nodes.size(), 0.);
  return scene;
}

ContactWork started(const ContactScene &scene)
{
  ContactWork work(scene.mesh, scene.pair, all_owned);
  work.begin_step(scene.state, {.dt = 1e-6});
  return work;
}

double area(const std::vector<contact::QuadraturePoint> &points)
{
  double sum = 0;
  for (const auto &point : points)
    sum += point.area;
  return sum;
}

} // namespace

TEST_CASE("points of a trimmed patch lie on its edges and corners and carry the area of the real face")
{
  const ContactScene scene = interior_scene(); // trimmed on all sides
  for (const double depth : {0.3, 0.5})        // to a rectangle, to a line or a point
    for (const contact::Patch &patch : contact::patches_of(scene.mesh, all_sides("block"), depth)) {
      const auto points = contact::points_with_edges(scene.mesh, patch, 0.3, 0.5);
      CHECK(area(points) == Approx(0.5 * area(contact::gauss_points(scene.mesh, patch, 5, 1))).epsilon(2e-2)); // curved
      CHECK(points.front().xi == patch.range.low);
      CHECK(points.back().xi == patch.range.high);
      const auto nodes = at_depth(patch, contact::ReferencePosition{scene.mesh});
      auto position = [&](const contact::QuadraturePoint &point) {
        return contact::patch_point(nodes, point.xi).position;
      };
      for (std::size_t k = 1; k < points.size(); ++k)
        if (points[k].xi[1] == points[k - 1].xi[1])
          CHECK((position(points[k]) - position(points[k - 1])).norm() < 0.33);
    }
}

TEST_CASE("points of a primary surface lie as close as the pair asks, by default half its thickness")
{
  ContactScene scene = interior_scene();
  scene.pair.passes = 2;
  auto primary_points = [&](double spacing) {
    scene.pair.point_spacing = spacing;
    std::size_t count = 0;
    for (const contact::Patch &patch : contact::patches_of_pair(scene.mesh, scene.pair))
      count += patch.depth > 0 ? patch.points.size() : 0;
    return count;
  };
  CHECK(primary_points(0) == primary_points(scene.pair.thickness / 2));
  CHECK(primary_points(scene.pair.thickness / 4) > 2 * primary_points(0));
  CHECK(primary_points(scene.pair.thickness) < primary_points(0));
}

TEST_CASE("where the surface goes on no point lies on the common side of two patches")
{
  const ContactScene scene = contact_scene(Vector({1, 1, 0.9}), Vector({0, 0, 1}), 1.2, 0, {2, 2, 1});
  for (const contact::Patch &patch : contact::patches_of(scene.mesh, all_sides("block"), 0.3)) {
    const auto points = contact::points_with_edges(scene.mesh, patch, 0.15, 1);
    CHECK(area(points) == Approx(1).epsilon(1e-12));
    for (int a = 0; a < 2; ++a) {
      double low = 1, high = 0;
      for (const auto &point : points)
        low = std::min(low, point.xi[a]), high = std::max(high, point.xi[a]);
      CHECK((low == patch.range.low[a]) == (patch.range.low[a] > 0));
      CHECK((high == patch.range.high[a]) == (patch.range.high[a] < 1));
    }
  }
}

TEST_CASE("flat contact of two passes is as stiff as that of one, and its friction is mu times the normal force")
{
  const ContactScene one = cubes(1), two = cubes(2);
  const ContactWork first = started(one), both = started(two);
  CHECK(both.energy(two.state) == Approx(first.energy(one.state)).epsilon(1e-12));
  const auto summary = both.summary(two.state);
  CHECK(summary.points > first.summary(one.state).points);
  CHECK(summary.area == Approx(1).epsilon(1e-12));
  CHECK(summary.secondary_force[2] == Approx(9 * (0.1 - 0.03)).epsilon(1e-12));
  const State slid = with_plate_moved(two, Vector({0, 1e-3, 0})); // against an elastic slip of 3e-6 mm
  CHECK(both.summary(slid).secondary_force[1] == Approx(-0.3 * summary.secondary_force[2]).epsilon(2e-3));
}

TEST_CASE("two passes: the forces of each surface balance, also when only corners feel it")
{
  ContactScene scene = contact_scene(Vector({1.82, 1.82, 0.82}), Vector({1, 1, 1}), 9);
  scene.pair.points_per_side = 2; // 5 mm apart
  const ContactWork work = started(scene);
  const auto summary = work.summary(with_plate_moved(scene, Vector({0.01, -0.02, -0.01})));
  for (int i = 0; i < 3; ++i) {
    double sum = summary.secondary_force[i];
    for (const auto &force : summary.primary_force)
      sum += force[i];
    CHECK(std::abs(summary.secondary_force[i]) > 1e-3);
    CHECK(std::abs(sum) < 1e-10);
  }
  for (const ContactPoint &point : work.contact_points(scene.state)) {
    CHECK(point.secondary.cell == 1);
    CHECK(point.primary->cell == 0);
  }
}

TEST_CASE("one or two passes are allowed")
{
  ContactScene scene = cubes(3);
  CHECK_THROWS_AS(ContactWork(scene.mesh, scene.pair, all_owned), std::invalid_argument);
}

namespace
{

/// A stiff bar of 0.8 x 0.8 mm above the middle of a soft coarse plate that is held along two sides, driven down by
/// 1.5 mm: no point of the plate is nearer than 1.2 mm to the bar.
struct BarOnPlate {
  Mesh mesh;
  Parameters parameters;
  explicit BarOnPlate(int passes)
  {
    add_block(mesh, "bar", {1, 1, 1}, [](auto p) {
      return std::array<double, 3>{2.6 + 0.8 * p[0], 2.6 + 0.8 * p[1], 0.5 + 2 * p[2]};
    });
    add_block(mesh, "plate", {2, 2, 1}, [](auto p) { return std::array<double, 3>{6 * p[0], 6 * p[1], 0.4 * p[2]}; });
    parameters.materials.resize(2);
    for (auto &m : parameters.materials)
      m.law = Law::saint_venant, m.poisson_ratio = 0.3;
    parameters.materials[0].name = "hard", parameters.materials[0].youngs_modulus = 1000;
    parameters.materials[1].name = "soft", parameters.materials[1].youngs_modulus = 1;
    parameters.bodies = {{"bar", "hard"}, {"plate", "soft"}};
    parameters.supports = {{"bar.z1", {"x", "y"}, {{{}, {}, -1.5}}}};
    for (const char *side : {"plate.x0", "plate.x1"})
      parameters.supports.push_back({side, {"x", "y", "z"}});
    parameters.contact_pairs = {{"bar on plate", {"plate.z1"}, all_sides("bar"), 0}};
    parameters.contact_pairs[0].points_per_side = 2;
    parameters.contact_pairs[0].passes = passes;
    parameters.path.control = Control::load;
    parameters.path.load_steps = 10;
  }
};

PathResult follow(Simulation &simulation)
{
  return simulation.run([](const PathPoint &) { return std::string(); }, [](const std::string &) {});
}

} // namespace

TEST_CASE("a bar that slips between the points of a coarse plate with one pass is held by its own with two")
{
  const BarOnPlate one(1), two(2);
  Simulation through(one.parameters, one.mesh, MPI_COMM_SELF), held(two.parameters, two.mesh, MPI_COMM_SELF);
  const auto slipped = follow(through);
  INFO(slipped.reason);
  CHECK(slipped.status == PathStatus::diverged);
  CHECK_THAT(slipped.reason, Catch::Contains("inside or beyond body \"plate\""));
  const auto ended = follow(held);
  INFO(ended.reason);
  CHECK(ended.status == PathStatus::ended);
  const auto contact = held.equilibrium().contacts().summaries(held.progress().state)[0];
  CHECK(contact.penetration < two.parameters.contact_pairs[0].penetration_limit);
  CHECK(contact.secondary_force[2] < -0.1);
}
