// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/hexahedron.h"
#include <cmath>

namespace ballonet::geometry
{

namespace
{

struct Lagrange {
  std::array<double, 3> value, slope;
};

/// Quadratic Lagrange polynomials on 0, 1/2, 1.
Lagrange lagrange(double x)
{
  return {{(2 * x - 1) * (x - 1), 4 * x * (1 - x), x * (2 * x - 1)}, {4 * x - 3, 4 - 8 * x, 4 * x - 1}};
}

std::array<QuadraturePoint, 27> make_gauss_points()
{
  const double offset = 0.5 * std::sqrt(0.6);
  const std::array<double, 3> place = {0.5 - offset, 0.5, 0.5 + offset}, weight = {5. / 18, 8. / 18, 5. / 18};
  std::array<QuadraturePoint, 27> points{};
  for (unsigned i = 0; i < 27; ++i) {
    const unsigned a = i % 3, b = i / 3 % 3, c = i / 9;
    points[i] = {{place[a], place[b], place[c]}, weight[a] * weight[b] * weight[c]};
  }
  return points;
}

} // namespace

CellNodes cell_nodes(const Mesh &mesh, std::size_t cell)
{
  CellNodes nodes;
  for (unsigned i = 0; i < 27; ++i)
    nodes[i] = mesh.nodes[mesh.cells[cell][i]];
  return nodes;
}

MappedPoint map_point(const CellNodes &nodes, const Point &reference)
{
  const std::array<Lagrange, 3> l = {lagrange(reference[0]), lagrange(reference[1]), lagrange(reference[2])};
  MappedPoint result{};
  for (unsigned i = 0; i < 27; ++i) {
    const unsigned a = i % 3, b = i / 3 % 3, c = i / 9;
    const double x = l[0].value[a], y = l[1].value[b], z = l[2].value[c];
    const std::array<double, 3> slopes = {l[0].slope[a] * y * z, x * l[1].slope[b] * z, x * y * l[2].slope[c]};
    for (unsigned d = 0; d < 3; ++d) {
      result.position[d] += x * y * z * nodes[i][d];
      for (unsigned e = 0; e < 3; ++e)
        result.tangents[e][d] += slopes[e] * nodes[i][d];
    }
  }
  return result;
}

double jacobian(const MappedPoint &point)
{
  return dot(point.tangents[0], cross(point.tangents[1], point.tangents[2]));
}

const std::array<QuadraturePoint, 27> &gauss_points()
{
  static const std::array<QuadraturePoint, 27> points = make_gauss_points();
  return points;
}

std::array<unsigned, 9> face_nodes(unsigned local_face)
{
  constexpr std::array<unsigned, 3> stride = {1, 3, 9};
  const unsigned axis = local_face / 2, side = local_face % 2;
  const unsigned first = side == 1 ? (axis + 1) % 3 : (axis + 2) % 3, second = 3 - axis - first;
  std::array<unsigned, 9> nodes{};
  for (unsigned i = 0; i < 9; ++i)
    nodes[i] = 2 * side * stride[axis] + i % 3 * stride[first] + i / 3 * stride[second];
  return nodes;
}

Point cross(const Point &a, const Point &b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Point &a, const Point &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Point difference(const Point &a, const Point &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

} // namespace ballonet::geometry
