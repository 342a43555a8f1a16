// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/tridiagonal.h"

namespace ballonet::solver::reduced
{

TridiagonalSolution solve_tridiagonal(std::span<const double> diagonal, double off_diagonal,
                                      std::span<const double> right_side)
{
  const std::size_t n = diagonal.size();
  std::vector<double> pivot(diagonal.begin(), diagonal.end());
  TridiagonalSolution solution{{right_side.begin(), right_side.end()}};
  for (std::size_t i = 1; i < n; ++i) {
    const double factor = off_diagonal / pivot[i - 1];
    pivot[i] -= factor * off_diagonal;
    solution.x[i] -= factor * solution.x[i - 1];
  }
  for (std::size_t i = n; i-- > 0;) {
    const double above = i + 1 < n ? off_diagonal * solution.x[i + 1] : 0;
    solution.x[i] = (solution.x[i] - above) / pivot[i];
    solution.negative_pivots += pivot[i] < 0;
  }
  return solution;
}

} // namespace ballonet::solver::reduced
