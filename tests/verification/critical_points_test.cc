// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/simulation.h"
#include "tests/support/box_mesh.h"
#include "tests/support/comparison.h"
#include "tests/support/round_mesh.h"
#include "tests/support/rubber_sphere.h"
#include "tests/support/thick_wall.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

struct Found {
  std::vector<CriticalPoint> points;
  PathProgress end;
  double reference_volume = 0;
  std::string log;
};

Found follow(const Parameters &parameters, const Mesh &mesh)
{
  Found found;
  Simulation simulation(parameters, mesh, MPI_COMM_SELF);
  const auto result = simulation.run(
      [&](const PathPoint &point) {
        found.points.insert(found.points.end(), point.critical_points.begin(), point.critical_points.end());
        found.reference_volume = point.reference_volume;
        return "";
      },
      [&](const std::string &line) { found.log += line + '\n'; });
  INFO(found.log << result.reason);
  REQUIRE(result.status == PathStatus::ended);
  found.end = simulation.progress();
  return found;
}

/// A thick neo-Hookean sphere blown up by its volume through the limit of its pressure.
struct Sphere : RubberSphere {
  Sphere() : RubberSphere(inner_radius, outer_radius, wall_mu)
  {
    parameters.cavity = Cavity{"inner"};
    auto &path = parameters.path;
    path.critical_points = CriticalPoints::locate;
    path.volume_rate = 1, path.step_initial = 0.2, path.step_max = 0.5, path.volume_max = 6;
  }
};

/// Where the pressure of the sphere is largest: V / V0.
double limit_of_sphere()
{
  double best = 1;
  for (double ratio = 1; ratio < 8; ratio += 1e-4)
    best = sphere_pressure(ratio) > sphere_pressure(best) ? ratio : best;
  return best;
}

} // namespace

TEST_CASE("critical points: limit of a thick sphere")
{
  const Sphere sphere;
  const auto found = follow(sphere.parameters, sphere.mesh);
  INFO(found.log);
  REQUIRE(found.points.size() == 1);
  const auto &limit = found.points[0];
  CHECK(limit.kind == CriticalKind::limit_point);
  CHECK(limit.before.negative_pivots == 0);
  CHECK(limit.after.negative_pivots == 1);
  CHECK(limit.after.at_held_volume() == 0);
  CHECK(limit.bracket <= sphere.parameters.path.critical_tolerance);
  const double exact = limit_of_sphere();
  const char *source = "incompressible neo-Hookean sphere, exact (Green and Zerna 1954)";
  compare({"thick sphere: limit pressure, located", source, 1e3 * sphere_pressure(exact), 1e3 * limit.pressure, 1e-3,
           "kPa"});
  compare({"thick sphere: V / V0 at the limit, located", source, exact, limit.volume / found.reference_volume, 1e-2});
  CHECK(limit.load_participation > 0.1); // the mode is the radial motion
}

// Contact with a shell around it takes the sphere's unstable motion away at once: no eigenvalue passes zero.
TEST_CASE("critical points: a contact that closes is not called one")
{
  Sphere sphere;
  auto shell = eighth_sphere(2.1, 3, 1, 2);
  shell.bodies = {"shell"};
  for (auto &surface : shell.surfaces)
    surface.name = "shell." + surface.name;
  auto &p = sphere.parameters;
  p.materials.push_back({});
  auto &stiff = p.materials.back();
  stiff.name = "stiff", stiff.law = Law::saint_venant, stiff.youngs_modulus = 50, stiff.poisson_ratio = 0.3;
  p.bodies.push_back({"shell", "stiff"});
  for (const char d : {'x', 'y', 'z'})
    p.supports.push_back({std::string("shell.") + d + "0", {std::string(1, d)}});
  ContactPair pair;
  pair.name = "pair", pair.secondary = {"outer"}, pair.primary = {"shell.inner"};
  pair.friction = 0, pair.thickness = 0.3, pair.onset = 1e-5, pair.passes = 1;
  p.contact_pairs = {pair};
  p.path.volume_max = 7;
  const auto found = follow(p, beside(sphere.mesh, shell));
  INFO(found.log);
  REQUIRE(found.points.size() == 2);
  CHECK(found.points[0].kind == CriticalKind::limit_point);
  CHECK(found.points[1].kind == CriticalKind::eigenvalue_jump);
  CHECK(found.points[1].before.negative_pivots == 1);
  CHECK(found.points[1].after.negative_pivots == 0);
}

