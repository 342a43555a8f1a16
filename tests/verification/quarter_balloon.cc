// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/verification/quarter_balloon.h"
#include "geometry/pebs_mesh.h"
#include <algorithm>
#include <catch2/catch.hpp>

namespace ballonet::tests
{

namespace
{

/// Nodes of the face of a cell on the side 2 d (+ 1) in lexicographic order.
std::vector<std::uint32_t> face_nodes_of(const solver::Mesh &mesh, std::uint32_t cell, std::uint32_t face)
{
  const int strides[3] = {1, 3, 9};
  std::vector<std::uint32_t> nodes;
  for (int a = 0; a < 27; ++a)
    if (a / strides[face / 2] % 3 == (face % 2 ? 2 : 0))
      nodes.push_back(mesh.cells[cell][a]);
  return nodes;
}

} // namespace

QuarterBalloon::QuarterBalloon()
{
  geometry::MeshSizes sizes;
  sizes.balloon_per_pitch = 2, sizes.balloon_around = 16;
  const auto built = geometry::build_mesh(geometry::BalloonAlone{}, sizes);
  REQUIRE(std::holds_alternative<geometry::PebsMesh>(built));
  const auto &half = std::get<geometry::PebsMesh>(built).mesh;
  std::vector<std::uint32_t> cell_of(half.cells.size(), UINT32_MAX), node_of(half.nodes.size(), UINT32_MAX);
  mesh.bodies = {"balloon"};
  for (std::size_t c = 0; c < half.cells.size(); ++c) {
    if (half.nodes[half.cells[c][13]][0] < 0)
      continue;
    cell_of[c] = mesh.cells.size();
    auto &cell = mesh.cells.emplace_back(half.cells[c]);
    mesh.cell_body.push_back(0);
    for (auto &node : cell) {
      REQUIRE(half.nodes[node][0] > -1e-9); // the plane x = 0 runs between cells
      if (node_of[node] == UINT32_MAX) {
        node_of[node] = mesh.nodes.size();
        mesh.nodes.push_back(half.nodes[node]);
      }
      node = node_of[node];
    }
  }
  for (const auto &surface : half.surfaces)
    if (surface.name == "balloon_inner" || surface.name == "balloon_base") {
      auto &copy = mesh.surfaces.emplace_back(solver::Surface{surface.name, {}});
      for (const auto &face : surface.faces)
        if (cell_of[face.cell] != UINT32_MAX)
          copy.faces.push_back({cell_of[face.cell], face.local});
    }
  add_plane("x0", 0);
  add_plane("y0", 1);
}

void QuarterBalloon::add_plane(const std::string &name, int direction)
{
  auto &surface = mesh.surfaces.emplace_back(solver::Surface{name, {}});
  for (std::uint32_t c = 0; c < mesh.cells.size(); ++c)
    for (std::uint32_t f = 0; f < 6; ++f) {
      const auto nodes = face_nodes_of(mesh, c, f);
      if (std::all_of(nodes.begin(), nodes.end(),
                      [&](std::uint32_t n) { return std::abs(mesh.nodes[n][direction]) < 1e-9; }))
        surface.faces.push_back({c, f});
    }
}

} // namespace ballonet::tests
