// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/boundary.h"
#include "geometry/hexahedron.h"
#include "tests/geometry/built_mesh.h"
#include <algorithm>
#include <map>

using namespace ballonet::geometry;

namespace
{

using FaceNodes = std::array<std::uint32_t, 9>;

/// How many cells have a face with exactly these nine nodes.
std::map<FaceNodes, int> face_uses(const Mesh &mesh)
{
  std::map<FaceNodes, int> uses;
  for (std::uint32_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (std::uint32_t local = 0; local < 6; ++local) {
      FaceNodes nodes = nodes_of(mesh, {cell, local});
      std::sort(nodes.begin(), nodes.end());
      ++uses[nodes];
    }
  return uses;
}

/// Sum over the free faces of the directed edges' signs: zero everywhere if they close a surface.
std::map<std::pair<std::uint32_t, std::uint32_t>, int> open_edges(const Mesh &mesh)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Face &face : free_faces(mesh)) {
    const auto n = nodes_of(mesh, face);
    const std::array<std::uint32_t, 4> loop = {n[0], n[2], n[8], n[6]};
    for (unsigned i = 0; i < 4; ++i) {
      const std::uint32_t a = loop[i], b = loop[(i + 1) % 4];
      edges[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  }
  return edges;
}

void check_conforming(const Mesh &mesh)
{
  std::size_t free = 0;
  for (const auto &[nodes, uses] : face_uses(mesh)) {
    REQUIRE(uses <= 2);
    free += uses == 1 ? 1 : 0;
  }
  CHECK(free == free_faces(mesh).size());
  for (const auto &[edge, sum] : open_edges(mesh))
    REQUIRE(sum == 0);
}

/// No two nodes of the same body in one place.
void check_no_duplicates(const Mesh &mesh)
{
  std::vector<std::uint32_t> body(mesh.nodes.size());
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    for (const std::uint32_t node : mesh.cells[cell])
      body[node] = mesh.cell_body[cell];
  std::vector<std::uint32_t> order(mesh.nodes.size());
  for (std::uint32_t i = 0; i < order.size(); ++i)
    order[i] = i;
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return mesh.nodes[a][2] < mesh.nodes[b][2]; });
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && mesh.nodes[order[j]][2] - mesh.nodes[order[i]][2] < 1e-6; ++j) {
      if (body[order[i]] != body[order[j]])
        continue;
      const Point d = difference(mesh.nodes[order[i]], mesh.nodes[order[j]]);
      REQUIRE(dot(d, d) > 1e-12);
    }
}

} // namespace

TEST_CASE("meshes conform: inner faces have two cells, free faces close a surface, nodes are unique")
{
  const bool symmetry = GENERATE(true, false);
  MeshSizes sizes;
  sizes.symmetry = symmetry;
  const Mesh mesh = built(short_pebs(), sizes).mesh;
  check_conforming(mesh);
  check_no_duplicates(mesh);
}

TEST_CASE("finer meshes conform as well")
{
  MeshSizes sizes = full_model();
  sizes.through_wall = 2;
  sizes.through_rib = 2;
  sizes.along_rib = 2;
  sizes.through_head = 2;
  sizes.disc_rings = 2;
  sizes.around_ring = 32;
  sizes.across_wall = 6;
  sizes.balloon_through = 2;
  sizes.balloon_around = 24;
  const Mesh mesh = built(short_pebs(), sizes).mesh;
  check_conforming(mesh);
  check_no_duplicates(mesh);
}

TEST_CASE("every node belongs to a cell, every cell has 27 different ones")
{
  const Mesh mesh = built(short_pebs(), {}).mesh;
  std::vector<bool> used(mesh.nodes.size(), false);
  for (auto cell : mesh.cells) {
    for (const std::uint32_t node : cell)
      used.at(node) = true;
    std::sort(cell.begin(), cell.end());
    REQUIRE(std::adjacent_find(cell.begin(), cell.end()) == cell.end());
  }
  CHECK(std::all_of(used.begin(), used.end(), [](bool u) { return u; }));
}

TEST_CASE("face nodes point outwards")
{
  const Mesh mesh = built(short_pebs(), {}).mesh;
  const CellNodes nodes = cell_nodes(mesh, 0);
  for (unsigned local = 0; local < 6; ++local) {
    const auto face = face_nodes(local);
    const Point normal = cross(difference(nodes[face[2]], nodes[face[0]]), difference(nodes[face[6]], nodes[face[0]]));
    CHECK(dot(normal, difference(nodes[face[4]], nodes[13])) > 0);
  }
}
