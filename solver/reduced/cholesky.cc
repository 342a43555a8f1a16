// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/cholesky.h"
#include <cmath>
#include <stdexcept>

namespace ballonet::solver::reduced
{
namespace
{

/// Column by column, each taken from the rest at once: the inner loop has no sum to wait for.
void factorize(SymmetricMatrix &A)
{
  const std::size_t n = A.size();
  std::vector<double> column(n);
  for (std::size_t k = 0; k < n; ++k) {
    if (!(A(k, k) > 0))
      throw std::domain_error("the matrix is not positive definite");
    A(k, k) = std::sqrt(A(k, k));
    for (std::size_t i = k + 1; i < n; ++i)
      column[i] = A(i, k) /= A(k, k);
    for (std::size_t i = k + 1; i < n; ++i)
      for (std::size_t j = k + 1; j <= i; ++j)
        A(i, j) -= column[i] * column[j];
  }
}

} // namespace

std::vector<double> solve_positive(SymmetricMatrix &A, std::vector<double> x)
{
  factorize(A);
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k)
      x[i] -= A(i, k) * x[k];
    x[i] /= A(i, i);
  }
  for (std::size_t i = x.size(); i-- > 0;) {
    x[i] /= A(i, i);
    for (std::size_t k = 0; k < i; ++k)
      x[k] -= A(i, k) * x[i];
  }
  return x;
}

} // namespace ballonet::solver::reduced
