// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <petscksp.h>

namespace ballonet::solver
{

/// The LDL^T factor of a symmetric matrix by MUMPS, with its count of negative pivots; and GMRES on a matrix that has
/// changed since, with the factor as its preconditioner.
class MatrixFactor
{
public:
  MatrixFactor();
  ~MatrixFactor();
  MatrixFactor(const MatrixFactor &) = delete;
  MatrixFactor &operator=(const MatrixFactor &) = delete;

  /// Forgets the factor; `matrix` has another pattern.
  void set_matrix(Mat matrix);

  /// Factorises the matrix as it is. False when MUMPS fails.
  bool compute();
  /// The matrix has changed and is to be solved with by GMRES; it gets a factor of its own where that converges too
  /// slowly to be worth while.
  void precondition();
  /// The factor is to be solved with as it is, whatever has become of the matrix.
  void keep() { preconditions_ = false; }

  /// x = K^-1 b; not a number when a factor of its own was needed and MUMPS failed.
  void solve(Vec b, Vec x);

  int computed() const { return computed_; }               ///< factorisations so far
  int negative_pivots() const { return negative_pivots_; } ///< of the last one

private:
  PC factor_ = nullptr;
  KSP krylov_ = nullptr;
  bool preconditions_ = false; ///< the factor is that of another matrix
  int negative_pivots_ = 0, computed_ = 0;
};

} // namespace ballonet::solver
