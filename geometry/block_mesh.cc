// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/block_mesh.h"
#include "geometry/hexahedron.h"
#include <cmath>
#include <limits>
#include <utility>

namespace ballonet::geometry
{

namespace
{

constexpr double merge_distance = 1e-7; // mm; maps of neighbouring blocks agree to about 1e-13
constexpr double bucket_size = 1e-3;    // mm
constexpr double zero_distance = 1e-10; // mm; coordinates below it lie on a plane of symmetry or the datum

std::uint64_t bucket_key(const std::array<std::int64_t, 3> &index)
{
  constexpr std::uint64_t mask = (1U << 21) - 1;
  std::uint64_t key = 0;
  for (const std::int64_t i : index)
    key = key << 21 | (static_cast<std::uint64_t>(i) & mask);
  return key;
}

Point cleaned(Point point)
{
  for (double &x : point)
    if (std::abs(x) < zero_distance)
      x = 0;
  return point;
}

bool left_handed(const std::array<int, 3> &counts, const BlockMesh::Map &map)
{
  const double i = counts[0] / 2., j = counts[1] / 2., k = counts[2] / 2., h = 1e-3;
  const Point centre = map(i, j, k);
  const Point a = difference(map(i + h, j, k), centre), b = difference(map(i, j + h, k), centre),
              c = difference(map(i, j, k + h), centre);
  return dot(a, cross(b, c)) < 0;
}

/// Keeps the nodes that cells use, in the order of their numbers.
void drop_unused_nodes(Mesh &mesh)
{
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> number(mesh.nodes.size(), unused);
  for (const auto &cell : mesh.cells)
    for (const std::uint32_t node : cell)
      number[node] = 0;
  std::vector<Point> kept;
  for (std::size_t node = 0; node < number.size(); ++node)
    if (number[node] != unused) {
      number[node] = static_cast<std::uint32_t>(kept.size());
      kept.push_back(mesh.nodes[node]);
    }
  mesh.nodes = std::move(kept);
  for (auto &cell : mesh.cells)
    for (std::uint32_t &node : cell)
      node = number[node];
}

} // namespace

std::uint32_t NodeTable::find_or_add(const Point &point, std::vector<Point> &nodes)
{
  std::array<std::int64_t, 3> home{};
  for (unsigned d = 0; d < 3; ++d)
    home[d] = std::llround(point[d] / bucket_size);
  for (unsigned i = 0; i < 27; ++i) {
    const std::array<std::int64_t, 3> near = {home[0] + i % 3 - 1, home[1] + i / 3 % 3 - 1, home[2] + i / 9 - 1};
    const auto bucket = buckets_.find(bucket_key(near));
    if (bucket == buckets_.end())
      continue;
    for (const std::uint32_t node : bucket->second) {
      const Point d = difference(nodes[node], point);
      if (dot(d, d) < merge_distance * merge_distance)
        return node;
    }
  }
  nodes.push_back(point);
  const auto added = static_cast<std::uint32_t>(nodes.size() - 1);
  buckets_[bucket_key(home)].push_back(added);
  return added;
}

std::uint32_t BlockMesh::find_or_add_body(const std::string &name)
{
  auto &bodies = result_.mesh.bodies;
  for (std::uint32_t body = 0; body < bodies.size(); ++body)
    if (bodies[body].name == name)
      return body;
  bodies.push_back({name});
  tables_.emplace_back();
  return static_cast<std::uint32_t>(bodies.size() - 1);
}

void BlockMesh::add(const std::string &body, const std::array<int, 3> &counts, const Map &map, CellTag tag)
{
  const std::uint32_t number = find_or_add_body(body);
  const bool turned = left_handed(counts, map);
  const std::array<int, 3> loops = {counts[turned ? 1 : 0], counts[turned ? 0 : 1], counts[2]};
  if (turned) {
    std::swap(tag.sides[0], tag.sides[2]);
    std::swap(tag.sides[1], tag.sides[3]);
  }
  for (int k = 0; k < loops[2]; ++k)
    for (int j = 0; j < loops[1]; ++j)
      for (int i = 0; i < loops[0]; ++i)
        add_cell(number, map, {i, j, k}, turned, tag);
}

void BlockMesh::add_cell(std::uint32_t body, const Map &map, const std::array<int, 3> &at, bool turned,
                         const CellTag &tag)
{
  std::array<std::uint32_t, 27> cell{};
  for (unsigned n = 0; n < 27; ++n) {
    const double i = at[0] + n % 3 / 2., j = at[1] + n / 3 % 3 / 2., k = at[2] + n / 9 / 2.;
    const Point point = turned ? map(j, i, k) : map(i, j, k);
    cell[n] = tables_[body].find_or_add(cleaned(point), result_.mesh.nodes);
  }
  result_.mesh.cells.push_back(cell);
  result_.mesh.cell_body.push_back(body);
  result_.tags.push_back(tag);
}

TaggedMesh BlockMesh::finish(bool half) &&
{
  Mesh &mesh = result_.mesh;
  TaggedMesh kept;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    if (half && mesh.nodes[mesh.cells[cell][13]][1] < 0)
      continue;
    kept.mesh.cells.push_back(mesh.cells[cell]);
    kept.mesh.cell_body.push_back(mesh.cell_body[cell]);
    kept.tags.push_back(result_.tags[cell]);
  }
  kept.mesh.bodies = std::move(mesh.bodies);
  kept.mesh.nodes = std::move(mesh.nodes);
  drop_unused_nodes(kept.mesh);
  return kept;
}

} // namespace ballonet::geometry
