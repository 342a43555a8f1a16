// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <functional>

namespace ballonet::geometry
{

/// An "O-grid" on the unit disc: a core of m x m cells with bulged sides, surrounded by rings of 4 m cells. The angles
/// of the mesh lines on the rim are free, so that discs fit onto rings.
class DiscGrid
{
public:
  /// `angle(index)` of rim line 0 ... rim_count, half indices included; line 0 meets the middle of a core side.
  /// rim_count is a multiple of 8. `core_radius`: mean radius of the core, 0 ... 1.
  DiscGrid(int rim_count, std::function<double(double)> angle, double core_radius);

  int core_count() const { return rim_count_ / 4; }
  /// Polar coordinates (radius 0 ... 1, angle) of a core point, i and j from 0 to core_count().
  std::array<double, 2> core(double i, double j) const;
  /// Polar coordinates of a ring point: rim index, and 0 (core) ... 1 (rim) across the rings.
  std::array<double, 2> ring(double index, double fraction) const;

private:
  std::array<double, 2> core_rim(double index) const;

  int rim_count_;
  std::function<double(double)> angle_;
  double core_radius_;
};

} // namespace ballonet::geometry
