// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/// Incompressible neo-Hookean tube (plane strain) and hollow sphere under inner pressure, with a wall as thick as the
/// inner radius times 0.6. Closed forms in `volume_ratio`, the cavity's V / V0; pressures in MPa, lengths in mm.
namespace ballonet::tests
{

constexpr double inner_radius = 1, outer_radius = 1.6;
/// Coefficient mu of the incompressible neo-Hookean walls, MPa.
constexpr double wall_mu = 0.3;

/// Inner minus outer pressure of the tube,
///   p = mu [ln(a B / (b A)) + (B^2 / b^2 - A^2 / a^2) / 2]   with b^2 - a^2 = B^2 - A^2.
double tube_pressure(double volume_ratio);

/// Inner minus outer pressure of the sphere (Green and Zerna 1954),
///   p = mu / 2 [4 / l + 1 / l^4] from the inner to the outer hoop stretch l.
double sphere_pressure(double volume_ratio);

/// Where a point at the distance R from the axis (tube) or centre (sphere) goes.
double tube_radius(double R, double volume_ratio);
double sphere_radius(double R, double volume_ratio);

} // namespace ballonet::tests
