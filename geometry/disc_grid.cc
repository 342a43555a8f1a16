// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/disc_grid.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace ballonet::geometry
{

namespace
{

using Plane = std::array<double, 2>;

/// How far the core's corners stick out over the circle: 0 circle, 1 square.
constexpr double squareness = 0.5;

Plane polar(const Plane &p) { return {std::hypot(p[0], p[1]), std::atan2(p[1], p[0])}; }

} // namespace

DiscGrid::DiscGrid(int rim_count, std::function<double(double)> angle, double core_radius)
    : rim_count_(rim_count), angle_(std::move(angle)), core_radius_(core_radius)
{
}

Plane DiscGrid::core_rim(double index) const
{
  const double side = rim_count_ / 4.;
  const double along = std::abs(std::remainder(index, side)) / (side / 2); // 0 middle of a side, 1 corner
  const double radius = core_radius_ * (1 + squareness * (std::hypot(1., along) - 1));
  return {radius * std::cos(angle_(index)), radius * std::sin(angle_(index))};
}

Plane DiscGrid::core(double i, double j) const
{
  const double m = core_count(), n = rim_count_, u = i / m, v = j / m;
  const auto right = core_rim(j - m / 2), left = core_rim(n / 2 + m / 2 - j);
  const auto top = core_rim(n / 4 + m / 2 - i), bottom = core_rim(3 * n / 4 - m / 2 + i);
  const auto right_top = core_rim(m / 2), left_top = core_rim(3 * m / 2), left_bottom = core_rim(5 * m / 2),
             right_bottom = core_rim(7 * m / 2);
  Plane p{};
  for (unsigned d = 0; d < 2; ++d)
    p[d] = u * right[d] + (1 - u) * left[d] + v * top[d] + (1 - v) * bottom[d] - u * v * right_top[d] -
           (1 - u) * v * left_top[d] - (1 - u) * (1 - v) * left_bottom[d] - u * (1 - v) * right_bottom[d];
  return polar(p);
}

Plane DiscGrid::ring(double index, double fraction) const
{
  const Plane inner = core_rim(index);
  const double radius = std::hypot(inner[0], inner[1]);
  return {radius + fraction * (1 - radius), angle_(index)};
}

} // namespace ballonet::geometry
