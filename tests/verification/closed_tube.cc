// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/verification/closed_tube.h"
#include "tests/verification/blown_body.h"
#include <cmath>

namespace ballonet::tests
{

// With the axial stretch z a material radius R goes to r, r^2 = b^2 - (B^2 - R^2) / z; hoop stretch l = r / R, radial
// stretch 1 / (l z). Radial equilibrium gives the pressure, and with it the force that the ends need beside the
// pressure on them: F = 2 pi int [sigma_zz - (sigma_rr + sigma_tt) / 2] r dr, which vanishes for a closed tube.

double ClosedTube::pressure(double z, double b) const
{
  const double a = std::sqrt(b * b - (outer * outer - inner * inner) / z);
  return integral(
      [&](double r) {
        const double l2 = r * r / (outer * outer - z * (b * b - r * r));
        return mu * (l2 - 1 / (l2 * z * z)) / r;
      },
      a, b);
}

double ClosedTube::axial_force(double z, double b) const
{
  const double a = std::sqrt(b * b - (outer * outer - inner * inner) / z);
  return integral(
      [&](double r) {
        const double l2 = r * r / (outer * outer - z * (b * b - r * r));
        return 2 * M_PI * mu * (z * z - (l2 + 1 / (l2 * z * z)) / 2) * r;
      },
      a, b);
}

ClosedTube::State ClosedTube::at_radius(double b) const
{
  double low = 0.9, high = 2;
  for (int i = 0; i < 50; ++i)
    (axial_force((low + high) / 2, b) < 0 ? low : high) = (low + high) / 2;
  return {low, b, pressure(low, b)};
}

ClosedTube::State ClosedTube::limit() const
{
  State best{};
  for (double b = outer; b < 2 * outer; b += outer / 500)
    if (const State state = at_radius(b); state.pressure > best.pressure)
      best = state;
  return best;
}

ClosedTube::State ClosedTube::at_pressure(double p) const
{
  double low = outer, high = limit().outer_radius;
  for (int i = 0; i < 50; ++i)
    (at_radius((low + high) / 2).pressure < p ? low : high) = (low + high) / 2;
  return at_radius(low);
}

} // namespace ballonet::tests
