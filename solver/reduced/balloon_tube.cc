// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/balloon_tube.h"
#include "solver/reduced/root.h"
#include <algorithm>
#include <cmath>

namespace ballonet::solver::reduced
{

using std::numbers::pi;

BalloonTube::BalloonTube(const Balloon &balloon)
    : A_(balloon.diameter / 2 - balloon.wall), B_(balloon.diameter / 2), length_(balloon.length), mu_(2 * balloon.c10),
      D_(B_ * B_ - A_ * A_)
{
}

double BalloonTube::inner_radius(double z, double b) const { return std::sqrt(b * b - D_ / z); }

double BalloonTube::lambda(double z, double b) const { return std::log(inner_radius(z, b) * B_ / (b * A_)); }

double BalloonTube::pressure(double z, double b) const
{
  const double a = inner_radius(z, b);
  return mu_ * (lambda(z, b) / z + (B_ * B_ / (b * b) - A_ * A_ / (a * a)) / (2 * z * z));
}

double BalloonTube::pressure_per_radius(double z, double b) const
{
  const double s = b * b - D_ / z; // a^2
  return mu_ * ((b / s - 1 / b) / z + (A_ * A_ * b / (s * s) - B_ * B_ / (b * b * b)) / (z * z));
}

double BalloonTube::reduced_force(double z, double b) const
{
  return pi * mu_ * (D_ * (z - 1 / (z * z)) - (b * b - B_ * B_ / z) * lambda(z, b) / z);
}

double BalloonTube::axial_stiffness(double z, double b) const
{
  const double s = b * b - D_ / z, E = b * b - B_ * B_ / z, L = lambda(z, b), z2 = z * z, z3 = z2 * z;
  const double dFred = pi * mu_ * (D_ * (1 + 2 / z3) - B_ * B_ * L / z3 + E * L / z2 - E * D_ / (2 * z3 * s));
  const double dp = mu_ * (D_ / (2 * z3 * s) - L / z2 + A_ * A_ * D_ / (2 * z2 * z2 * s * s) -
                           (B_ * B_ / (b * b) - A_ * A_ / s) / z3);
  return dFred + pi * (dp * s + pressure(z, b) * D_ / z2);
}

double BalloonTube::bending_stiffness(double z, double b) const
{
  const double r = (inner_radius(z, b) + b) / 2;
  return axial_stiffness(z, b) * r * r / 2;
}

double BalloonTube::outer_radius_unloaded(double z) const { return B_ / std::sqrt(z); }

double BalloonTube::cross_section() const { return pi * B_ * B_; }

double BalloonTube::thrust(double z, double b, double contact_pressure) const
{
  return contact_pressure * pi * b * b - reduced_force(z, b);
}

std::optional<double> BalloonTube::radius_at_thrust(double z, double thrust, double largest) const
{
  const double smallest = outer_radius_unloaded(z);
  const auto excess = [&](double b) { return -reduced_force(z, b) - thrust; };
  if (smallest >= largest || excess(smallest) > 0 || excess(largest) < 0)
    return {};
  return find_root(excess, smallest, largest);
}

BalloonTube::FreeState BalloonTube::free_state(double b) const
{
  // At z = 1 the tube pushes (Fred < 0); a stretch at which the wall alone resists is beyond equilibrium.
  const auto force = [&](double z) { return reduced_force(z, b); };
  double high = 1.5;
  while (force(high) < 0)
    high *= 1.5;
  const double z = find_root(force, 1.0, high);
  return {pressure(z, b), b, z};
}

BalloonTube::FreeState BalloonTube::limit() const
{
  const auto p = [&](double b) { return free_state(b).pressure; };
  return free_state(find_maximum(p, 1.001 * B_, 2.5 * B_));
}

std::optional<BalloonTube::FreeState> BalloonTube::free_state_at_stretch(double z) const
{
  const FreeState top = limit();
  if (z <= 1 || z > top.axial_stretch)
    return {};
  const auto stretch = [&](double b) { return free_state(b).axial_stretch - z; };
  return free_state(find_root(stretch, (1 + 1e-9) * B_, top.outer_radius));
}

double thin_limit_pressure(const Balloon &balloon)
{
  const auto pressure = [](double hoop) { // over mu t / R, with the axial stretch of the free closed tube
    const double h2 = hoop * hoop, z2 = (h2 + std::sqrt(h2 * h2 + 8 / h2)) / 4;
    return (1 - 1 / (h2 * h2 * z2)) / std::sqrt(z2);
  };
  const double middle_radius = (balloon.diameter - balloon.wall) / 2;
  return 2 * balloon.c10 * balloon.wall / middle_radius * pressure(find_maximum(pressure, 1, 3));
}

} // namespace ballonet::solver::reduced
