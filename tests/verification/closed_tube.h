// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace ballonet::tests
{

/// A long closed tube of incompressible neo-Hookean material under inner pressure, thick wall, exact: the axial force
/// in the wall balances the pressure on the closed ends.
struct ClosedTube {
  double inner, outer, mu; ///< mm at rest, MPa

  struct State {
    double stretch, outer_radius, pressure; ///< axial; mm; MPa
  };
  /// At a present outer radius, mm.
  State at_radius(double b) const;
  /// At the largest pressure.
  State limit() const;
  /// At a pressure below the limit, before it.
  State at_pressure(double p) const;

private:
  double pressure(double z, double b) const;
  double axial_force(double z, double b) const;
};

} // namespace ballonet::tests
