// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/msh_surfaces.h"

namespace ballonet::geometry
{

/// The named physical curves and points of gmsh's current model as sets of nodes, ascending; those without a name are
/// left out. Along an edge of a hexahedron its middle node is in the set too, also where the file has none. `mesh` has
/// its nodes and cells.
std::vector<NodeSet> read_node_sets(const Mesh &mesh, const NodeNumbers &numbers);

/// Writes the sets into gmsh's current model as physical points; the nodes' tags are their numbers plus one, tags of
/// elements begin at `first_element`.
void add_node_sets(const Mesh &mesh, std::size_t first_element);

} // namespace ballonet::geometry
