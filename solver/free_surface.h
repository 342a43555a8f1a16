// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/mesh.h"
#include "solver/types.h"
#include <string>
#include <vector>

/// Which bodies and nodes the checks of a contact pair look at.
namespace ballonet::solver
{

/// One flag per body or per node of a mesh.
using Flags = std::vector<bool>;

/// Bodies with a face of the given surfaces.
Flags bodies_of(const Mesh &, const std::vector<std::string> &surfaces);

/// What has both flags.
Flags both(const Flags &, const Flags &);

/// Cells of these bodies, ascending.
std::vector<std::uint32_t> cells_of(const Mesh &, const Flags &bodies);

/// Nodes of these bodies.
Flags nodes_of(const Mesh &, const Flags &bodies);

/// Nodes on the faces of these surfaces.
Flags nodes_on(const Mesh &, const std::vector<std::string> &surfaces);

/// Nodes on faces of these bodies that no second cell shares.
Flags free_surface_nodes(const Mesh &, const Flags &bodies);

/// Nodes with the first flag but not the second, ascending.
std::vector<Node> difference(const Flags &nodes, const Flags &without);

} // namespace ballonet::solver
