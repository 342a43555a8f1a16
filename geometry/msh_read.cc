// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/cell_completion.h"
#include "geometry/gmsh_session.h"
#include "geometry/mesh_io.h"
#include "geometry/msh_node_sets.h"
#include "geometry/node_order.h"
#include "geometry/quality.h"
#include <gmsh.h>
#include <limits>
#include <map>

namespace ballonet::geometry
{

namespace
{

using Tags = std::vector<std::size_t>;

/// Reads gmsh's current model; throws std::runtime_error with the reason.
class ModelReader
{
public:
  Mesh read()
  {
    refuse_other_cells();
    read_nodes();
    read_bodies();
    drop_and_complete();
    mesh_.surfaces = read_surfaces(mesh_, node_);
    mesh_.node_sets = read_node_sets(mesh_, node_);
    return std::move(mesh_);
  }

private:
  void refuse_other_cells() const
  {
    std::vector<int> types;
    gmsh::model::mesh::getElementTypes(types, 3);
    if (types.empty())
      fail_reading("the file has no hexahedra");
    for (const int type : types)
      if (type != gmsh_type::hex8 && type != gmsh_type::hex20 && type != gmsh_type::hex27)
        fail_reading("the file has volume elements of type \"" + element_name(type) +
                     "\"; only hexahedra of 8, 20 or 27 nodes can be used");
  }

  void read_nodes()
  {
    Tags tags;
    std::vector<double> coordinates, parametric;
    gmsh::model::mesh::getNodes(tags, coordinates, parametric, -1, -1, false, false);
    std::map<std::size_t, Point> sorted;
    for (std::size_t i = 0; i < tags.size(); ++i)
      sorted[tags[i]] = {coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]};
    for (const auto &[tag, point] : sorted) {
      node_[tag] = static_cast<std::uint32_t>(mesh_.nodes.size());
      mesh_.nodes.push_back(point);
    }
  }

  void read_bodies()
  {
    gmsh::vectorpair groups;
    gmsh::model::getPhysicalGroups(groups, 3);
    if (groups.empty())
      fail_reading("the file has no physical volume: name the bodies as physical volumes");
    for (const auto &[dimension, tag] : groups) {
      mesh_.bodies.push_back({group_name(3, tag)});
      std::vector<int> entities;
      gmsh::model::getEntitiesForPhysicalGroup(3, tag, entities);
      for (const int entity : entities)
        for (const int type : {gmsh_type::hex8, gmsh_type::hex20, gmsh_type::hex27})
          read_cells(entity, type);
    }
    refuse_cells_without_body();
    sort_cells();
  }

  void read_cells(int entity, int type)
  {
    Tags elements, nodes;
    gmsh::model::mesh::getElementsByType(type, elements, nodes, entity);
    const std::vector<unsigned> places = lexicographic_places(type);
    for (std::size_t e = 0; e < elements.size(); ++e) {
      RawCell cell{static_cast<std::uint32_t>(mesh_.bodies.size() - 1), {}};
      cell.nodes.fill(no_node);
      for (std::size_t i = 0; i < places.size(); ++i)
        cell.nodes[places[i]] = node_.at(nodes[e * places.size() + i]);
      if (!cells_.try_emplace(elements[e], cell).second)
        fail_reading("hexahedron " + std::to_string(elements[e]) + " is in more than one physical volume");
    }
  }

  void refuse_cells_without_body() const
  {
    std::size_t all = 0;
    for (const int type : {gmsh_type::hex8, gmsh_type::hex20, gmsh_type::hex27}) {
      Tags elements, nodes;
      gmsh::model::mesh::getElementsByType(type, elements, nodes);
      all += elements.size();
    }
    if (all != cells_.size())
      fail_reading(std::to_string(all - cells_.size()) + " hexahedra are in no physical volume");
  }

  void sort_cells()
  {
    for (const auto &[tag, cell] : cells_) {
      mesh_.cells.push_back(cell.nodes);
      mesh_.cell_body.push_back(cell.body);
    }
  }

  /// Forgets nodes no hexahedron uses (of curves and points, say) and adds the missing middle nodes.
  void drop_and_complete()
  {
    std::vector<std::uint32_t> number(mesh_.nodes.size(), no_node);
    for (const auto &cell : mesh_.cells)
      for (const std::uint32_t node : cell)
        if (node != no_node)
          number[node] = 0;
    std::vector<Point> kept;
    for (std::size_t node = 0; node < number.size(); ++node)
      if (number[node] == 0) {
        number[node] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(mesh_.nodes[node]);
      }
    for (auto &cell : mesh_.cells)
      for (std::uint32_t &node : cell)
        node = node == no_node ? no_node : number[node];
    for (auto &[tag, node] : node_)
      node = number[node];
    mesh_.nodes = std::move(kept);
    complete_cells(mesh_.nodes, mesh_.cells);
  }

  struct RawCell {
    std::uint32_t body;
    std::array<std::uint32_t, 27> nodes;
  };

  Mesh mesh_;
  NodeNumbers node_;
  std::map<std::size_t, RawCell> cells_; ///< by gmsh's tag
};

} // namespace

std::variant<Mesh, MeshFailure> read_msh(const std::filesystem::path &path)
{
  if (!std::filesystem::is_regular_file(path))
    return MeshFailure{"there is no file " + path.string(), {}};
  Mesh mesh;
  const auto reason = in_gmsh([&] {
    gmsh::open(path.string());
    mesh = ModelReader().read();
  });
  if (reason)
    return MeshFailure{path.string() + ": " + *reason, {}};
  mesh.quality = measure_quality(mesh);
  if (const auto folded = rejection(mesh, mesh.quality, {0, std::numeric_limits<double>::infinity()}))
    return MeshFailure{path.string() + ": " + *folded, {}};
  return mesh;
}

} // namespace ballonet::geometry
