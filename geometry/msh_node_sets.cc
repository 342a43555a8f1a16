// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/msh_node_sets.h"
#include "geometry/cell_completion.h"
#include "geometry/node_order.h"
#include <algorithm>
#include <gmsh.h>
#include <map>
#include <numeric>
#include <set>

namespace ballonet::geometry
{

namespace
{

using Tags = std::vector<std::size_t>;
using Ends = std::pair<std::uint32_t, std::uint32_t>; ///< ascending
using EdgeMiddles = std::map<Ends, std::uint32_t>;

/// The middle node of every edge of a hexahedron, by its ends.
EdgeMiddles edge_middles(const Mesh &mesh)
{
  EdgeMiddles middles;
  for (const auto &cell : mesh.cells)
    for (unsigned direction = 0; direction < 3; ++direction) {
      const unsigned stride[3] = {1, 3, 9};
      const unsigned a = stride[(direction + 1) % 3], b = stride[(direction + 2) % 3];
      for (const unsigned low : {0u, 2 * a, 2 * b, 2 * a + 2 * b}) {
        const std::uint32_t ends[2] = {cell[low], cell[low + 2 * stride[direction]]};
        middles[std::minmax(ends[0], ends[1])] = cell[low + stride[direction]];
      }
    }
  return middles;
}

class SetReader
{
public:
  SetReader(const Mesh &mesh, const NodeNumbers &numbers) : middles_(edge_middles(mesh)), numbers_(numbers) {}

  NodeSet read(int dimension, int group, const std::string &name) const
  {
    std::set<std::uint32_t> nodes;
    std::vector<int> entities;
    gmsh::model::getEntitiesForPhysicalGroup(dimension, group, entities);
    for (const int entity : entities) {
      std::vector<int> types;
      std::vector<Tags> elements, tags;
      gmsh::model::mesh::getElements(types, elements, tags, dimension, entity);
      for (std::size_t t = 0; t < types.size(); ++t)
        read_elements(tags[t], tags[t].size() / elements[t].size(), name, nodes);
    }
    return {name, {nodes.begin(), nodes.end()}};
  }

private:
  /// gmsh lists the ends of a segment first.
  void read_elements(const Tags &tags, std::size_t width, const std::string &name, std::set<std::uint32_t> &nodes) const
  {
    for (std::size_t first = 0; first < tags.size(); first += width) {
      for (std::size_t i = first; i < first + width; ++i)
        nodes.insert(number(tags[i], name));
      if (width < 2)
        continue;
      const auto middle = middles_.find(std::minmax(numbers_.at(tags[first]), numbers_.at(tags[first + 1])));
      if (middle != middles_.end())
        nodes.insert(middle->second);
    }
  }

  std::uint32_t number(std::size_t tag, const std::string &name) const
  {
    const auto found = numbers_.find(tag);
    if (found == numbers_.end() || found->second == no_node)
      fail_reading("the curve or point \"" + name + "\" has a node that no hexahedron has");
    return found->second;
  }

  EdgeMiddles middles_;
  const NodeNumbers &numbers_;
};

} // namespace

std::vector<NodeSet> read_node_sets(const Mesh &mesh, const NodeNumbers &numbers)
{
  std::vector<NodeSet> sets;
  std::set<std::string> names;
  const SetReader reader(mesh, numbers);
  for (const int dimension : {1, 0}) {
    gmsh::vectorpair groups;
    gmsh::model::getPhysicalGroups(groups, dimension);
    for (const auto &[unused, group] : groups) {
      std::string name;
      gmsh::model::getPhysicalName(dimension, group, name);
      if (name.empty())
        continue;
      if (!names.insert(name).second)
        fail_reading("\"" + name + "\" is the name of two physical curves or points");
      sets.push_back(reader.read(dimension, group, name));
    }
  }
  return sets;
}

void add_node_sets(const Mesh &mesh, std::size_t first_element)
{
  for (std::size_t s = 0; s < mesh.node_sets.size(); ++s) {
    const NodeSet &set = mesh.node_sets[s];
    const int tag = static_cast<int>(s) + 1;
    Tags elements(set.nodes.size()), nodes;
    std::iota(elements.begin(), elements.end(), first_element);
    first_element += elements.size();
    for (const std::uint32_t node : set.nodes)
      nodes.push_back(node + 1);
    gmsh::model::addDiscreteEntity(0, tag);
    gmsh::model::mesh::addElementsByType(tag, gmsh_type::point, elements, nodes);
    gmsh::model::addPhysicalGroup(0, {tag}, tag);
    gmsh::model::setPhysicalName(0, tag, set.name);
  }
}

} // namespace ballonet::geometry
