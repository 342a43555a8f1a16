// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/place.h"
#include "solver/discretization.h"
#include <algorithm>
#include <sstream>

namespace ballonet::solver
{

namespace
{

template <class List, class Item>
bool in(const List &list, const Item &item)
{
  return std::find(list.begin(), list.end(), item) != list.end();
}

} // namespace

std::string place_of(const Mesh &mesh, Node node, const State &state, const std::vector<ContactPair> &pairs)
{
  const auto cell =
      std::find_if(mesh.cells.begin(), mesh.cells.end(), [&](const auto &nodes) { return in(nodes, node); });
  std::ostringstream text;
  text.precision(4);
  text << "body \"" << mesh.bodies[mesh.cell_body[cell - mesh.cells.begin()]] << "\" at (";
  for (int d = 0; d < 3; ++d)
    text << mesh.nodes[node][d] + state.displacement[3 * node + d] << (d < 2 ? ", " : ") mm, element ");
  text << cell - mesh.cells.begin();
  for (const auto &pair : pairs)
    for (const Surface &surface : mesh.surfaces)
      if (in(pair.secondary, surface.name) || in(pair.primary, surface.name))
        if (const auto nodes = surface_nodes(mesh, surface.name); in(nodes, node))
          text << ", on \"" << surface.name << "\" of contact pair \"" << pair.name << '"';
  return text.str();
}

} // namespace ballonet::solver
