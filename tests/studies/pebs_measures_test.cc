// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/pebs_measures.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>

using namespace ballonet;
using namespace ballonet::studies;

namespace
{

constexpr double degree = std::numbers::pi / 180;

geometry::PebsMesh actuator(bool symmetric, int ribs = 4)
{
  geometry::Pebs pebs;
  pebs.ribs.count = ribs;
  pebs.balloon.length = 4.8 * ribs - 6;
  geometry::MeshSizes sizes;
  sizes.symmetry = symmetric;
  auto mesh = geometry::build_mesh(pebs, sizes);
  REQUIRE(std::holds_alternative<geometry::PebsMesh>(mesh));
  return std::get<geometry::PebsMesh>(std::move(mesh));
}

std::vector<Point> moved(const std::vector<Point> &points, const std::function<Point(Point)> &map)
{
  std::vector<Point> result;
  for (const Point &point : points)
    result.push_back(map(point));
  return result;
}

Rotation about_y(double bending)
{
  const double c = std::cos(bending * degree), s = std::sin(bending * degree);
  return {{{c, 0, -s}, {0, 1, 0}, {s, 0, c}}};
}
Rotation about_x(double out)
{
  const double c = std::cos(out * degree), s = std::sin(out * degree);
  return {{{1, 0, 0}, {0, c, s}, {0, -s, c}}};
}
Rotation about_z(double twist)
{
  const double c = std::cos(twist * degree), s = std::sin(twist * degree);
  return {{{c, -s, 0}, {s, c, 0}, {0, 0, 1}}};
}
Rotation product(const Rotation &a, const Rotation &b)
{
  const Rotation transposed = {{{a[0][0], a[1][0], a[2][0]}, {a[0][1], a[1][1], a[2][1]}, {a[0][2], a[1][2], a[2][2]}}};
  return relative_rotation(transposed, b);
}

/// Bends the axis into an arc towards -x: `angle` deg over the height H.
std::function<Point(Point)> bend(double angle, double height)
{
  return [=](Point p) -> Point {
    const double rho = height / (angle * degree), phi = angle * degree * p[2] / height;
    return {-rho + (rho + p[0]) * std::cos(phi), p[1], (rho + p[0]) * std::sin(phi)};
  };
}

} // namespace

TEST_CASE("a rigid motion is found exactly")
{
  const std::vector<Point> reference = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 0.5}, {1, 1, 1}};
  const std::vector<std::uint32_t> nodes = {0, 1, 2, 3, 4};
  RigidFrame truth;
  truth.rotation = product(about_y(100), product(about_x(20), about_z(-35)));
  truth.centre = {5, -6, 7};
  const auto frame = best_fit(reference, moved(reference, [&](Point p) { return truth.map(p); }), nodes, false);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      REQUIRE(frame.rotation[i][j] == Approx(truth.rotation[i][j]).margin(1e-12));
  const Point image = frame.map({3, 4, 5}), expected = truth.map({3, 4, 5});
  for (int i = 0; i < 3; ++i)
    REQUIRE(image[i] == Approx(expected[i]));
  const FrameAngles found = angles(frame.rotation);
  REQUIRE(found.bending == Approx(100));
  REQUIRE(found.out_of_plane == Approx(20));
  REQUIRE(found.twist == Approx(-35));
}

TEST_CASE("stretching along the frame's own axes is no rotation, a plane has no frame")
{
  const std::vector<Point> reference = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}, {0, 0, 0.5}};
  const std::vector<std::uint32_t> nodes = {0, 1, 2, 3};
  const auto uniform = best_fit(reference,
                                moved(reference,
                                      [](Point p) {
                                        return Point{2 * p[0], 2 * p[1], 2 * p[2]};
                                      }),
                                nodes, false);
  REQUIRE(angles(uniform.rotation).bending == Approx(0).margin(1e-10));
  REQUIRE_THROWS_AS(best_fit(reference, reference, {0, 1, 2}, false), std::invalid_argument);
}

TEST_CASE("angles go on beyond half a turn")
{
  REQUIRE(unwrapped(-170, 175) == Approx(190));
  REQUIRE(unwrapped(-40, 0) == Approx(-40));
  REQUIRE(unwrapped(10, 355) == Approx(370));
}

