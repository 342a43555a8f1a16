// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/cell_completion.h"
#include <algorithm>
#include <map>

namespace ballonet::geometry
{

namespace
{

using Cell = std::array<std::uint32_t, 27>;

/// How many of a place's three coordinates are in the middle: 0 corner, 1 edge, 2 face, 3 centre.
unsigned middle_axes(unsigned place) { return (place % 3 == 1) + (place / 3 % 3 == 1) + (place / 9 == 1); }

/// Is `part` on the closure of the edge or face `whole`?
bool touches(unsigned part, unsigned whole)
{
  for (unsigned stride = 1; stride <= 9; stride *= 3) {
    const unsigned of_part = part / stride % 3, of_whole = whole / stride % 3;
    if (of_whole != 1 && of_part != of_whole)
      return false;
  }
  return true;
}

/// The nodes of the given kind (0 corners, 1 edges) on the closure of a place.
std::vector<std::uint32_t> nodes_around(const Cell &cell, unsigned place, unsigned kind)
{
  std::vector<std::uint32_t> found;
  for (unsigned other = 0; other < 27; ++other)
    if (middle_axes(other) == kind && touches(other, place))
      found.push_back(cell[other]);
  return found;
}

class Completion
{
public:
  explicit Completion(std::vector<Point> &nodes) : nodes_(nodes) {}

  /// Fills the missing nodes of one kind (1 edges, 2 faces, 3 centres) in all cells.
  void fill(std::vector<Cell> &cells, unsigned kind)
  {
    known_.clear();
    for (Cell &cell : cells)
      for (unsigned place = 0; place < 27; ++place)
        if (middle_axes(place) == kind && cell[place] != no_node)
          known_[key(cell, place)] = cell[place];
    for (Cell &cell : cells)
      for (unsigned place = 0; place < 27; ++place)
        if (middle_axes(place) == kind && cell[place] == no_node)
          cell[place] = find_or_add(cell, place, kind);
  }

private:
  static std::vector<std::uint32_t> key(const Cell &cell, unsigned place)
  {
    auto corners = nodes_around(cell, place, 0);
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  std::uint32_t find_or_add(const Cell &cell, unsigned place, unsigned kind)
  {
    const auto [entry, is_new] = known_.try_emplace(key(cell, place), static_cast<std::uint32_t>(nodes_.size()));
    if (is_new)
      nodes_.push_back(interpolated(cell, place, kind));
    return entry->second;
  }

  /// Serendipity interpolation: -1/4 of the corners plus 1/2 (face) or 1/4 (centre) of the edges.
  Point interpolated(const Cell &cell, unsigned place, unsigned kind) const
  {
    Point sum{};
    const auto add = [&](const std::vector<std::uint32_t> &list, double weight) {
      for (const std::uint32_t node : list)
        for (unsigned d = 0; d < 3; ++d)
          sum[d] += weight * nodes_[node][d];
    };
    add(nodes_around(cell, place, 0), kind == 1 ? 0.5 : -0.25);
    if (kind > 1)
      add(nodes_around(cell, place, 1), kind == 2 ? 0.5 : 0.25);
    return sum;
  }

  std::vector<Point> &nodes_;
  std::map<std::vector<std::uint32_t>, std::uint32_t> known_; ///< by sorted corners
};

} // namespace

void complete_cells(std::vector<Point> &nodes, std::vector<Cell> &cells)
{
  Completion completion(nodes);
  for (const unsigned kind : {1U, 2U, 3U})
    completion.fill(cells, kind);
}

} // namespace ballonet::geometry
