// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <deal.II/base/tensor.h>

namespace ballonet::solver::contact
{

using Point3 = dealii::Tensor<1, 3>;

/// A biquadratic patch: nodes at (i, j) / 2, node i + 3 j, of the parameters (xi_0, xi_1) in [0, 1]^2.
using PatchNodes = std::array<Point3, 9>;
using Parameters2 = std::array<double, 2>;

/// The rectangle of parameters that belongs to a patch; it may shrink to a line or a point.
struct PatchRange {
  Parameters2 low = {0, 0}, high = {1, 1};
};

/// Values and first derivatives of the nine shape functions.
struct PatchShapes {
  std::array<double, 9> value;
  std::array<std::array<double, 9>, 2> derivative;
};

/// The three quadratic Lagrange functions with nodes 0, 1/2, 1.
constexpr std::array<double, 3> quadratic(double t)
{
  return {(1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)};
}
constexpr std::array<double, 3> quadratic_slope(double t) { return {4 * t - 3, 4 - 8 * t, 4 * t - 1}; }

PatchShapes patch_shapes(const Parameters2 &xi);

/// A point of a patch with its derivatives by the parameters.
struct PatchPoint {
  Point3 position;
  std::array<Point3, 2> tangent;
  std::array<Point3, 3> second; ///< by 00, 01, 11
};

PatchPoint patch_point(const PatchNodes &nodes, const Parameters2 &xi);

/// Where a patch is nearest to a point x, with all that the derivatives of the distance need.
struct ClosestPoint {
  Parameters2 xi;
  std::array<bool, 2> free;      ///< false where the parameter is held at a bound of the range
  double distance;               ///< |x - y|, mm
  Point3 normal;                 ///< (x - y) / |x - y|
  std::array<Point3, 2> tangent; ///< derivatives of y by the parameters
  std::array<double, 3> hessian; ///< of |x - y|^2 / 2 by the parameters 00, 01, 11
  bool converged;
};

/// Minimises |x - y(xi)| over the range: Newton's method with an active set of bounds (Bertsekas 1982) and backtracking
/// from `start`; if that does not converge, from the nearest of 3 x 3 samples.
ClosestPoint closest_point(const PatchNodes &, const PatchRange &, const Point3 &x, const Parameters2 &start);

/// The same from the nearest of 3 x 3 samples of the range.
ClosestPoint closest_point(const PatchNodes &, const PatchRange &, const Point3 &x);

} // namespace ballonet::solver::contact
