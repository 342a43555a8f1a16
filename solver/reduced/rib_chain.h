// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/reduced/hinge.h"
#include <optional>
#include <span>
#include <vector>

namespace ballonet::solver::reduced
{

/// Absolute angles al_i of the units from upright, rad, from the bottom; positive towards the back wall.
using Angles = std::vector<double>;

/// One rigid unit of the chain: a gap's wall, the rib above it, and the balloon within; the top one carries the head.
/// Its axes start at its hinge: u = (-sin al, cos al) along the wall, v = (cos al, sin al) towards the ribs.
struct Unit {
  double mass = 0;       ///< t
  double along = 0;      ///< mm, of its centre of mass along u (z_i)
  double across = 0;     ///< mm, along v (c_i)
  double rotary = 0;     ///< t mm^2, about the centre of mass
  double mass_above = 0; ///< t, of all units above
};

/// What of the balloon's weight the chain carries.
enum class Load { backbone, with_balloon };

/// The backbone as a planar chain of rigid units on equal elastic hinges, for large rotations. Hinge i sits a pitch
/// above hinge i - 1; a gap's wall, its rib and its share of the balloon have their centres half a pitch above it, the
/// rib and balloon one lever e in front of it; the head sits on the top rib. The rotary inertia of a unit is that of a
/// thin ring of the rib's middle radius Rm, m Rm^2 / 2. (Positions and inertia are those that reproduce the reference.)
class RibChain
{
public:
  RibChain(const Parameters &parameters, const Hinge &hinge, Load load);

  std::size_t size() const { return units_.size(); }
  const std::vector<Unit> &units() const { return units_; }
  double pitch() const { return pitch_; }
  double moving_mass() const { return units_[0].mass + units_[0].mass_above; } ///< t

  /// k (th_i - th_{i+1}) + dV_g / dal_i with the gap angles th and the stiffness k of a hinge, N mm. The moment M of a
  /// thrust that is uniform along the chain appears at the top unit only.
  std::vector<double> residual(const Angles &al, double k) const;

  /// Diagonal of d residual / d al; beside it stands -k.
  std::vector<double> tangent_diagonal(const Angles &al, double k) const;

  /// Stable equilibrium under the weight alone, followed from weightless; nothing if there is none on the way.
  std::optional<Angles> droop(double k) const;

  struct Held {
    Angles al;
    double moment; ///< N mm, that holds the top unit at its angle
  };
  /// Equilibrium with the top unit held at `tip_angle`, by Newton's method from `guess`; nothing if it does not
  /// converge.
  std::optional<Held> hold(double tip_angle, double k, Angles guess) const;

private:
  bool relax(Angles &al, double k, double weight, bool tip_is_held) const;
  double gravity_force(std::size_t i, double al) const;
  double gravity_stiffness(std::size_t i, double al) const;

  double pitch_, gravity_;
  std::vector<Unit> units_;
};

/// th_i = al_i - al_{i-1}, rad.
std::vector<double> gap_angles(const Angles &al);

/// Weight of the moving units times H^2 / (k p): the upright chain buckles at 7.84 (continuum), at 7.27 with 20 hinges.
double self_weight_number(const RibChain &chain, double k, double gravity);

} // namespace ballonet::solver::reduced
