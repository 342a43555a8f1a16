// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/simulation.h"
#include "tests/support/comparison.h"
#include "tests/support/round_mesh.h"
#include <catch2/catch.hpp>
#include <cmath>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double mu = 0.3, inner = 1, outer = 1.6; // MPa, mm
constexpr double step = 0.2;                       // of V / V0

/// Incompressible neo-Hookean hollow sphere (Green and Zerna 1954): p = mu / 2 [4 / l + 1 / l^4] from the inner to the
/// outer hoop stretch l.
double exact_pressure(double volume_ratio)
{
  const double grown = (volume_ratio - 1) * std::pow(inner, 3);
  const auto term = [&](double radius) {
    const double l = std::cbrt(1 + grown / std::pow(radius, 3));
    return 4 / l + std::pow(l, -4);
  };
  return mu / 2 * (term(outer) - term(inner));
}

/// V / V0 where the exact pressure is largest, by golden section.
double exact_limit()
{
  double low = 1, high = 20;
  while (high - low > 1e-8) {
    const double a = high - 0.618 * (high - low), b = low + 0.618 * (high - low);
    exact_pressure(a) < exact_pressure(b) ? low = a : high = b;
  }
  return low;
}

struct Point {
  double volume_ratio, pressure; ///< V / V0, MPa
  int negative_pivots;
};

std::vector<Point> inflated()
{
  Parameters p;
  p.materials.resize(1);
  auto &rubber = p.materials[0];
  rubber.name = "rubber", rubber.c10 = mu / 2, rubber.d1 = 2e-6 / mu;
  p.bodies = {{"body", "rubber", true}};
  p.supports = {{"x0", {"x"}}, {"y0", {"y"}}, {"z0", {"z"}}};
  p.cavity = Cavity{"inner"};
  p.path.volume_max = 8, p.path.volume_rate = 1, p.path.inertia = false;
  p.path.step_initial = p.path.step_max = step;
  p.newton = {.tolerance = 1e-8, .force_floor = 1e-3};
  const auto mesh = eighth_sphere(inner, outer, 2, 2);
  Simulation simulation(p, mesh, MPI_COMM_SELF);
  std::vector<Point> points;
  const auto result = simulation.run(
      [&](const PathPoint &point) {
        if (point.progress.state.pressure > 0) // past the preload, which is empty
          points.push_back({point.progress.volume / point.reference_volume, point.progress.state.pressure,
                            point.newton.negative_pivots});
        return "";
      },
      [](const std::string &) {});
  INFO(result.reason);
  REQUIRE(result.status == PathStatus::ended);
  return points;
}

} // namespace

// Under volume control the path runs through the limit of the pressure. The number of negative pivots of the tangent at
// held pressure counts the unstable modes at that pressure: none before the limit, one after it.
TEST_CASE("limit point: a thick sphere under volume control")
{
  const double limit = exact_limit();
  double worst[2] = {0, 0}, last_stable = 0, first_unstable = infinity;
  for (const auto &point : inflated()) {
    double &error = worst[point.volume_ratio > limit];
    error = std::max(error, std::abs(point.pressure / exact_pressure(point.volume_ratio) - 1));
    CHECK(point.negative_pivots == (point.volume_ratio > limit ? 1 : 0));
    if (point.negative_pivots == 0)
      last_stable = std::max(last_stable, point.volume_ratio);
    else
      first_unstable = std::min(first_unstable, point.volume_ratio);
  }
  const char *source = "incompressible neo-Hookean sphere, exact (Green and Zerna 1954)";
  const auto kind = Comparison::Kind::absolute;
  compare({"limit point: largest relative error of pressure before it", source, 0, worst[0], 5e-4, "1", kind});
  compare({"limit point: largest relative error of pressure after it, to V / V0 = 8", source, 0, worst[1], 1e-4, "1",
           kind});
  compare({"limit point: V / V0 where negative pivots go from 0 to 1 (steps of 0.2)", source, limit,
           (last_stable + first_unstable) / 2, step / 2, "1", kind});
  CHECK(first_unstable - last_stable < 1.01 * step);
}
