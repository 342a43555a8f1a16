// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

namespace ballonet::geometry
{

/// A part of a circle that needs its own number of elements: the wall's land.
struct Window {
  double centre, half_angle; // rad
  int elements;
};

/// The mesh lines around a ring: `count` elements over 360 deg. They start at the centre of the first window, pass
/// through all window edges and the given extra stops, and are spread evenly between those.
class RingLines
{
public:
  RingLines(int count, const std::vector<Window> &windows, const std::vector<double> &stops);

  int count() const { return static_cast<int>(lines_.size()) - 1; }
  /// Angle at a line (whole number) or half-way between two; any number of turns.
  double angle(double index) const;

private:
  std::vector<double> lines_;
};

} // namespace ballonet::geometry
