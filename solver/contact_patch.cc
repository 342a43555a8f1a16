// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_patch.h"
#include <algorithm>
#include <cmath>

namespace ballonet::solver::contact
{

PatchShapes patch_shapes(const Parameters2 &xi)
{
  const auto n0 = quadratic(xi[0]), n1 = quadratic(xi[1]);
  const auto d0 = quadratic_slope(xi[0]), d1 = quadratic_slope(xi[1]);
  PatchShapes shapes;
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      shapes.value[i + 3 * j] = n0[i] * n1[j];
      shapes.derivative[0][i + 3 * j] = d0[i] * n1[j];
      shapes.derivative[1][i + 3 * j] = n0[i] * d1[j];
    }
  return shapes;
}

PatchPoint patch_point(const PatchNodes &nodes, const Parameters2 &xi)
{
  constexpr std::array<double, 3> curvature = {4, -8, 4};
  const auto n0 = quadratic(xi[0]), n1 = quadratic(xi[1]);
  const auto d0 = quadratic_slope(xi[0]), d1 = quadratic_slope(xi[1]);
  PatchPoint p;
  for (int j = 0; j < 3; ++j) {
    const Point3 *row = &nodes[3 * j];
    const Point3 value = n0[0] * row[0] + n0[1] * row[1] + n0[2] * row[2];
    const Point3 slope = d0[0] * row[0] + d0[1] * row[1] + d0[2] * row[2];
    const Point3 second = curvature[0] * row[0] + curvature[1] * row[1] + curvature[2] * row[2];
    p.position += n1[j] * value;
    p.tangent[0] += n1[j] * slope;
    p.tangent[1] += d1[j] * value;
    p.second[0] += n1[j] * second;
    p.second[1] += d1[j] * slope;
    p.second[2] += curvature[j] * value;
  }
  return p;
}

