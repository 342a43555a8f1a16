// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/block_mesh.h"
#include "geometry/parameters.h"

namespace ballonet::geometry
{

/// Adds the balloon: a tube from z = 0 and its hemispherical dome, meshed as an O-grid on the sphere.
/// `pitch`: the length MeshSizes::balloon_per_pitch refers to, mm.
void add_balloon(BlockMesh &blocks, const Balloon &balloon, const MeshSizes &sizes, double pitch);

} // namespace ballonet::geometry
