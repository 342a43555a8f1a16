// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/comparison.h"
#include "tests/support/round_mesh.h"
#include "tests/support/thick_wall.h"
#include "tests/verification/blown_body.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double A = inner_radius, B = outer_radius;

std::vector<BlownState> blown_tube(int n)
{
  return blow(quarter_tube(A, B, 0.5, n, 2 * n, 1), {{"x0", {"x"}}, {"y0", {"y"}}, {"z0", {"z"}}, {"z1", {"z"}}},
              {"inner", {0, 0, 0}, {"x", "y"}}, 3);
}

std::vector<BlownState> blown_sphere(int n, double volume_ratio, double step = 0.6)
{
  return blow(eighth_sphere(A, B, n, n), {{"x0", {"x"}}, {"y0", {"y"}}, {"z0", {"z"}}}, {"inner"}, volume_ratio, step);
}

template <class Exact>
double error(const BlownState &point, const Exact &exact)
{
  return point.pressure / exact(point.volume_ratio) - 1;
}

/// Errors on meshes 1, 2, 3 times as fine: small on the middle one, and falling at least like h^2.
template <class Blown, class Exact>
void check_convergence(const std::string &name, const std::string &source, const Blown &blown, const Exact &exact)
{
  double errors[3];
  for (int n = 1; n <= 3; ++n) {
    const auto end = blown(n).back();
    errors[n - 1] = error(end, exact);
    if (n == 2)
      compare(
          {name + ": pressure, middle mesh", source, 1e3 * exact(end.volume_ratio), 1e3 * end.pressure, 1e-3, "kPa"});
  }
  INFO(name << ": errors " << errors[0] << ", " << errors[1] << ", " << errors[2]);
  const double order = std::log(std::abs(errors[0] / errors[2])) / std::log(3.);
  compare({name + ": observed order of the pressure's error", "theory: 4 for quadratic displacements", 2, order, 0, "1",
           Comparison::Kind::at_least});
}

} // namespace

// Equilibrium along the radius: p = int (sigma_hoop - sigma_radial) (dr / r), with the factor 2 on a sphere.
TEST_CASE("closed forms of thick walls agree with the integral of the equilibrium equation")
{
  const double a = 1.5 * A;
  const double tube = integral(
      [&](double r) {
        const double l = r / std::sqrt(r * r - a * a + A * A);
        return wall_mu * (l * l - 1 / (l * l)) / r;
      },
      a, std::sqrt(a * a + B * B - A * A));
  CHECK(tube_pressure(2.25) == Approx(tube).epsilon(1e-9));
  const double sphere = integral(
      [&](double r) {
        const double l = r / std::cbrt(r * r * r - a * a * a + A * A * A);
        return 2 * wall_mu * (l * l - std::pow(l, -4)) / r;
      },
      a, sphere_radius(B, 3.375));
  CHECK(sphere_pressure(3.375) == Approx(sphere).epsilon(1e-9));
}

TEST_CASE("thick tube under inner pressure in plane strain")
{
  check_convergence("thick tube, V / V0 = 3", "incompressible neo-Hookean tube, exact (doc/theory.md)", blown_tube,
                    tube_pressure);
}

TEST_CASE("thick sphere under inner pressure")
{
  check_convergence(
      "thick sphere, V / V0 = 3", "incompressible neo-Hookean sphere, exact (Green and Zerna 1954)",
      [](int n) { return blown_sphere(n, 3); }, sphere_pressure);
}

// Under volume control the path runs through the limit of the pressure. The negative pivots of the tangent at held
// pressure count the unstable modes at that pressure: none before the limit, one after it.
TEST_CASE("thick sphere past its limit pressure")
{
  constexpr double step = 0.2;
  double limit = 1; // V / V0
  for (double ratio = 1; ratio < 20; ratio += 1e-3)
    limit = sphere_pressure(ratio) > sphere_pressure(limit) ? ratio : limit;
  double highest = 0, before = 0, after = 0, to_the_end = 0, last_stable = 0, first_unstable = infinity;
  const auto points = blown_sphere(2, 20, step);
  for (const auto &point : points) {
    const double wrong = std::abs(error(point, sphere_pressure));
    if (point.volume_ratio <= 8 && point.pressure > 0) // the preload is empty
      (point.volume_ratio > limit ? after : before) = std::max(point.volume_ratio > limit ? after : before, wrong);
    to_the_end = std::max(to_the_end, wrong);
    highest = std::max(highest, point.pressure);
    CHECK(point.negative_pivots == (point.volume_ratio > limit ? 1 : 0));
    if (point.negative_pivots == 0)
      last_stable = std::max(last_stable, point.volume_ratio);
    else
      first_unstable = std::min(first_unstable, point.volume_ratio);
  }
  CHECK(points.back().pressure < 0.95 * highest); // well past the limit
  CHECK(first_unstable - last_stable < 1.01 * step);
  const char *source = "incompressible neo-Hookean sphere, exact (Green and Zerna 1954)";
  const auto kind = Comparison::Kind::absolute;
  compare({"thick sphere: largest relative error of pressure before the limit", source, 0, before, 5e-4, "1", kind});
  compare({"thick sphere: the same after it, to V / V0 = 8", source, 0, after, 1e-4, "1", kind});
  compare({"thick sphere: the same on the path to V / V0 = 20", source, 0, to_the_end, 2e-3, "1", kind});
  compare({"thick sphere: limit pressure", source, 1e3 * sphere_pressure(limit), 1e3 * highest, 5e-3, "kPa"});
  compare({"thick sphere: V / V0 where negative pivots go from 0 to 1 (steps of 0.2)", source, limit,
           (last_stable + first_unstable) / 2, step / 2, "1", kind});
}