TEST_CASE("an undeformed actuator measures nothing, and a rigid motion of all of it turns the head only")
{
  for (const bool symmetric : {true, false}) {
    const auto pebs = actuator(symmetric);
    const PebsGauge gauge(pebs.layout, pebs.mesh.nodes, symmetric);
    const PebsMeasures rest = gauge.measure(pebs.mesh.nodes, 0);
    REQUIRE(rest.bending_angle == Approx(0).margin(1e-9));
    REQUIRE(rest.gaps.size() == 4);
    REQUIRE(rest.gaps[0] == Approx(0).margin(1e-9));
    REQUIRE(rest.axial_ratio == Approx(1));
    REQUIRE(rest.radial_ratio == Approx(1));
    REQUIRE(rest.max_bulge == Approx(3.6 - 8));
    REQUIRE(rest.tip[0] == Approx(0).margin(1e-9));
    const auto turned = gauge.measure(moved(pebs.mesh.nodes,
                                            [](Point p) {
                                              RigidFrame frame;
                                              frame.rotation = about_y(30);
                                              return frame.map(p);
                                            }),
                                      0);
    REQUIRE(turned.bending_angle == Approx(30));
    REQUIRE(turned.twist == Approx(0).margin(1e-9));
    REQUIRE(turned.gaps[0] == Approx(30));
    REQUIRE(turned.gaps[1] == Approx(0).margin(1e-9));
    REQUIRE(turned.axial_ratio == Approx(1));
  }
}

TEST_CASE("a twisted and tilted head is told apart from bending")
{
  const auto pebs = actuator(false);
  const PebsGauge gauge(pebs.layout, pebs.mesh.nodes, false);
  const auto m = gauge.measure(moved(pebs.mesh.nodes,
                                     [](Point p) {
                                       RigidFrame frame;
                                       frame.rotation = product(about_y(50), product(about_x(10), about_z(25)));
                                       return frame.map(p);
                                     }),
                               0);
  REQUIRE(m.bending_angle == Approx(50));
  REQUIRE(m.out_of_plane == Approx(10));
  REQUIRE(m.twist == Approx(25));
}

TEST_CASE("a uniform bend is shared by the gaps and unwrapped beyond 180 deg")
{
  const int ribs = 10;
  const auto pebs = actuator(true, ribs);
  const PebsGauge gauge(pebs.layout, pebs.mesh.nodes, true);
  const double height = pebs.layout.height;
  double previous = 0;
  for (const double angle : {-40., 20., 100., 170., 230.}) {
    CAPTURE(angle);
    const auto m = gauge.measure(moved(pebs.mesh.nodes, bend(angle, height)), previous);
    // Head and ribs are found at the height of their middles.
    REQUIRE(m.bending_angle == Approx(angle * (height + 1) / height).epsilon(0.01));
    for (std::size_t k = 1; k < m.gaps.size(); ++k)
      REQUIRE(m.gaps[k] == Approx(angle * 4.8 / height).epsilon(0.02));
    double sum = 0;
    for (const double gap : m.gaps)
      sum += gap;
    REQUIRE(sum == Approx(angle * (height - 1) / height).epsilon(0.01));
    REQUIRE(m.axial_ratio == Approx(1).epsilon(0.005)); // the axis keeps its length
    REQUIRE(m.radial_ratio == Approx(1).epsilon(0.01));
    REQUIRE(m.max_bulge == Approx(3.6 - 8).margin(0.05)); // interpolated axis against the true arc
    previous = m.bending_angle;
  }
}

TEST_CASE("an inflated balloon and its largest bulge are measured, also in a bent cage")
{
  for (const bool symmetric : {true, false}) {
    const auto pebs = actuator(symmetric, 10);
    const PebsGauge gauge(pebs.layout, pebs.mesh.nodes, symmetric);
    const double height = pebs.layout.height, length = pebs.layout.balloon_length;
    std::vector<Point> inflated = pebs.mesh.nodes;
    for (const auto &node : pebs.layout.balloon_outer) {
      Point &p = inflated[node.node];
      const double bulge = 8 + 1.7 * std::exp(-std::pow((p[2] - 24.6) / 2, 2)); // in the middle of a gap
      const double factor = node.z > length - 3.6 + 1e-6 ? 1 : bulge / 3.6;
      p = {factor * p[0], factor * p[1], p[2]};
    }
    REQUIRE(gauge.measure(inflated, 0).max_bulge == Approx(1.7).margin(0.02));
    REQUIRE(gauge.measure(inflated, 0).radial_ratio == Approx(8 / 3.6).epsilon(0.03));
    REQUIRE(gauge.measure(inflated, 0).localisation ==
            Approx(10 / (1 + 2 * std::exp(-1.44))).epsilon(0.05)); // one gap of ten, a bit of two others
    const auto m = gauge.measure(moved(inflated, bend(150, height)), 0);
    REQUIRE(m.max_bulge == Approx(1.7).margin(0.1));
  }
}

