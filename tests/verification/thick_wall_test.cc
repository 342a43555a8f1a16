// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/comparison.h"
#include "tests/support/round_mesh.h"
#include "tests/verification/blown_body.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double A = 1, B = 1.6; // mm, radii at rest

/// Tube in plane strain, incompressible neo-Hookean, thick wall: inner minus outer pressure from
///   p = mu [ln(a B / (b A)) + (B^2 / b^2 - A^2 / a^2) / 2]   with b^2 - a^2 = B^2 - A^2.
double tube_pressure(double volume_ratio)
{
  const double a = A * std::sqrt(volume_ratio), b = std::sqrt(a * a + B * B - A * A);
  return blown_mu * (std::log(a * B / (b * A)) + (B * B / (b * b) - A * A / (a * a)) / 2);
}

double deformed_outer_radius(double a) { return std::cbrt(a * a * a + B * B * B - A * A * A); }

/// Hollow sphere, likewise (Green and Zerna): p = mu / 2 [4 / l + 1 / l^4] from the inner to the outer hoop stretch l.
double sphere_pressure(double volume_ratio)
{
  const double inner = std::cbrt(volume_ratio), outer = deformed_outer_radius(A * inner) / B;
  const auto term = [](double l) { return 4 / l + std::pow(l, -4); };
  return blown_mu / 2 * (term(outer) - term(inner));
}

std::vector<VolumeAndPressure> blown_tube(int n)
{
  return blow(quarter_tube(A, B, 0.5, n, 2 * n, 1), {{"x0", {"x"}}, {"y0", {"y"}}, {"z0", {"z"}}, {"z1", {"z"}}},
              {"inner", {0, 0, 0}, {"x", "y"}}, 3);
}

std::vector<VolumeAndPressure> blown_sphere(int n, double volume_ratio)
{
  return blow(eighth_sphere(A, B, n, n), {{"x0", {"x"}}, {"y0", {"y"}}, {"z0", {"z"}}}, {"inner"}, volume_ratio);
}

template <class Exact>
double error(const VolumeAndPressure &point, const Exact &exact)
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
        return blown_mu * (l * l - 1 / (l * l)) / r;
      },
      a, std::sqrt(a * a + B * B - A * A));
  CHECK(tube_pressure(2.25) == Approx(tube).epsilon(1e-9));
  const double sphere = integral(
      [&](double r) {
        const double l = r / std::cbrt(r * r * r - a * a * a + A * A * A);
        return 2 * blown_mu * (l * l - std::pow(l, -4)) / r;
      },
      a, deformed_outer_radius(a));
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

TEST_CASE("thick sphere past its limit pressure")
{
  const auto points = blown_sphere(2, 20);
  double highest = 0, worst = 0, limit = 0;
  for (const auto &point : points) {
    highest = std::max(highest, point.pressure);
    if (std::abs(error(point, sphere_pressure)) > std::abs(worst))
      worst = error(point, sphere_pressure);
  }
  for (double ratio = 1; ratio < 20; ratio += 0.01)
    limit = std::max(limit, sphere_pressure(ratio));
  CHECK(points.back().pressure < 0.95 * highest); // well past the limit
  const char *source = "incompressible neo-Hookean sphere, exact (Green and Zerna 1954)";
  compare({"thick sphere, V / V0 = 1 to 20: largest error of pressure along the path", source, 0, worst, 2e-3, "1",
           Comparison::Kind::absolute});
  compare({"thick sphere: limit pressure", source, 1e3 * limit, 1e3 * highest, 5e-3, "kPa"});
}
