// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/parameters.h"
#include "solver/virtual_work.h"

namespace ballonet::solver
{

/// A one-step rule for the motion. From the start n to the end of a step of length h
///   u = u_n + h v_n + h^2 (b_start a_n + b_end a),   v = v_n + h (g_start a_n + g_end a),
/// and the mass feels the acceleration (1 - alpha) a + alpha a_n; all other forces are those at the end.
struct StepRule {
  double b_start, b_end, g_start, g_end, alpha;
};

/// Backward Euler: a = (v - v_n) / h, v = (u - u_n) / h.
StepRule backward_euler();

/// Wood, Bossak and Zienkiewicz (1980), the member of the generalised-alpha family (Chung and Hulbert 1993) that shifts
/// only the inertia, so that a step still makes a potential stationary. Of second order and unconditionally stable for
/// linear problems; a step leaves `spectral_radius` (0 to 1) of the highest frequencies and hardly touches the low
/// ones; 1 is the trapezoidal rule, which conserves the energy of a linear system.
StepRule generalised_alpha(double spectral_radius);

/// The rule a path asks for.
StepRule step_rule(const Path &path);

/// Inertia of lumped masses m and their damping by a force -d v (Rayleigh's mass-proportional part), as an incremental
/// potential. With w = u - u_n - h v_n - h^2 b_start a_n, so that a = w / (b_end h^2), it is for every node
///   m [(1 - alpha) |w|^2 / (2 b_end h^2) + alpha a_n . w] + d [g_end |w|^2 / (2 b_end h) + (v_n + h g_start a_n) . w];
/// for backward Euler without damping m |u - u_n - h v_n|^2 / (2 h^2).
class InertiaWork : public VirtualWork
{
public:
  /// `mass` (t) and `damping` (t/s): this rank's part at every node.
  InertiaWork(std::vector<double> mass, std::vector<double> damping, const StepRule &rule);

  void begin_step(const State &start, const Step &step) override;
  double energy(const State &state) const override;
  void residual(const State &state, Assembly &out) const override;
  void tangent(const State &state, Assembly &out) const override;

  /// Gives the end of a step its velocity and acceleration; after a step without inertia (u - u_n) / h and zero.
  void end_step(State &end) const;

  /// Kinetic energy of this rank's part of the masses, N mm.
  double kinetic_energy(const State &state) const;
  /// Work against the damping since the start of the step, N mm, of this rank's part.
  double dissipated(const State &state) const;
  /// This rank's part of the nodal masses, t.
  const std::vector<double> &mass() const { return mass_; }

private:
  double acceleration(std::size_t i, double u) const;
  double velocity(std::size_t i, double u) const;
  double stiffness(Node node) const;

  std::vector<double> mass_, damping_;
  StepRule rule_;
  std::vector<Node> nodes_; ///< those with a mass
  State start_;
  Step step_;
};

} // namespace ballonet::solver
