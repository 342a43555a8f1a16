// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/reduced/balloon_tube.h"
#include "solver/reduced/gap_bulge.h"
#include "solver/reduced/state.h"
#include <optional>

namespace ballonet::solver::reduced
{

/// A balloon in a ribbed backbone: the tube, the chain and what couples them. The balloon is frictionless, so its
/// thrust F is the same along it and bends every gap by M = F e; its length follows the head,
///     z = (H + e al_N + u_wall) / L,   u_wall = N max(F, 0) / k_u,
/// and its own bending stiffness k_b = (dN/dz) (r^2 / 2) N / L stands beside the hinges'. The tube's tip is bonded to
/// the head: it may also pull. (That a pull does not shorten the wall is what reproduces the reference.)
class PebsModel
{
public:
  /// Throws std::invalid_argument if the parameters are out of range.
  explicit PebsModel(const Parameters &parameters);

  const Parameters &parameters() const { return parameters_; }
  const Hinge &hinge() const { return hinge_; }
  const BalloonTube &tube() const { return tube_; }
  const RibChain &chain() const { return chain_; } ///< with the balloon's weight
  const GapBulge &gap_bulge() const { return gap_bulge_; }

  double stretch(double angle, double wall_lengthening) const; ///< z at a head angle (rad) and u_wall (mm)
  double wall_lengthening(double thrust) const;                ///< u_wall, mm
  double balloon_stiffness(double z, double b) const;          ///< k_b, N mm/rad per gap

  /// Angle at which the balloon has its own length: with smaller ones the pressure is below zero. rad
  double natural_angle() const;

  /// Static equilibrium with the head held at an angle (rad) by the pressure. `near`, a state at an angle nearby,
  /// chooses the branch and is where the search starts; by default, the straight chain. Nothing if there is no
  /// equilibrium at a pressure of zero or more, or if it is not found.
  std::optional<State> state_at(double angle) const;
  std::optional<State> state_at(double angle, const State &near) const;

  /// The same with u_wall (mm) given instead of solved for.
  std::optional<State> state_at_lengthening(double angle, double wall_lengthening, const State &near) const;

  /// Where a search may start: the straight chain and the balloon at rest.
  State straight() const;

  /// Fills the bulge at the widest gap and the stage, which does not fall below `earlier`.
  void judge(State &state, Stage earlier) const;

  /// What the actuator gives while its head is held at an angle.
  struct Forces {
    double thrust;      ///< N, on the head
    double base_moment; ///< N mm, F e
    double tip_force;   ///< N, F e / (H + head thickness): of a stop at the head's top
    bool touches_ribs;
  };
  /// Forces of the balloon lying on the ribs, F = (P - p(z, Ri)) pi Ri^2 - Fred; below the pressure p(z, Ri) it only
  /// gets there by a snap, and would not stay without the ribs holding it back.
  Forces confined_forces(double pressure, double angle) const;

  /// Forces at a pressure raised slowly: free of the ribs up to p(z, Ri), confined above. u_wall = 0.
  Forces blocked_forces(double pressure, double angle) const;

private:
  bool settle(State &state, double angle, std::optional<double> wall_lengthening) const;
  bool balance_tube(State &state) const;
  Forces forces_of(double thrust, bool touches_ribs) const;

  Parameters parameters_;
  Hinge hinge_;
  BalloonTube tube_;
  RibChain chain_;
  GapBulge gap_bulge_;
};

} // namespace ballonet::solver::reduced
