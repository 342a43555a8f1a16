// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/boundary.h"
#include "geometry/gmsh_session.h"
#include "geometry/mesh_io.h"
#include "geometry/msh_node_sets.h"
#include "geometry/node_order.h"
#include <gmsh.h>
#include <map>
#include <numeric>

namespace ballonet::geometry
{

namespace
{

using Tags = std::vector<std::size_t>;

Tags counted(std::size_t first, std::size_t count)
{
  Tags tags(count);
  std::iota(tags.begin(), tags.end(), first);
  return tags;
}

void add_nodes(const Mesh &mesh)
{
  std::vector<double> coordinates;
  coordinates.reserve(3 * mesh.nodes.size());
  for (const Point &node : mesh.nodes)
    coordinates.insert(coordinates.end(), node.begin(), node.end());
  gmsh::model::mesh::addNodes(3, 1, counted(1, mesh.nodes.size()), coordinates);
}

void add_cells(const Mesh &mesh)
{
  const std::vector<unsigned> places = lexicographic_places(gmsh_type::hex27);
  for (std::size_t body = 0; body < mesh.bodies.size(); ++body) {
    Tags elements, nodes;
    for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
      if (mesh.cell_body[cell] != body)
        continue;
      elements.push_back(cell + 1);
      for (const unsigned place : places)
        nodes.push_back(mesh.cells[cell][place] + 1);
    }
    gmsh::model::mesh::addElementsByType(static_cast<int>(body) + 1, gmsh_type::hex27, elements, nodes);
  }
}

void add_bodies(const Mesh &mesh)
{
  for (std::size_t body = 0; body < mesh.bodies.size(); ++body) {
    const int tag = static_cast<int>(body) + 1;
    gmsh::model::addDiscreteEntity(3, tag);
    gmsh::model::addPhysicalGroup(3, {tag}, tag);
    gmsh::model::setPhysicalName(3, tag, mesh.bodies[body].name);
  }
}

/// Faces by the set of surfaces they belong to: in a gmsh file a face is stored once, in an entity that may be part of
/// several physical groups.
std::map<std::vector<int>, std::vector<Face>> faces_by_surfaces(const Mesh &mesh)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<int>> groups;
  for (std::size_t surface = 0; surface < mesh.surfaces.size(); ++surface)
    for (const Face &face : mesh.surfaces[surface].faces)
      groups[{face.cell, face.local}].push_back(static_cast<int>(surface));
  std::map<std::vector<int>, std::vector<Face>> faces;
  for (const auto &[face, surfaces] : groups)
    faces[surfaces].push_back({face.first, face.second});
  return faces;
}

void add_faces(const Mesh &mesh, int entity, const std::vector<Face> &faces, std::size_t first_element)
{
  const std::vector<unsigned> places = lexicographic_places(gmsh_type::quad9);
  Tags nodes;
  for (const Face &face : faces)
    for (const unsigned place : places)
      nodes.push_back(nodes_of(mesh, face)[place] + 1);
  gmsh::model::mesh::addElementsByType(entity, gmsh_type::quad9, counted(first_element, faces.size()), nodes);
}

/// Returns the next free number of an element.
std::size_t add_surfaces(const Mesh &mesh)
{
  std::vector<std::vector<int>> entities(mesh.surfaces.size());
  std::size_t next_element = mesh.cells.size() + 1;
  int entity = 0;
  for (const auto &[surfaces, faces] : faces_by_surfaces(mesh)) {
    gmsh::model::addDiscreteEntity(2, ++entity);
    add_faces(mesh, entity, faces, next_element);
    next_element += faces.size();
    for (const int surface : surfaces)
      entities[static_cast<std::size_t>(surface)].push_back(entity);
  }
  for (std::size_t surface = 0; surface < entities.size(); ++surface) {
    const int tag = static_cast<int>(surface) + 1;
    gmsh::model::addPhysicalGroup(2, entities[surface], tag);
    gmsh::model::setPhysicalName(2, tag, mesh.surfaces[surface].name);
  }
  return next_element;
}

} // namespace

std::optional<MeshFailure> write_msh(const Mesh &mesh, const std::filesystem::path &path)
{
  const auto reason = in_gmsh([&] {
    add_bodies(mesh);
    add_nodes(mesh);
    add_cells(mesh);
    add_node_sets(mesh, add_surfaces(mesh));
    gmsh::option::setNumber("Mesh.MshFileVersion", 4.1);
    gmsh::option::setNumber("Mesh.Binary", 1);
    gmsh::write(path.string());
  });
  if (reason || !std::filesystem::exists(path))
    return MeshFailure{"cannot write " + path.string() + (reason ? ": " + *reason : ""), {}};
  return std::nullopt;
}

} // namespace ballonet::geometry
