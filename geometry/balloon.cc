// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/balloon.h"
#include "geometry/disc_grid.h"
#include "geometry/rib_pattern.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ballonet::geometry
{

namespace
{

using std::numbers::pi;

/// A point of the dome: polar coordinates of the unit disc wound onto the sphere around (0, 0, centre).
Point dome_point(const std::array<double, 2> &disc, double radius, double centre)
{
  const double from_axis = disc[0] * pi / 2;
  return cylinder_point(radius * std::sin(from_axis), disc[1], centre + radius * std::cos(from_axis));
}

void add_dome(BlockMesh &blocks, const Balloon &balloon, const MeshSizes &sizes)
{
  const int around = sizes.balloon_around, through = sizes.balloon_through, rings = sizes.dome_rings;
  const double outer = balloon.diameter / 2, centre = balloon.length - outer;
  const DiscGrid grid(
      around, [around](double index) { return 2 * pi * index / around; }, 0.5);
  const auto radius = [&](double k) { return outer - balloon.wall * (1 - k / through); };
  const CellTag core{
      Part::balloon, 0, false, {Side::none, Side::none, Side::none, Side::none, Side::inner, Side::outer}};
  const auto core_map = [&](double i, double j, double k) { return dome_point(grid.core(i, j), radius(k), centre); };
  blocks.add("balloon", {grid.core_count(), grid.core_count(), through}, core_map, core);
  const auto ring_map = [&](double i, double j, double k) {
    return dome_point(grid.ring(i, j / rings), radius(k), centre);
  };
  blocks.add("balloon", {around, rings, through}, ring_map, core);
}

} // namespace

void add_balloon(BlockMesh &blocks, const Balloon &balloon, const MeshSizes &sizes, double pitch)
{
  const int around = sizes.balloon_around, through = sizes.balloon_through;
  const double outer = balloon.diameter / 2, tube = balloon.length - outer;
  const int along = std::max(1, static_cast<int>(std::lround(tube * sizes.balloon_per_pitch / pitch)));
  const auto map = [&](double i, double j, double k) {
    return cylinder_point(outer - balloon.wall * (1 - k / through), 2 * pi * i / around, tube * j / along);
  };
  const CellTag tag{
      Part::balloon, 0, false, {Side::none, Side::none, Side::lower, Side::none, Side::inner, Side::outer}};
  blocks.add("balloon", {around, along, through}, map, tag);
  add_dome(blocks, balloon, sizes);
}

} // namespace ballonet::geometry
