// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace ballonet::geometry
{

/// A point of the corrugation's middle line and the unit normal there, in (axial, outward) coordinates.
struct FoldPoint {
  double axial, height;
  double normal_axial, normal_height;
};

/// The middle line of the wall over one gap: valley arc, straight flank, crest arc and back, all tangent to each
/// other, starting and ending along the axis. The wall leaves the land it hangs on straight, so the faces meet.
///
/// With turning angle phi, valley radius rho, crest radius c and flank length s:
///   gap / 2 = (rho + c) sin phi + s cos phi,   rise = (rho + c) (1 - cos phi) + s sin phi.
/// rise <= gap / 2: no flank, phi = 2 atan(2 rise / gap). rise > gap / 2: phi = 90 deg, s = rise - gap / 2.
/// At rise = gap / 2 these are four quarter circles of developed length pi * rise: the length, and so the bending
/// stiffness, of a semicircle of radius rise.
class Corrugation
{
public:
  /// valley_share = rho / (rho + c), 0 < valley_share < 1.
  Corrugation(double gap, double rise, double valley_share);

  double length() const { return 2 * half_length_; }
  /// The smaller of valley and crest radius; infinite for a plain wall. Half the wall's thickness must stay below it.
  double smallest_radius() const;
  /// The point at a fraction 0 ... 1 of the developed length.
  FoldPoint at(double fraction) const;

private:
  FoldPoint first_half(double arc_length) const;

  double gap_, angle_ = 0, valley_ = 0, crest_ = 0, flank_ = 0, half_length_;
};

} // namespace ballonet::geometry
