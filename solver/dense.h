// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/// Small dense kernels on row-major arrays, by the BLAS of the machine.
namespace ballonet::solver
{

/// C (m x n) += A^T B with A (k x m), B (k x n).
void add_transposed_product(int m, int n, int k, const double *A, const double *B, double *C);

/// Inverse of a small symmetric positive definite n x n matrix in place (n <= 8).
void invert_spd(int n, double *M);

} // namespace ballonet::solver
