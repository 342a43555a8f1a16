// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace ballonet::solver
{

/// A face of the mesh: cell index and local face number in deal.II order (0: x-, 1: x+, 2: y-, 3: y+, 4: z-, 5: z+ of
/// the cell's own reference coordinates).
struct Face {
  std::uint32_t cell;
  std::uint32_t local;
};

/// A named set of faces. A face may belong to several surfaces.
struct Surface {
  std::string name;
  std::vector<Face> faces;
};

/// A named set of nodes: a curve or a point that is held, loaded or measured.
struct NodeSet {
  std::string name;
  std::vector<std::uint32_t> nodes;
};

/// A mesh of 27-node hexahedra in plain arrays (lengths in mm).
struct Mesh {
  std::vector<std::array<double, 3>> nodes;
  /// Node numbers of each cell, lexicographic: local node i + 3 j + 9 k sits at reference point (i, j, k) / 2.
  std::vector<std::array<std::uint32_t, 27>> cells;
  std::vector<std::uint32_t> cell_body; ///< index into bodies, one per cell
  std::vector<std::string> bodies;      ///< names; every cell belongs to exactly one body
  std::vector<Surface> surfaces;
  std::vector<NodeSet> node_sets;
};

} // namespace ballonet::solver
