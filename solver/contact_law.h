// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <cmath>

namespace ballonet::solver
{

/// Contact pressure over penetration g (mm): eps g^2 / (2 g0) up to the onset g0, then the straight line
/// eps (g - g0 / 2) that continues it with the same slope. Zero for g <= 0.
struct ContactLaw {
  double stiffness; ///< eps, MPa/mm
  double onset;     ///< g0, mm; may be zero

  /// Energy per area, N/mm.
  double energy(double g) const
  {
    if (g <= 0)
      return 0;
    if (g < onset)
      return stiffness * g * g * g / (6 * onset);
    return stiffness * (g * g / 2 - g * onset / 2 + onset * onset / 6);
  }

  /// Derivative of the energy, MPa.
  double pressure(double g) const
  {
    if (g <= 0)
      return 0;
    return g < onset ? stiffness * g * g / (2 * onset) : stiffness * (g - onset / 2);
  }

  /// Derivative of the pressure, MPa/mm.
  double slope(double g) const
  {
    if (g <= 0)
      return 0;
    return g < onset ? stiffness * g / onset : stiffness;
  }
};

} // namespace ballonet::solver