namespace
{

/// |x - y|^2 / 2 around the present parameters.
struct Quadratic {
  double value;
  Parameters2 gradient;
  std::array<double, 3> hessian, metric; ///< metric: the hessian without the curvature of the patch
  Point3 r;
  std::array<Point3, 2> tangent;
};

Quadratic expand(const PatchNodes &nodes, const Point3 &x, const Parameters2 &xi)
{
  const PatchPoint p = patch_point(nodes, xi);
  Quadratic q;
  q.r = x - p.position;
  q.tangent = p.tangent;
  q.value = 0.5 * q.r.norm_square();
  q.gradient = {-(q.r * p.tangent[0]), -(q.r * p.tangent[1])};
  q.metric = {p.tangent[0] * p.tangent[0], p.tangent[0] * p.tangent[1], p.tangent[1] * p.tangent[1]};
  for (int k = 0; k < 3; ++k)
    q.hessian[k] = q.metric[k] - q.r * p.second[k];
  return q;
}

std::array<bool, 2> free_parameters(const Quadratic &q, const PatchRange &range, const Parameters2 &xi)
{
  std::array<bool, 2> free;
  for (int a = 0; a < 2; ++a)
    free[a] = range.low[a] < range.high[a] && !(xi[a] <= range.low[a] && q.gradient[a] > 0) &&
              !(xi[a] >= range.high[a] && q.gradient[a] < 0);
  return free;
}

/// Newton step in both parameters; Gauss-Newton where the hessian is not positive definite.
Parameters2 step_in_both(const Quadratic &q)
{
  auto determinant = [](const std::array<double, 3> &h) { return h[0] * h[2] - h[1] * h[1]; };
  const bool convex = q.hessian[0] > 0 && determinant(q.hessian) > 1e-6 * determinant(q.metric);
  const auto &h = convex ? q.hessian : q.metric;
  const double inverse = 1 / std::max(determinant(h), 1e-300);
  return {-inverse * (h[2] * q.gradient[0] - h[1] * q.gradient[1]),
          -inverse * (h[0] * q.gradient[1] - h[1] * q.gradient[0])};
}

double step_in_one(const Quadratic &q, int a)
{
  const double h = q.hessian[2 * a], metric = q.metric[2 * a];
  return -q.gradient[a] / (h > 1e-6 * metric ? h : std::max(metric, 1e-300));
}

/// The step of the free parameters; one that would be pushed out through its bound is held there.
Parameters2 projected_step(const Quadratic &q, const PatchRange &range, const Parameters2 &xi, std::array<bool, 2> free)
{
  if (free[0] && free[1]) {
    const Parameters2 step = step_in_both(q);
    for (int a = 0; a < 2; ++a)
      if ((xi[a] <= range.low[a] && step[a] < 0) || (xi[a] >= range.high[a] && step[a] > 0))
        free[a] = false;
    if (free[0] && free[1])
      return step;
  }
  return {free[0] ? step_in_one(q, 0) : 0, free[1] ? step_in_one(q, 1) : 0};
}

Parameters2 clamped(const PatchRange &range, const Parameters2 &xi)
{
  return {std::clamp(xi[0], range.low[0], range.high[0]), std::clamp(xi[1], range.low[1], range.high[1])};
}

ClosestPoint result(const Quadratic &q, const PatchRange &range, const Parameters2 &xi, bool converged)
{
  ClosestPoint c;
  c.xi = xi;
  c.free = free_parameters(q, range, xi);
  c.distance = std::sqrt(2 * q.value);
  c.normal = q.r / std::max(c.distance, 1e-300);
  c.tangent = q.tangent;
  c.hessian = q.hessian;
  c.converged = converged;
  return c;
}

/// The first of xi + step, xi + step / 2, ... that lowers the distance; the smallest one if none does.
Parameters2 backtrack(const PatchNodes &nodes, const PatchRange &range, const Point3 &x, const Parameters2 &xi,
                      const Parameters2 &step, double value)
{
  Parameters2 trial = xi;
  for (double fraction = 1; fraction > 1e-3; fraction /= 2) {
    trial = clamped(range, {xi[0] + fraction * step[0], xi[1] + fraction * step[1]});
    if (0.5 * (x - patch_point(nodes, trial).position).norm_square() < value)
      break;
  }
  return trial;
}

ClosestPoint descend(const PatchNodes &nodes, const PatchRange &range, const Point3 &x, const Parameters2 &start)
{
  Parameters2 xi = clamped(range, start);
  Quadratic q = expand(nodes, x, xi);
  for (int iteration = 0; iteration < 30; ++iteration) {
    const Parameters2 step = projected_step(q, range, xi, free_parameters(q, range, xi));
    const double length = std::max(std::abs(step[0]), std::abs(step[1]));
    if (length == 0)
      return result(q, range, xi, true);
    if (length < 1e-5) // quadratic convergence: after the step the error is below rounding
      xi = clamped(range, {xi[0] + step[0], xi[1] + step[1]});
    else
      xi = backtrack(nodes, range, x, xi, step, q.value);
    q = expand(nodes, x, xi);
    if (length < 1e-9)
      return result(q, range, xi, true);
  }
  return result(q, range, xi, false);
}

Parameters2 nearest_sample(const PatchNodes &nodes, const PatchRange &range, const Point3 &x)
{
  Parameters2 best = range.low;
  double smallest = std::numeric_limits<double>::infinity();
  for (double s : {0., 0.5, 1.})
    for (double t : {0., 0.5, 1.}) {
      const Parameters2 xi = {range.low[0] + s * (range.high[0] - range.low[0]),
                              range.low[1] + t * (range.high[1] - range.low[1])};
      const double square = (x - patch_point(nodes, xi).position).norm_square();
      if (square < smallest) {
        smallest = square;
        best = xi;
      }
    }
  return best;
}

} // namespace

ClosestPoint closest_point(const PatchNodes &nodes, const PatchRange &range, const Point3 &x, const Parameters2 &start)
{
  const ClosestPoint warm = descend(nodes, range, x, start);
  if (warm.converged)
    return warm;
  const ClosestPoint cold = descend(nodes, range, x, nearest_sample(nodes, range, x));
  return cold.distance < warm.distance ? cold : warm;
}

ClosestPoint closest_point(const PatchNodes &nodes, const PatchRange &range, const Point3 &x)
{
  return descend(nodes, range, x, nearest_sample(nodes, range, x));
}

} // namespace ballonet::solver::contact
