// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <vector>

namespace ballonet::geometry
{

/// gmsh's numbers of the element types we deal with.
namespace gmsh_type
{
constexpr int point = 15;
constexpr int quad4 = 3, quad9 = 10, quad8 = 16;
constexpr int hex8 = 5, hex27 = 12, hex20 = 17;
} // namespace gmsh_type

/// For each node of a quadrilateral or hexahedron in gmsh's order its lexicographic place (i + 3 j + 9 k on the 3 x 3 x
/// 3 grid), read from gmsh's own table of reference coordinates. Needs a running gmsh session.
std::vector<unsigned> lexicographic_places(int element_type);

} // namespace ballonet::geometry
