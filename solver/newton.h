// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/cavity_work.h"
#include "solver/linear_system.h"
#include "solver/stability.h"
#include <optional>
#include <string>

namespace ballonet::solver
{

/// Newton's method (PETSc SNES) for equilibrium under a load whose size is an unknown of its own.
///
/// The load parameter p is the pressure of the cavity or, without one, the load factor; F is its force, -dR/dp (of a
/// cavity F = dV/du). Unknowns are the displacement and p:  K Y_u - F Y_p = R,  c^T Y_u = miss: two right-hand sides on
/// one factorisation. What is prescribed decides on the second equation: p itself, the volume (c = dV/du), or the
/// length of the step along the path's tangent (c = unit vector along K^-1 F at the start; Riks 1979, with the plane
/// normal to the tangent in the displacements alone). The line search is ours: it asks every contribution for the
/// largest step it can bear.
class NewtonSolver
{
public:
  enum class Prescribe { parameter, volume, arc_length };
  struct Target {
    Prescribe what = Prescribe::parameter;
    double parameter = 0;  ///< MPa, of the cavity; a load factor is prescribed by the state itself
    double volume = 0;     ///< mm^3
    double arc_length = 0; ///< mm, Euclidean norm over all free displacements
    /// Of a step of prescribed arc length, three per node: where it goes, from where the iteration starts. Empty: along
    /// the path's tangent.
    std::span<const double> direction = {};
    int patience = 0; ///< iterations in which the residual must come down to 0.3; 0: no such demand
  };
  struct Outcome {
    bool converged = false;
    std::string reason;            ///< why not
    std::optional<Node> restless;  ///< moved most in the last iteration
    std::vector<double> residuals; ///< relative, before each iteration and at the end
    int negative_pivots = 0;       ///< of the last tangent, load parameter held
    double compliance = 0;         ///< F . K^-1 F of the last tangent, zero where the load parameter is no unknown
    bool convexified = false;      ///< the last tangent was made convex, its compliance is not the body's
    int factorisations = 0;
    double mean_penetration = 0; ///< mm, what augmented contact has left
    std::string shortfall;       ///< of augmented contact, where that is more than asked for
    double volume = 0;           ///< mm^3
    int iterations() const { return static_cast<int>(residuals.size()) - 1; }
    Stability stability() const { return {negative_pivots, compliance}; }
  };

  /// `works` includes the `loads` that the load factor scales and the cavity's work; `cavity` may be null. All must
  /// outlive this object.
  NewtonSolver(LinearSystem &system, std::vector<VirtualWork *> works, std::vector<VirtualWork *> loads,
               CavityWork *cavity, MPI_Comm comm, const Newton &parameters);
  ~NewtonSolver();

  /// Moves `state` (displacement and load parameter) to equilibrium; begin_step has been called on all works. Steps of
  /// prescribed arc length go on in the direction of the state's velocity.
  /// On failure the state is left where the iteration ended.
  Outcome solve(State &state, const Target &target);

  /// Goes on from a converged state after contributions have changed, to the same target of the same step: what was
  /// learned on the way there, the last factor included, still serves. The outcome is that of all together.
  Outcome go_on(State &state);

  /// Volume of the cavity, mm^3 (collective); zero without one.
  double volume(const State &state) const;
  /// Force F of a unit of the load parameter, N per its unit, zero where displacements are held (collective).
  std::vector<double> load_force(const State &state) const;
  /// F . K^-1 F with the tangent factorised last (collective).
  double compliance(const State &state) const;
  /// Forces the contributions exert on every node against its displacement, held ones included: reactions (collective).
  std::vector<double> forces(const State &state) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> impl_;
};

} // namespace ballonet::solver
