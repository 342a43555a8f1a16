// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/hinge.h"
#include <cmath>

namespace ballonet::solver::reduced
{
namespace
{

struct ArchIntegrals {
  double S = 0, Y1 = 0, Y2 = 0, Sx = 0;
};

/// By Simpson's rule; 400 intervals are exact to 10 digits unless the arch is a needle.
ArchIntegrals integrate_arch(double gap, double rise)
{
  constexpr int n = 400;
  constexpr double h = std::numbers::pi / n;
  ArchIntegrals sum;
  for (int i = 0; i <= n; ++i) {
    const double weight = (i == 0 || i == n ? 1 : i % 2 ? 4 : 2) * h / 3;
    const double dx = gap / 2 * std::sin(i * h), dy = rise * std::cos(i * h), y = rise * std::sin(i * h);
    const double ds = std::hypot(dx, dy);
    sum.S += weight * ds;
    sum.Y1 += weight * y * ds;
    sum.Y2 += weight * y * y * ds;
    sum.Sx += ds > 0 ? weight * dx * dx / ds : 0;
  }
  return sum;
}

/// Share of the section's bending in [N mm/rad] per axial stiffness and width, of an arc of radius R and width w.
double curvature_factor(double R, double w)
{
  const double beta = w / (2 * R), sine = std::sin(beta);
  return R * R * R * (beta + std::sin(2 * beta) / 2 - 2 * sine * sine / beta);
}

} // namespace

Hinge make_hinge(const Parameters &parameters)
{
  const Wall &wall = parameters.wall;
  const ArchIntegrals arch = integrate_arch(parameters.ribs.gap, wall.rise);
  const double t = wall.thickness, E = wall.youngs_modulus, nu = wall.poisson_ratio;
  const double bending = E * t * t * t / (12 * (1 - nu * nu));
  const double axial = 1 / ((arch.Y2 - arch.Y1 * arch.Y1 / arch.S) / bending + arch.Sx / (E * t)); // per width
  const double wall_radius = parameters.ribs.inner_radius + t / 2;
  Hinge hinge;
  hinge.strip_stiffness = bending * wall.width / arch.S;
  hinge.curvature_stiffness = wall.curved ? axial * curvature_factor(wall_radius, wall.width) : 0;
  hinge.axial_stiffness = axial * wall.width;
  hinge.lever = wall_radius + arch.Y1 / arch.S;
  hinge.fold_length = arch.S;
  return hinge;
}

} // namespace ballonet::solver::reduced
