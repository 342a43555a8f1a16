// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/cell_kinematics.h"

namespace ballonet::solver
{

using CellMatrix = std::array<double, n_cell_values * n_cell_values>; ///< row by row

/// First elasticity tensor A_iJkL = dP_iJ / dF_kL, 9 x 9 in the order of Matrix3, from the stress S of the geometric
/// part and the material tangent dS / dE (Bonet and Wood). Symmetric.
std::array<double, 81> first_elasticity_tensor(const Matrix3 &F, const Voigt &S, const Voigt2 &tangent);

/// Sums the stiffness of one cell over its Gauss points,
///   K_ai,bk = sum_q w dN_a/dX_J A_iJkL dN_b/dX_L,
/// as one matrix product for the six pairs i <= k: a third of the work of B^T D B.
class CellStiffness
{
public:
  void set_point(int point, double weight, const Gradients &G, const std::array<double, 81> &moduli);
  /// K of the points set.
  void sum(CellMatrix &K) const;

private:
  static constexpr int n_pairs = 6;
  std::array<double, n_points * 3 * n_cell_nodes> gradient_;         ///< [q][J][a]: dN_a/dX_J
  std::array<double, n_points * 3 * n_pairs * n_cell_nodes> moduli_; ///< [q][J][pair][b]: w A_iJkL dN_b/dX_L
};

} // namespace ballonet::solver
