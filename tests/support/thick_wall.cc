// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/thick_wall.h"
#include <cmath>

namespace ballonet::tests
{

namespace
{
constexpr double A = inner_radius, B = outer_radius;
}

double tube_radius(double R, double volume_ratio) { return std::sqrt(R * R + A * A * (volume_ratio - 1)); }

double sphere_radius(double R, double volume_ratio) { return std::cbrt(R * R * R + A * A * A * (volume_ratio - 1)); }

double tube_pressure(double volume_ratio)
{
  const double a = tube_radius(A, volume_ratio), b = tube_radius(B, volume_ratio);
  return wall_mu * (std::log(a * B / (b * A)) + (B * B / (b * b) - A * A / (a * a)) / 2);
}

double sphere_pressure(double volume_ratio)
{
  const auto term = [](double l) { return 4 / l + std::pow(l, -4); };
  return wall_mu / 2 * (term(sphere_radius(B, volume_ratio) / B) - term(sphere_radius(A, volume_ratio) / A));
}

} // namespace ballonet::tests
