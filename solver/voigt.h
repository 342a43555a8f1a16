// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <cmath>

/// Symmetric tensors as six numbers: xx, yy, zz, xy, yz, xz. Strains carry engineering shears (2 E_xy).
namespace ballonet::solver
{

using Voigt = std::array<double, 6>;
using Voigt2 = std::array<double, 36>; ///< 6 x 6, row by row
using Matrix3 = std::array<double, 9>; ///< row by row

constexpr int voigt_row[6] = {0, 1, 2, 0, 1, 0}, voigt_column[6] = {0, 1, 2, 1, 2, 2};
constexpr int voigt_index[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
constexpr Voigt voigt_unit = {1, 1, 1, 0, 0, 0};

inline double determinant(const Matrix3 &m)
{
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
}

/// det(m) m^-T = d det(m) / d m
inline Matrix3 cofactor(const Matrix3 &m)
{
  return {m[4] * m[8] - m[5] * m[7], m[5] * m[6] - m[3] * m[8], m[3] * m[7] - m[4] * m[6],
          m[2] * m[7] - m[1] * m[8], m[0] * m[8] - m[2] * m[6], m[1] * m[6] - m[0] * m[7],
          m[1] * m[5] - m[2] * m[4], m[2] * m[3] - m[0] * m[5], m[0] * m[4] - m[1] * m[3]};
}

/// a : b
inline double dot(const Matrix3 &a, const Matrix3 &b)
{
  double s = 0;
  for (int i = 0; i < 9; ++i)
    s += a[i] * b[i];
  return s;
}

/// C = F^T F
inline Voigt right_cauchy_green(const Matrix3 &F)
{
  Voigt C;
  for (int k = 0; k < 6; ++k) {
    const int i = voigt_row[k], j = voigt_column[k];
    C[k] = F[i] * F[j] + F[3 + i] * F[3 + j] + F[6 + i] * F[6 + j];
  }
  return C;
}

/// E = (C - 1) / 2 with engineering shears
inline Voigt green_strain(const Voigt &C) { return {(C[0] - 1) / 2, (C[1] - 1) / 2, (C[2] - 1) / 2, C[3], C[4], C[5]}; }

inline double determinant(const Voigt &c)
{
  return c[0] * (c[1] * c[2] - c[4] * c[4]) - c[3] * (c[3] * c[2] - c[4] * c[5]) + c[5] * (c[3] * c[4] - c[1] * c[5]);
}

inline Voigt inverse(const Voigt &c)
{
  const double d = 1 / determinant(c);
  return {d * (c[1] * c[2] - c[4] * c[4]), d * (c[0] * c[2] - c[5] * c[5]), d * (c[0] * c[1] - c[3] * c[3]),
          d * (c[4] * c[5] - c[3] * c[2]), d * (c[3] * c[5] - c[0] * c[4]), d * (c[3] * c[4] - c[1] * c[5])};
}

/// m += factor * a (x) b
inline void add_dyad(Voigt2 &m, double factor, const Voigt &a, const Voigt &b)
{
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      m[6 * i + j] += factor * a[i] * b[j];
}

/// m += factor * (a_ik a_jl + a_il a_jk) / 2
inline void add_symmetric_product(Voigt2 &m, double factor, const Voigt &a)
{
  for (int p = 0; p < 6; ++p)
    for (int q = 0; q < 6; ++q) {
      const int i = voigt_row[p], j = voigt_column[p], k = voigt_row[q], l = voigt_column[q];
      m[6 * p + q] +=
          factor / 2 * (a[voigt_index[i][k]] * a[voigt_index[j][l]] + a[voigt_index[i][l]] * a[voigt_index[j][k]]);
    }
}

inline Voigt multiply(const Voigt2 &m, const Voigt &v)
{
  Voigt r{};
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 6; ++j)
      r[i] += m[6 * i + j] * v[j];
  return r;
}

inline double dot(const Voigt &a, const Voigt &b)
{
  double s = 0;
  for (int i = 0; i < 6; ++i)
    s += a[i] * b[i];
  return s;
}

/// Von Mises norm of the Cauchy stress F S F^T / J, MPa
double von_mises(const Matrix3 &F, const Voigt &S);

} // namespace ballonet::solver
