// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/dense.h"
#include <cmath>

extern "C" void dgemm_(const char *, const char *, const int *, const int *, const int *, const double *,
                       const double *, const int *, const double *, const int *, const double *, double *, const int *);

namespace ballonet::solver
{

void add_transposed_product(int m, int n, int k, const double *A, const double *B, double *C)
{
  // column-major view: C^T (n x m) += B^T_cm (n x k) * A_cm^T (k x m)
  const double one = 1;
  dgemm_("N", "T", &n, &m, &k, &one, B, &n, A, &m, &one, C, &n);
}

void invert_spd(int n, double *M)
{
  for (int p = 0; p < n; ++p) { // Gauss-Jordan; no pivoting needed for a definite matrix
    const double pivot = 1 / M[p * n + p];
    M[p * n + p] = 1;
    for (int j = 0; j < n; ++j)
      M[p * n + j] *= pivot;
    for (int i = 0; i < n; ++i)
      if (i != p) {
        const double factor = M[i * n + p];
        M[i * n + p] = 0;
        for (int j = 0; j < n; ++j)
          M[i * n + j] -= factor * M[p * n + j];
      }
  }
}

} // namespace ballonet::solver
