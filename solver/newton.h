// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/cavity_work.h"
#include "solver/linear_system.h"
#include <string>

namespace ballonet::solver
{

/// Newton's method (PETSc SNES) for equilibrium at a prescribed volume or pressure of the cavity.
///
/// Unknowns are the displacement and the pressure p:  K Y_u - G Y_p = R,  G^T Y_u = V - V_target  with G = dV/du: two
/// right-hand sides on one factorisation. The line search is ours: it asks every contribution for the largest step it
/// can bear.
class NewtonSolver
{
public:
  struct Target {
    bool volume_prescribed = false;
    double volume = 0;   ///< mm^3
    double pressure = 0; ///< MPa; when the volume is not prescribed
  };
  struct Outcome {
    bool converged = false;
    std::string reason;            ///< why not
    std::vector<double> residuals; ///< relative, before each iteration and at the end
    int negative_pivots = 0;       ///< of the last tangent, pressure held
    double volume = 0;             ///< mm^3
    int iterations() const { return static_cast<int>(residuals.size()) - 1; }
  };

  /// `works` includes the cavity's work; `cavity` may be null. All must outlive this object.
  NewtonSolver(LinearSystem &system, std::vector<VirtualWork *> works, CavityWork *cavity, MPI_Comm comm,
               const Newton &parameters);
  ~NewtonSolver();

  /// Moves `state` (displacement and pressure) to equilibrium; begin_step has been called on all works.
  /// On failure the state is left where the iteration ended.
  Outcome solve(State &state, const Target &target);

  /// Volume of the cavity, mm^3 (collective); zero without one.
  double volume(const State &state) const;
  /// Forces the contributions exert on every node against its displacement, held ones included: reactions (collective).
  std::vector<double> forces(const State &state) const;

private:
  struct Implementation;
  std::unique_ptr<Implementation> impl_;
};

} // namespace ballonet::solver
