// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/mesh_failure.h"
#include "geometry/parameters.h"

namespace ballonet::geometry
{

/// Everything that cannot be built, with the two parameters that contradict each other; empty: all is well.
/// Ranges of single values are those of fields() and not repeated here.
std::vector<Problem> check(const Balloon &balloon);
std::vector<Problem> check(const Pebs &pebs);
/// The same with the mesh: element counts and the half model, whose keys start with "mesh.".
std::vector<Problem> check(const MeshSizes &sizes);
std::vector<Problem> check(const Pebs &pebs, const MeshSizes &sizes);

} // namespace ballonet::geometry
