// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/equilibrium.h"

namespace ballonet::tests
{

/// An assembly brought from equilibrium to equilibrium under supports and loads that change from stage to stage: press,
/// then pull. What one stage hands to the next is the state alone, so each may have a system of its own.
class StagedAssembly
{
public:
  solver::Parameters parameters; ///< of the next step; supports and loads count in full
  solver::State state;

  /// `mesh` must outlive this.
  StagedAssembly(const solver::Mesh &mesh, solver::Parameters parameters);

  /// One step of `dt` seconds to equilibrium under the present parameters; a case that does not converge, or whose
  /// bodies penetrate each other, fails.
  void step(double dt);

  /// Sum of the forces that a surface's nodes receive from outside, N: of a support the reaction.
  solver::Vector3 force_on(const std::string &surface) const;
  /// Mean displacement of a surface's nodes, mm.
  solver::Vector3 displacement_of(const std::string &surface) const;
  /// The system of the last step.
  const solver::Equilibrium &equilibrium() const { return *equilibrium_; }

private:
  const solver::Mesh &mesh_;
  solver::Parameters present_;
  std::unique_ptr<solver::Equilibrium> equilibrium_;
};

} // namespace ballonet::tests
