// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/mesh.h"

/// The 27-node hexahedron on the reference cube [0, 1]^3, nodes in lexicographic order.
namespace ballonet::geometry
{

using CellNodes = std::array<Point, 27>;

CellNodes cell_nodes(const Mesh &mesh, std::size_t cell);

/// Position and its derivatives with respect to the three reference coordinates.
struct MappedPoint {
  Point position;
  std::array<Point, 3> tangents;
};
MappedPoint map_point(const CellNodes &nodes, const Point &reference);

/// Determinant of the tangents: volume of the cell per reference volume.
double jacobian(const MappedPoint &point);

struct QuadraturePoint {
  Point reference;
  double weight;
};
/// The 3 x 3 x 3 Gauss points of the reference cube; weights add up to 1.
const std::array<QuadraturePoint, 27> &gauss_points();

/// Local node numbers of a face, 3 x 3 with the first index fastest, turned so that (first x second) points outwards.
std::array<unsigned, 9> face_nodes(unsigned local_face);

/// The four corners of a face's nodes as face_nodes() gives them.
constexpr std::array<unsigned, 4> face_corners = {0, 2, 6, 8};

Point cross(const Point &a, const Point &b);
double dot(const Point &a, const Point &b);
Point difference(const Point &a, const Point &b);

} // namespace ballonet::geometry
