// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/msh_surfaces.h"
#include "geometry/boundary.h"
#include "geometry/hexahedron.h"
#include "geometry/node_order.h"
#include <algorithm>
#include <gmsh.h>
#include <map>
#include <stdexcept>

namespace ballonet::geometry
{

namespace
{

using Tags = std::vector<std::size_t>;
using Corners = std::array<std::uint32_t, 4>; ///< sorted
using FaceTable = std::map<Corners, Face>;

Corners sorted(Corners corners)
{
  std::sort(corners.begin(), corners.end());
  return corners;
}

/// The free faces by their corners.
FaceTable free_face_table(const Mesh &mesh)
{
  FaceTable table;
  for (const Face &face : free_faces(mesh)) {
    const auto n = nodes_of(mesh, face);
    table[sorted({n[face_corners[0]], n[face_corners[1]], n[face_corners[2]], n[face_corners[3]]})] = face;
  }
  return table;
}

bool is_quadrilateral(int type)
{
  return type == gmsh_type::quad4 || type == gmsh_type::quad8 || type == gmsh_type::quad9;
}

class SurfaceReader
{
public:
  SurfaceReader(const Mesh &mesh, const NodeNumbers &numbers) : table_(free_face_table(mesh)), numbers_(numbers) {}

  Surface read(int group) const
  {
    Surface surface{group_name(2, group), {}};
    std::vector<int> entities, types;
    gmsh::model::getEntitiesForPhysicalGroup(2, group, entities);
    for (const int entity : entities) {
      gmsh::model::mesh::getElementTypes(types, 2, entity);
      for (const int type : types)
        read_faces(entity, type, surface);
    }
    std::sort(surface.faces.begin(), surface.faces.end(),
              [](const Face &a, const Face &b) { return std::pair(a.cell, a.local) < std::pair(b.cell, b.local); });
    return surface;
  }

private:
  void read_faces(int entity, int type, Surface &surface) const
  {
    if (!is_quadrilateral(type))
      fail_reading("surface \"" + surface.name + "\" has elements of type \"" + element_name(type) +
                   "\" instead of quadrilaterals");
    Tags elements, nodes;
    gmsh::model::mesh::getElementsByType(type, elements, nodes, entity);
    const std::size_t width = nodes.size() / std::max<std::size_t>(elements.size(), 1);
    for (std::size_t e = 0; e < elements.size(); ++e)
      surface.faces.push_back(find_face(&nodes[e * width], surface.name));
  }

  /// gmsh lists an element's corners first.
  Face find_face(const std::size_t *tags, const std::string &surface) const
  {
    Corners corners{};
    for (unsigned i = 0; i < 4; ++i)
      corners[i] = numbers_.at(tags[i]);
    const auto found = table_.find(sorted(corners));
    if (found == table_.end())
      fail_reading("surface \"" + surface + "\" has a face that is not on the boundary of the hexahedra");
    return found->second;
  }

  FaceTable table_;
  const NodeNumbers &numbers_;
};

} // namespace

void fail_reading(const std::string &reason) { throw std::runtime_error(reason); }

std::string element_name(int type)
{
  std::string name;
  int dimension = 0, order = 0, nodes = 0, corners = 0;
  std::vector<double> reference;
  gmsh::model::mesh::getElementProperties(type, name, dimension, order, nodes, reference, corners);
  return name;
}

std::string group_name(int dimension, int tag)
{
  std::string name;
  gmsh::model::getPhysicalName(dimension, tag, name);
  if (name.empty())
    fail_reading("the physical " + std::string(dimension == 3 ? "volume " : "surface ") + std::to_string(tag) +
                 " has no name");
  return name;
}

std::vector<Surface> read_surfaces(const Mesh &mesh, const NodeNumbers &numbers)
{
  const SurfaceReader reader(mesh, numbers);
  gmsh::vectorpair groups;
  gmsh::model::getPhysicalGroups(groups, 2);
  std::vector<Surface> surfaces;
  for (const auto &[dimension, tag] : groups)
    surfaces.push_back(reader.read(tag));
  return surfaces;
}

} // namespace ballonet::geometry
