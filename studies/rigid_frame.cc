// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/rigid_frame.h"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace ballonet::studies
{
namespace
{

constexpr double degrees = 180 / std::numbers::pi;

/// Cofactor matrix: transpose of the inverse times the determinant.
Rotation cofactors(const Rotation &m)
{
  Rotation c{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const int a = (i + 1) % 3, b = (i + 2) % 3, p = (j + 1) % 3, q = (j + 2) % 3;
      c[i][j] = m[a][p] * m[b][q] - m[a][q] * m[b][p];
    }
  return c;
}

double norm(const Rotation &m)
{
  double sum = 0;
  for (const auto &row : m)
    for (const double x : row)
      sum += x * x;
  return std::sqrt(sum);
}

Rotation polar_factor(Rotation m)
{
  const double size = norm(m);
  for (auto &row : m)
    for (double &x : row)
      x /= size;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const Rotation cofactor = cofactors(m);
    const double determinant = m[0][0] * cofactor[0][0] + m[0][1] * cofactor[0][1] + m[0][2] * cofactor[0][2];
    if (!(determinant > 1e-14))
      throw std::invalid_argument("the nodes of a frame do not span the space");
    const double scale = std::sqrt(norm(cofactor) / determinant / norm(m));
    double change = 0;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double next = (scale * m[i][j] + cofactor[i][j] / determinant / scale) / 2;
        change = std::max(change, std::abs(next - m[i][j]));
        m[i][j] = next;
      }
    if (change < 1e-14)
      break;
  }
  return m;
}

Point mean(const std::vector<Point> &points, const std::vector<std::uint32_t> &nodes, bool symmetric)
{
  Point sum{};
  for (const std::uint32_t node : nodes)
    for (int i = 0; i < 3; ++i)
      sum[i] += points[node][i] / static_cast<double>(nodes.size());
  if (symmetric)
    sum[1] = 0;
  return sum;
}

} // namespace

Point RigidFrame::turn(const Point &direction) const
{
  Point result{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      result[i] += rotation[i][j] * direction[j];
  return result;
}

Point RigidFrame::map(const Point &reference) const
{
  Point offset{};
  for (int i = 0; i < 3; ++i)
    offset[i] = reference[i] - reference_centre[i];
  Point result = turn(offset);
  for (int i = 0; i < 3; ++i)
    result[i] += centre[i];
  return result;
}

Point RigidFrame::pull_back(const Point &present) const
{
  Point result = reference_centre;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      result[i] += rotation[j][i] * (present[j] - centre[j]);
  return result;
}

RigidFrame best_fit(const std::vector<Point> &reference, const std::vector<Point> &deformed,
                    const std::vector<std::uint32_t> &nodes, bool symmetric)
{
  RigidFrame frame;
  frame.reference_centre = mean(reference, nodes, symmetric);
  frame.centre = mean(deformed, nodes, symmetric);
  Rotation covariance{};
  for (const std::uint32_t node : nodes)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        covariance[i][j] += (deformed[node][i] - frame.centre[i]) * (reference[node][j] - frame.reference_centre[j]);
  if (symmetric)
    covariance[0][1] = covariance[1][0] = covariance[1][2] = covariance[2][1] = 0; // cancelled by the mirror image
  frame.rotation = polar_factor(covariance);
  return frame;
}

FrameAngles angles(const Rotation &rotation)
{
  const Point n = {rotation[0][2], rotation[1][2], rotation[2][2]};
  const double bending = std::atan2(-n[0], n[2]), out = std::asin(std::clamp(n[1], -1., 1.));
  const double c = std::cos(bending), s = std::sin(bending);
  // First column after undoing the bending, then the motion out of the plane.
  const double x = c * rotation[0][0] + s * rotation[2][0];
  const double z = -s * rotation[0][0] + c * rotation[2][0];
  const double y = std::cos(out) * rotation[1][0] - std::sin(out) * z;
  return {bending * degrees, out * degrees, std::atan2(y, x) * degrees};
}

Rotation relative_rotation(const Rotation &a, const Rotation &b)
{
  Rotation r{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        r[i][j] += a[k][i] * b[k][j];
  return r;
}

double unwrapped(double angle, double previous) { return angle + 360 * std::round((previous - angle) / 360); }

} // namespace ballonet::studies
