// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <span>
#include <vector>

namespace ballonet::solver::reduced
{

/// Solves the symmetric system with the given diagonal and the same value `off_diagonal` beside it, by LDL^T.
struct TridiagonalSolution {
  std::vector<double> x;
  int negative_pivots = 0; ///< number of negative eigenvalues of the matrix
};
TridiagonalSolution solve_tridiagonal(std::span<const double> diagonal, double off_diagonal,
                                      std::span<const double> right_side);

} // namespace ballonet::solver::reduced
