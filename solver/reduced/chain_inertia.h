// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/reduced/cholesky.h"
#include "solver/reduced/rib_chain.h"

namespace ballonet::solver::reduced
{

/// Inertia of the chain in its absolute angles. With d = al_k - al_j and j < k:
///     M_jk = A_k cos d + B_k sin d,  A_k = p (m_above_k p + m_k z_k),  B_k = p m_k c_k
///     M_jj = m_above_j p^2 + m_j (z_j^2 + c_j^2) + J_j
struct Inertia {
  SymmetricMatrix mass;         ///< M, t mm^2
  std::vector<double> velocity; ///< sum_k dM_jk / dal_k al'_k^2, N mm; stands beside M al''
};
Inertia inertia(const RibChain &chain, const Angles &al, const std::vector<double> &velocity);

/// Lowest natural frequency of small vibrations about `al`, Hz; by inverse iteration.
/// Throws std::domain_error if the chain is not stable there.
double lowest_frequency(const RibChain &chain, const Angles &al, double k);

} // namespace ballonet::solver::reduced
