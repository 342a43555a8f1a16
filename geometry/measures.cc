// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/measures.h"
#include "geometry/boundary.h"
#include "geometry/hexahedron.h"
#include <cmath>
#include <stdexcept>

namespace ballonet::geometry
{

namespace
{

/// The Gauss points of a face are the cell's points with the coordinate across the face moved onto it.
double face_area(const Mesh &mesh, const Face &face)
{
  const CellNodes nodes = cell_nodes(mesh, face.cell);
  const unsigned axis = face.local / 2;
  double sum = 0;
  for (const QuadraturePoint &gauss : gauss_points()) {
    Point reference = gauss.reference;
    reference[axis] = face.local % 2;
    const MappedPoint point = map_point(nodes, reference);
    const Point normal = cross(point.tangents[(axis + 1) % 3], point.tangents[(axis + 2) % 3]);
    sum += gauss.weight * std::sqrt(dot(normal, normal));
  }
  return sum;
}

std::size_t body_index(const Mesh &mesh, const std::string &name)
{
  for (std::size_t i = 0; i < mesh.bodies.size(); ++i)
    if (mesh.bodies[i].name == name)
      return i;
  throw std::invalid_argument("the mesh has no body \"" + name + "\"");
}

} // namespace

double cell_volume(const Mesh &mesh, std::size_t cell)
{
  const CellNodes nodes = cell_nodes(mesh, cell);
  double sum = 0;
  for (const QuadraturePoint &gauss : gauss_points())
    sum += gauss.weight * jacobian(map_point(nodes, gauss.reference));
  return sum;
}

double volume(const Mesh &mesh, const std::string &body)
{
  const std::size_t index = body_index(mesh, body);
  double sum = 0;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    if (mesh.cell_body[cell] == index)
      sum += cell_volume(mesh, cell);
  return sum;
}

double area(const Mesh &mesh, const std::string &surface)
{
  const Surface *found = find_surface(mesh, surface);
  if (found == nullptr)
    throw std::invalid_argument("the mesh has no surface \"" + surface + "\"");
  double sum = 0;
  for (const Face &face : found->faces)
    sum += face_area(mesh, face);
  return sum;
}

} // namespace ballonet::geometry
