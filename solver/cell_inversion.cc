// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/cell_inversion.h"
#include <cmath>

namespace ballonet::solver::contact
{

namespace
{

/// Position in the cell and its derivatives (columns of the jacobian).
struct Mapped {
  Point3 position;
  dealii::Tensor<2, 3> jacobian;
};

Mapped map(const CellNodes &nodes, const Point3 &local)
{
  std::array<std::array<double, 3>, 3> value, slope;
  for (int d = 0; d < 3; ++d) {
    value[d] = quadratic(local[d]);
    slope[d] = quadratic_slope(local[d]);
  }
  Mapped m;
  for (int a = 0; a < 27; ++a) {
    const int i = a % 3, j = a / 3 % 3, k = a / 9;
    m.position += value[0][i] * value[1][j] * value[2][k] * nodes[a];
    const Point3 gradient({slope[0][i] * value[1][j] * value[2][k], value[0][i] * slope[1][j] * value[2][k],
                           value[0][i] * value[1][j] * slope[2][k]});
    m.jacobian += outer_product(nodes[a], gradient);
  }
  return m;
}

bool inside(const Point3 &local, double by)
{
  bool result = true;
  for (int d = 0; d < 3; ++d)
    result = result && local[d] >= -by && local[d] <= 1 + by;
  return result;
}

} // namespace

std::optional<Point3> local_coordinates(const CellNodes &nodes, const Point3 &x)
{
  Point3 local({0.5, 0.5, 0.5});
  for (int iteration = 0; iteration < 25 && inside(local, 1); ++iteration) {
    const Mapped m = map(nodes, local);
    if (determinant(m.jacobian) == 0)
      return std::nullopt;
    const Point3 step = invert(m.jacobian) * (x - m.position);
    local += step;
    if (step.norm() < 1e-8)
      return inside(local, 1e-8) ? std::optional(local) : std::nullopt;
  }
  return std::nullopt;
}

} // namespace ballonet::solver::contact