namespace
{

/// A slender column clamped at x0 under a dead end load; weak about z. The full load is `overload` times Euler's.
struct Column {
  static constexpr double length = 40, width = 1.5, modulus = 1000;
  Mesh mesh = box_mesh(20, 1, 1, [](Point3 x) { return Point3{length * x[0], x[1] - 0.5, width * (x[2] - 0.5)}; });
  Parameters parameters;
  double euler_load = M_PI * M_PI * modulus * width / 12 / (4 * length * length); ///< N

  explicit Column(double overload)
  {
    parameters.materials.resize(1);
    auto &m = parameters.materials[0];
    m.name = "steel", m.law = Law::saint_venant, m.youngs_modulus = modulus, m.poisson_ratio = 0;
    parameters.bodies = {{"body", "steel"}};
    parameters.supports = {{"x0", {"x", "y", "z"}}};
    parameters.loads = {{"x1", {-overload * euler_load / width, 0, 0}, 0}};
    parameters.newton = {.tolerance = 1e-8, .force_floor = 1e-3};
    parameters.path.critical_points = CriticalPoints::locate;
  }

  double deflection(const State &state) const
  {
    for (const auto node : surface_nodes(mesh, "x1"))
      if (mesh.nodes[node][1] == 0 && mesh.nodes[node][2] == 0)
        return state.displacement[3 * node + 1];
    FAIL("no node in the middle");
    return 0;
  }
};

/// Modulus k with K(k)^2 = P L^2 / (E I), of a cantilever buckled under its end load P = ratio times Euler's.
double elastica_modulus(double ratio)
{
  double low = 0, high = 0.999;
  while (high - low > 1e-12) {
    const double k = (low + high) / 2;
    (std::comp_ellint_1(k) > M_PI / 2 * std::sqrt(ratio) ? high : low) = k;
  }
  return low;
}

} // namespace

TEST_CASE("critical points: Euler's column")
{
  for (const auto control : {Control::load, Control::arc_length}) {
    Column column(1.5);
    column.parameters.path.control = control;
    const auto found = follow(column.parameters, column.mesh);
    INFO(found.log);
    REQUIRE(found.points.size() == 1);
    const auto &point = found.points[0];
    CHECK(point.kind == CriticalKind::bifurcation);
    CHECK(point.load_participation < 1e-6);
    compare({std::string("column, clamped and free, ") + (control == Control::load ? "load" : "arc length") +
                 ": load at its bifurcation over Euler's",
             "pi^2 E I / (4 L^2); shortening and shear are of the order 1e-3", 1, 1.5 * point.load_factor, 5e-3});
    CHECK(std::abs(column.deflection(found.end.state)) < 1e-6); // it stays straight
  }
}

TEST_CASE("critical points: Euler's column goes on along its mode")
{
  Column column(1.1);
  column.parameters.path.control = Control::arc_length;
  column.parameters.path.arc_step_max = 1;
  column.parameters.path.branch_amplitude = 2;
  const auto found = follow(column.parameters, column.mesh);
  INFO(found.log);
  REQUIRE(found.points.size() == 1);
  CHECK(found.end.stability.negative_pivots == 0); // the straight one has one here
  const double ratio = 1.1 * found.end.state.load_factor, k = elastica_modulus(ratio);
  REQUIRE(ratio >= 1.1 * (1 - 1e-9));
  compare({"column beyond Euler's load, on its branch: deflection of the tip over the length",
           "2 k / K(k), K(k) = pi/2 sqrt(P / P_Euler) (Euler's elastica)", 2 * k / std::comp_ellint_1(k),
           std::abs(column.deflection(found.end.state)) / Column::length, 1e-2});
}
