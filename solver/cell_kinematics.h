// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/discretization.h"
#include "solver/voigt.h"

namespace ballonet::solver
{

constexpr int n_cell_values = 3 * n_cell_nodes;
using CellVector = std::array<double, n_cell_values>;
using Gradients = std::array<std::array<double, 3>, n_cell_nodes>;

/// Values at the nodes of one cell out of a field with three values per node.
inline CellVector gather(const std::array<std::uint32_t, n_cell_nodes> &nodes, std::span<const double> field)
{
  CellVector local;
  for (int a = 0; a < n_cell_nodes; ++a)
    for (int i = 0; i < 3; ++i)
      local[3 * a + i] = field[3 * nodes[a] + i];
  return local;
}

/// H_ij = sum_a u_ai dN_a/dX_j
inline Matrix3 gradient(const Gradients &G, const CellVector &u)
{
  Matrix3 H{};
  for (int a = 0; a < n_cell_nodes; ++a)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        H[3 * i + j] += u[3 * a + i] * G[a][j];
  return H;
}

/// F = 1 + H
inline Matrix3 deformation_gradient(const Gradients &G, const CellVector &u)
{
  Matrix3 F = gradient(G, u);
  F[0] += 1, F[4] += 1, F[8] += 1;
  return F;
}

/// Linear change of E (engineering shears) for the displacement gradient increment H: sym(F^T H).
inline Voigt strain_increment(const Matrix3 &F, const Matrix3 &H)
{
  Voigt e;
  for (int k = 0; k < 6; ++k) {
    const int i = voigt_row[k], j = voigt_column[k];
    double ij = 0, ji = 0;
    for (int m = 0; m < 3; ++m) {
      ij += F[3 * m + i] * H[3 * m + j];
      ji += F[3 * m + j] * H[3 * m + i];
    }
    e[k] = i == j ? ij : ij + ji;
  }
  return e;
}

} // namespace ballonet::solver
