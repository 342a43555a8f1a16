// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <cstddef>
#include <vector>

namespace ballonet::solver::reduced
{

/// A small symmetric matrix, of which only the lower triangle is kept.
class SymmetricMatrix
{
public:
  explicit SymmetricMatrix(std::size_t n) : n_(n), values_(n * n, 0.0) {}
  std::size_t size() const { return n_; }

  /// Entry (i, j) with j <= i.
  double &operator()(std::size_t i, std::size_t j) { return values_[i * n_ + j]; }
  double operator()(std::size_t i, std::size_t j) const { return values_[i * n_ + j]; }

private:
  std::size_t n_;
  std::vector<double> values_;
};

/// Solves A x = right_side for a positive definite A by Cholesky's method; A is overwritten. Throws std::domain_error
/// if A is not positive definite.
std::vector<double> solve_positive(SymmetricMatrix &A, std::vector<double> right_side);

} // namespace ballonet::solver::reduced
