// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/reduced/parameters.h"
#include <optional>

namespace ballonet::solver::reduced
{

/// Thick-walled, incompressible neo-Hookean tube W = C10 (I1 - 3), mu = 2 C10, inflated uniformly: exact. Its state is
/// the axial stretch z and the current outer radius b (mm). Reference radii A (inner) and B (outer), mm. With the
/// current inner radius a, Lambda = ln(a B / (b A)) and E = b^2 - B^2 / z:
///     p    = mu [Lambda / z + (B^2 / b^2 - A^2 / a^2) / (2 z^2)]
///     Fred = pi mu [(B^2 - A^2) (z - 1 / z^2) - E Lambda / z]
/// (integrals of the stress over the wall; Fred is the force of the wall less that of the pressures on its ends).
class BalloonTube
{
public:
  explicit BalloonTube(const Balloon &balloon);

  /// A free, closed tube at rest under its pressure.
  struct FreeState {
    double pressure;      ///< MPa
    double outer_radius;  ///< mm
    double axial_stretch; ///< 1
  };

  double inner_radius(double z, double b) const;        ///< mm
  double pressure(double z, double b) const;            ///< inner minus outer, MPa
  double pressure_per_radius(double z, double b) const; ///< d pressure / d b at fixed z, MPa/mm
  double reduced_force(double z, double b) const;       ///< Fred, N; wall force less a^2 pi P plus b^2 pi q
  double axial_stiffness(double z, double b) const;     ///< d (Fred + p pi a^2) / d z at fixed b, N
  double bending_stiffness(double z, double b) const;   ///< axial_stiffness r^2 / 2, r = (a + b) / 2, N mm^2
  double outer_radius_unloaded(double z) const;         ///< b at p = 0, mm
  double length() const { return length_; }             ///< mm
  double cross_section() const;                         ///< pi B^2, mm^2
  double thrust(double z, double b, double contact_pressure) const; ///< on the head: q pi b^2 - Fred, N

  /// The outer radius up to `largest` at which the tube pushes with `thrust` without contact; nothing if that needs a
  /// radius beyond `largest` or a pressure below zero. Unique: Fred falls with b wherever p > 0.
  std::optional<double> radius_at_thrust(double z, double thrust, double largest) const;

  /// Free closed tube blown to an outer radius b > B.
  FreeState free_state(double b) const;

  /// The limit of the free closed tube: the largest pressure it has an equilibrium for.
  FreeState limit() const;

  /// The free closed tube at an axial stretch, on the branch before its limit; nothing if it never gets there.
  std::optional<FreeState> free_state_at_stretch(double z) const;

private:
  double lambda(double z, double b) const;

  double A_, B_, length_, mu_, D_; // D = B^2 - A^2
};

/// The same limit for a thin wall of middle radius R: hoop stretch 1.577, axial stretch 1.178, P = 0.7499 mu t / R.
double thin_limit_pressure(const Balloon &balloon);

} // namespace ballonet::solver::reduced
