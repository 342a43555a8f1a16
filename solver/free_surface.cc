// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/free_surface.h"
#include "solver/contact_surface.h"

namespace ballonet::solver
{

using namespace contact;

namespace
{

constexpr std::uint32_t centre_of_face = 4; // column

Node face_node(const Mesh &mesh, const Face &face, std::uint32_t column)
{
  return mesh.cells[face.cell][columns_behind(face.local)[3 * column]];
}

void mark_face(const Mesh &mesh, const Face &face, Flags &nodes)
{
  for (std::uint32_t column = 0; column < 9; ++column)
    nodes[face_node(mesh, face, column)] = true;
}

} // namespace

Flags bodies_of(const Mesh &mesh, const std::vector<std::string> &surfaces)
{
  Flags bodies(mesh.bodies.size(), false);
  for (const NamedFace &f : faces_of(mesh, surfaces))
    bodies[mesh.cell_body[f.face.cell]] = true;
  return bodies;
}

Flags both(const Flags &a, const Flags &b)
{
  Flags result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    result[i] = a[i] && b[i];
  return result;
}

std::vector<std::uint32_t> cells_of(const Mesh &mesh, const Flags &bodies)
{
  std::vector<std::uint32_t> cells;
  for (std::uint32_t c = 0; c < mesh.cells.size(); ++c)
    if (bodies[mesh.cell_body[c]])
      cells.push_back(c);
  return cells;
}

Flags nodes_of(const Mesh &mesh, const Flags &bodies)
{
  Flags nodes(mesh.nodes.size(), false);
  for (const std::uint32_t c : cells_of(mesh, bodies))
    for (const Node n : mesh.cells[c])
      nodes[n] = true;
  return nodes;
}

Flags nodes_on(const Mesh &mesh, const std::vector<std::string> &surfaces)
{
  Flags nodes(mesh.nodes.size(), false);
  for (const NamedFace &f : faces_of(mesh, surfaces))
    mark_face(mesh, f.face, nodes);
  return nodes;
}

/// A face's centre node belongs to the cells on its two sides alone.
Flags free_surface_nodes(const Mesh &mesh, const Flags &bodies)
{
  std::vector<int> cells_at(mesh.nodes.size(), 0);
  for (std::uint32_t c = 0; c < mesh.cells.size(); ++c)
    for (std::uint32_t l = 0; l < 6; ++l)
      ++cells_at[face_node(mesh, {c, l}, centre_of_face)];
  Flags nodes(mesh.nodes.size(), false);
  for (const std::uint32_t c : cells_of(mesh, bodies))
    for (std::uint32_t l = 0; l < 6; ++l)
      if (cells_at[face_node(mesh, {c, l}, centre_of_face)] == 1)
        mark_face(mesh, {c, l}, nodes);
  return nodes;
}

std::vector<Node> difference(const Flags &nodes, const Flags &without)
{
  std::vector<Node> result;
  for (Node n = 0; n < nodes.size(); ++n)
    if (nodes[n] && !without[n])
      result.push_back(n);
  return result;
}

} // namespace ballonet::solver