TEST_CASE("localisation is the largest bulge over the mean of all gaps, what is inside the cage not counted")
{
  REQUIRE(localisation_index({1, 1, 1, 1}) == 1);
  REQUIRE(localisation_index({0, 2, -5, -5}) == 4);
  REQUIRE(localisation_index({3, 1, -1, 0}) == 3);
  REQUIRE(localisation_index({-1, -2}) == 1);
}

TEST_CASE("a rib opens where it grows in its own frame, wherever it has moved")
{
  for (const bool symmetric : {true, false}) {
    const auto pebs = actuator(symmetric);
    const PebsGauge gauge(pebs.layout, pebs.mesh.nodes, symmetric);
    auto opened = pebs.mesh.nodes;
    double outer = 0;
    for (const std::uint32_t node : pebs.layout.ribs[1].nodes) { // by 5 % of its radius
      Point &p = opened[node];
      outer = std::max(outer, std::hypot(p[0], p[1]));
      p = {1.05 * p[0], 1.05 * p[1], p[2]};
    }
    REQUIRE(gauge.measure(pebs.mesh.nodes, 0).rib_opening == Approx(0).margin(1e-9));
    REQUIRE(gauge.measure(opened, 0).rib_opening ==
            Approx(0.05 * outer).epsilon(0.06)); // about its centroid, off the axis
    const auto turned = moved(opened, [](Point p) {
      RigidFrame frame;
      frame.rotation = about_y(70);
      frame.centre = {3, 0, 5};
      return frame.map(p);
    });
    REQUIRE(gauge.measure(turned, 0).rib_opening == Approx(gauge.measure(opened, 0).rib_opening));
  }
}

TEST_CASE("a stretched balloon has its axial ratio")
{
  const auto pebs = actuator(true, 6);
  const BalloonGauge gauge(pebs.layout, pebs.mesh.nodes, true);
  const auto stretched = moved(pebs.mesh.nodes, [](Point p) { return Point{p[0], p[1], 1.25 * p[2]}; });
  REQUIRE(gauge.axial_ratio(stretched) == Approx(1.25));
  REQUIRE(gauge.radial_ratio(stretched) == Approx(1));
}

TEST_CASE("a rib counts when enough of its arc is touched")
{
  const std::vector<std::vector<std::uint32_t>> ribs = {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}, {12, 13}};
  std::vector<bool> touched(14, false);
  REQUIRE(touched_share(ribs, touched, 0.5) == 0);
  for (const int cell : {0, 1, 4, 8, 9, 10, 11})
    touched[static_cast<std::size_t>(cell)] = true;
  REQUIRE(touched_share(ribs, touched, 0.5) == 0.5);
  REQUIRE(touched_share(ribs, touched, 0.25) == 0.75);
  REQUIRE(touched_share(ribs, touched, 0) == 0.75);
}

TEST_CASE("a point beyond an end of a curled cage is not taken for a bulge on the other side")
{
  constexpr double height = 4.5, turn = 260 * degree / 19; // of each gap but one
  std::vector<CageAxis::Station> stations = {{{0, 0, 0}, {0, 0, 1}}};
  double angle = 0;
  for (int gap = 0; gap < 20; ++gap) {
    const double before = angle;
    angle += gap == 13 ? 0 : turn; // straight: its planes are parallel, and the base lies between them
    const double middle = (before + angle) / 2;
    const auto &below = stations.back().centre;
    stations.push_back({{below[0] - height * std::sin(middle), 0, below[2] + height * std::cos(middle)},
                        {-std::sin(angle), 0, std::cos(angle)}});
  }
  const CageAxis axis(stations);
  CHECK_FALSE(axis.place_of({3, 0, -2})); // below the base
  const auto &[centre, normal] = stations[10];
  const auto bulge = axis.place_of({centre[0] + 11 * normal[2] + 0.1 * normal[0], 0,
                                    centre[2] - 11 * normal[0] + 0.1 * normal[2]}); // on the outer side
  REQUIRE(bulge);
  CHECK(bulge->gap == 10);
  CHECK(bulge->radius == Approx(11).epsilon(0.01));
}
