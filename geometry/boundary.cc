// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/boundary.h"
#include "geometry/hexahedron.h"

namespace ballonet::geometry
{

namespace
{

/// The node in the middle of a face belongs to that face alone, so it names it.
std::uint32_t middle_node(const Mesh &mesh, std::uint32_t cell, std::uint32_t local)
{
  return mesh.cells[cell][face_nodes(local)[4]];
}

} // namespace

std::array<std::uint32_t, 9> nodes_of(const Mesh &mesh, const Face &face)
{
  std::array<std::uint32_t, 9> nodes{};
  const auto local = face_nodes(face.local);
  for (unsigned i = 0; i < 9; ++i)
    nodes[i] = mesh.cells[face.cell][local[i]];
  return nodes;
}

std::vector<Face> free_faces(const Mesh &mesh)
{
  std::vector<std::uint8_t> uses(mesh.nodes.size(), 0);
  for (std::uint32_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (std::uint32_t local = 0; local < 6; ++local)
      ++uses[middle_node(mesh, cell, local)];

  std::vector<Face> faces;
  for (std::uint32_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (std::uint32_t local = 0; local < 6; ++local)
      if (uses[middle_node(mesh, cell, local)] == 1)
        faces.push_back({cell, local});
  return faces;
}

const Surface *find_surface(const Mesh &mesh, const std::string &name)
{
  for (const Surface &surface : mesh.surfaces)
    if (surface.name == name)
      return &surface;
  return nullptr;
}

} // namespace ballonet::geometry
