// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/verification/blown_body.h"
#include "tests/support/thick_wall.h"
#include <catch2/catch.hpp>
#include <cmath>

namespace ballonet::tests
{

using namespace solver;

std::vector<BlownState> blow(const Mesh &mesh, const std::vector<Support> &supports, const Cavity &cavity,
                             double volume_ratio, double step)
{
  Parameters parameters;
  parameters.materials.resize(1);
  auto &rubber = parameters.materials[0];
  rubber.name = "rubber", rubber.c10 = wall_mu / 2, rubber.d1 = 2e-6 / wall_mu;
  parameters.bodies = {{"body", "rubber", true}};
  parameters.supports = supports;
  parameters.cavity = cavity;
  auto &path = parameters.path;
  path.volume_max = volume_ratio, path.volume_rate = 1;
  path.step_initial = 0.2, path.step_max = step, path.inertia = false;
  parameters.newton = {.tolerance = 1e-8, .force_floor = 1e-3};
  Simulation simulation(parameters, mesh, MPI_COMM_SELF);
  std::vector<BlownState> points;
  const auto result = simulation.run(
      [&](const PathPoint &point) {
        points.push_back({point.progress.volume / point.reference_volume, point.progress.state.pressure,
                          point.newton.negative_pivots});
        return "";
      },
      [](const std::string &) {});
  INFO(result.reason);
  REQUIRE(result.status == PathStatus::ended);
  return points;
}

double integral(const std::function<double(double)> &f, double a, double b)
{
  constexpr int intervals = 200;
  const double h = (b - a) / intervals, offset = h / 2 * std::sqrt(0.6);
  double sum = 0;
  for (int i = 0; i < intervals; ++i) {
    const double middle = a + (i + 0.5) * h;
    sum += h / 18 * (5 * f(middle - offset) + 8 * f(middle) + 5 * f(middle + offset));
  }
  return sum;
}

} // namespace ballonet::tests
