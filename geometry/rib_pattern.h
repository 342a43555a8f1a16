// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/corrugation.h"
#include "geometry/mesh.h"
#include "geometry/parameters.h"

namespace ballonet::geometry
{

/// The value of a per-item list: the default where it is empty, the only value for all, else its own.
double list_value(const std::vector<double> &list, int index, double fallback);

/// An angle brought to (-pi, pi].
double wrap_angle(double angle);

/// Point at radius, angle about the axis (rad, from the back wall at -x towards +y) and height.
Point cylinder_point(double radius, double angle, double height);

/// Where ribs, wall lands and wall strips are. Ribs and gaps are counted from 0 at the bottom; gap k lies below rib k,
/// gap 0 stands on the base disc. Angles in rad; chi is measured from a rib's own land.
///
/// A rib's land carries the strips of the gaps below and above it; between ribs of different orientation the strip
/// twists. Where the twist would shear the strip by more than 45 deg the strip stays straight and the lower rib gets
/// a second land in the orientation of the upper one.
class RibPattern
{
public:
  RibPattern(const Ribs &ribs, const Wall &wall);

  int count() const { return ribs_.count; }
  /// Free height between base disc and head, mm.
  double height() const;
  double centre(int rib) const;
  /// Height of a rib's lower and upper edge; the top of the top rib is level.
  double lower(int rib, double chi) const;
  double upper(int rib, double chi) const;
  double orientation(int rib) const;
  /// Half the angle the rib covers: pi for a closed ring.
  double half_arc(int rib) const;

  double wall_radius() const { return ribs_.inner_radius + wall_.thickness / 2; }
  /// Half the angle of the wall and its lands.
  double half_window() const { return wall_.width / 2 / wall_radius(); }

  /// Orientation of the lands at the lower and upper end of a gap's strip.
  double strip_foot(int gap) const;
  double strip_top(int gap) const { return orientation(gap); }
  /// Height of the strip's lower and upper end at eta = -1 ... 1 across the wall.
  double strip_start(int gap, double eta) const;
  double strip_end(int gap, double eta) const;
  Corrugation corrugation(int gap, double eta) const;

  /// Does the rib carry a second land for the strip above it?
  bool has_second_land(int rib) const;

private:
  double offset(int rib, double chi) const;
  bool twists(int gap) const;

  Ribs ribs_;
  Wall wall_;
};

} // namespace ballonet::geometry
