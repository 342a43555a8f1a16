// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/reduced/parameters.h"

namespace ballonet::solver::reduced
{

/// The balloon's bulge through the front of a gap opened by an angle `th` (rad), with the balloon stretched to z on its
/// axis and lying on the ribs. Thin wall of middle radius R at rest. Front gap and meridian stretch there:
///     g_f = g + (e + Ri) th,   z_f = z (1 + Ri th / (p + e th))
/// Two ways of feeding the bulge are bounds: slip (frictionless along the ribs) and stick (stretched within the gap).
class GapBulge
{
public:
  /// `lever`: e of the hinge, mm.
  GapBulge(const Parameters &parameters, double lever);

  double front_gap(double th) const; ///< g_f, mm

  /// sin(phi) = g_f q / (2 T) of the slipping arc, with q the pressure the balloon's own hoop stress does not carry and
  /// T the meridian tension per width. 1 or more: no equilibrium, the balloon runs out of the gap.
  double slip_ratio(double pressure, double z, double th) const;

  /// Apex height of the slipping bulge beyond Ri, mm: (g_f / 2) tan(phi / 2); 0 without excess pressure, infinite when
  /// it runs out.
  double slip_height(double pressure, double z, double th) const;

  /// Pressure at which the balloon runs out of the gap, MPa.
  double runaway_pressure(double z, double th) const;

  /// Pressure at which the slipping bulge is `height` high, MPa; the runaway pressure if it runs out before.
  double slip_pressure(double height, double z, double th) const;

  /// Pressure at which the sticking bulge is `height` high, MPa.
  double stick_pressure(double height, double z, double th) const;

private:
  struct Wall {
    double hoop_pressure, tension;
  };
  /// A wall whose outer radius is r, at meridian stretch z_f.
  Wall wall(double r, double z_f) const;
  double front_stretch(double z, double th) const;

  double mu_, thickness_, middle_radius_, gap_, pitch_, cage_radius_, lever_;
};

} // namespace ballonet::solver::reduced
