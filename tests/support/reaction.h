// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/discretization.h"
#include "solver/equilibrium.h"

namespace ballonet::tests
{

/// Sum of the forces that hold the nodes of a surface, N.
inline solver::Vector3 reaction(const solver::Mesh &mesh, const solver::Equilibrium &equilibrium,
                                const solver::State &state, const std::string &surface)
{
  const auto forces = equilibrium.reactions(state);
  solver::Vector3 sum = {};
  for (const auto node : surface_nodes(mesh, surface))
    for (int d = 0; d < 3; ++d)
      sum[d] += forces[3 * node + d];
  return sum;
}

} // namespace ballonet::tests
