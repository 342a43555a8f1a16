// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/cell_stiffness.h"
#include "solver/dense.h"

namespace ballonet::solver
{

namespace
{

/// dE / dF: six rows (engineering shears) of nine values.
std::array<double, 54> strain_derivative(const Matrix3 &F)
{
  std::array<double, 54> T{};
  for (int k = 0; k < 6; ++k)
    for (int m = 0; m < 3; ++m) {
      const int i = voigt_row[k], j = voigt_column[k];
      T[9 * k + 3 * m + i] = F[3 * m + j];
      T[9 * k + 3 * m + j] = F[3 * m + i];
    }
  return T;
}

} // namespace

std::array<double, 81> first_elasticity_tensor(const Matrix3 &F, const Voigt &S, const Voigt2 &tangent)
{
  const auto T = strain_derivative(F);
  std::array<double, 54> DT{};
  for (int k = 0; k < 6; ++k)
    for (int l = 0; l < 6; ++l)
      for (int n = 0; n < 9; ++n)
        DT[9 * k + n] += tangent[6 * k + l] * T[9 * l + n];
  std::array<double, 81> A{};
  for (int m = 0; m < 9; ++m)
    for (int k = 0; k < 6; ++k)
      for (int n = 0; n < 9; ++n)
        A[9 * m + n] += T[9 * k + m] * DT[9 * k + n];
  for (int i = 0; i < 3; ++i)
    for (int J = 0; J < 3; ++J)
      for (int L = 0; L < 3; ++L)
        A[9 * (3 * i + J) + 3 * i + L] += S[voigt_index[J][L]];
  return A;
}

void CellStiffness::set_point(int point, double weight, const Gradients &G, const std::array<double, 81> &moduli)
{
  double *g = &gradient_[point * 3 * n_cell_nodes];
  for (int J = 0; J < 3; ++J)
    for (int a = 0; a < n_cell_nodes; ++a)
      g[J * n_cell_nodes + a] = G[a][J];
  double *row = &moduli_[point * 3 * n_pairs * n_cell_nodes];
  for (int J = 0; J < 3; ++J)
    for (int i = 0; i < 3; ++i)
      for (int k = i; k < 3; ++k, row += n_cell_nodes) {
        const double *A = &moduli[9 * (3 * i + J) + 3 * k];
        for (int b = 0; b < n_cell_nodes; ++b)
          row[b] = weight * (A[0] * g[b] + A[1] * g[n_cell_nodes + b] + A[2] * g[2 * n_cell_nodes + b]);
      }
}

void CellStiffness::sum(CellMatrix &K) const
{
  constexpr int n = n_pairs * n_cell_nodes;
  std::array<double, n_cell_nodes * n> blocks{}; // [a][pair][b]
  add_transposed_product(n_cell_nodes, n, 3 * n_points, gradient_.data(), moduli_.data(), blocks.data());
  const double *block = blocks.data();
  for (int a = 0; a < n_cell_nodes; ++a)
    for (int i = 0; i < 3; ++i)
      for (int k = i; k < 3; ++k)
        for (int b = 0; b < n_cell_nodes; ++b, ++block)
          K[(3 * a + i) * n_cell_values + 3 * b + k] = K[(3 * b + k) * n_cell_values + 3 * a + i] = *block;
}

} // namespace ballonet::solver
