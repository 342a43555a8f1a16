// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/mesh.h"
#include <unordered_map>

/// Parts of reading a gmsh file that look at gmsh's current model. What cannot be used ends in fail_reading().
namespace ballonet::geometry
{

/// Our node number by gmsh's tag.
using NodeNumbers = std::unordered_map<std::size_t, std::uint32_t>;

/// Throws std::runtime_error; in_gmsh() turns it into a reason.
[[noreturn]] void fail_reading(const std::string &reason);

/// gmsh's name of an element type, "Tetrahedron 4" for instance.
std::string element_name(int type);

/// The name of a physical volume (dimension 3) or surface (2), which must have one.
std::string group_name(int dimension, int tag);

/// The named physical surfaces, faces by cell and local number. `mesh` has its nodes, cells and bodies.
std::vector<Surface> read_surfaces(const Mesh &mesh, const NodeNumbers &numbers);

} // namespace ballonet::geometry
