// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/mesh.h"

namespace ballonet::geometry
{

/// Marks a middle node that a cell does not have.
constexpr std::uint32_t no_node = 0xffffffff;

/// Gives all cells their 27 nodes (lexicographic; corners must be there, middle nodes may be no_node). New nodes lie
/// where the 8- or 20-node interpolation has them; neighbours share them.
void complete_cells(std::vector<Point> &nodes, std::vector<std::array<std::uint32_t, 27>> &cells);

} // namespace ballonet::geometry
