// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/mesh.h"
#include <cstdint>
#include <functional>
#include <unordered_map>

namespace ballonet::geometry
{

/// The parts of an actuator that a block can belong to.
enum class Part { balloon, base, rib, strip, head };

/// What a face of a block is when it turns out to be free.
enum class Side { none, inner, outer, lower, upper, edge };

/// Where a cell belongs and what its six faces are, in the order of local face numbers.
struct CellTag {
  Part part;
  int index = 0;     ///< number of the rib or gap
  bool land = false; ///< the wall's land in a rib ring
  std::array<Side, 6> sides = {};
};

struct TaggedMesh {
  Mesh mesh;
  std::vector<CellTag> tags; ///< one per cell
};

/// Finds nodes by position, one table per body: what coincides within a body is the same node.
class NodeTable
{
public:
  std::uint32_t find_or_add(const Point &point, std::vector<Point> &nodes);

private:
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> buckets_;
};

/// Collects structured blocks of curved hexahedra; blocks that touch share nodes.
class BlockMesh
{
public:
  /// Position at (i, j, k), each from 0 to the number of elements in that direction; asked at whole and half numbers.
  using Map = std::function<Point(double, double, double)>;

  /// Adds a block of counts[0] x counts[1] x counts[2] cells to a body. `tag.sides` are the sides of the whole block; a
  /// side shows on every cell's face of that direction and matters only where it is free. A left-handed map is turned.
  void add(const std::string &body, const std::array<int, 3> &counts, const Map &map, CellTag tag);

  /// Hands out all cells, or only those with y >= 0.
  TaggedMesh finish(bool half) &&;

private:
  std::uint32_t find_or_add_body(const std::string &name);
  void add_cell(std::uint32_t body, const Map &map, const std::array<int, 3> &at, bool turned, const CellTag &tag);

  TaggedMesh result_;
  std::vector<NodeTable> tables_; ///< one per body
};

} // namespace ballonet::geometry
