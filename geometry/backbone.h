// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/block_mesh.h"
#include "geometry/parameters.h"

namespace ballonet::geometry
{

/// Adds the backbone: base disc, per gap a strip of the corrugated wall, per rib a ring closed by the wall's land, head
/// disc on the top rib. One conforming mesh. The wall's thickness is the inner layer of every ring.
/// Expects parameters without problems (parameter_check.h).
void add_backbone(BlockMesh &blocks, const Pebs &pebs, const MeshSizes &sizes);

} // namespace ballonet::geometry
