// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/box_mesh.h"
#include <cmath>

namespace ballonet::tests
{

solver::Mesh box_mesh(int nx, int ny, int nz, const std::function<Point3(Point3)> &map, const std::string &body,
                      const std::string &prefix)
{
  solver::Mesh mesh;
  const int n[3] = {nx, ny, nz}, stride[3] = {1, 2 * nx + 1, (2 * nx + 1) * (2 * ny + 1)};
  for (int k = 0; k <= 2 * nz; ++k)
    for (int j = 0; j <= 2 * ny; ++j)
      for (int i = 0; i <= 2 * nx; ++i) {
        const Point3 x = {i / (2. * nx), j / (2. * ny), k / (2. * nz)};
        mesh.nodes.push_back(map ? map(x) : x);
      }
  mesh.bodies = {body};
  const char *names[] = {"x0", "x1", "y0", "y1", "z0", "z1"};
  for (const auto *name : names)
    mesh.surfaces.push_back({prefix + name, {}});
  for (int k = 0; k < nz; ++k)
    for (int j = 0; j < ny; ++j)
      for (int i = 0; i < nx; ++i) {
        auto &cell = mesh.cells.emplace_back();
        for (int a = 0; a < 27; ++a)
          cell[a] = (2 * i + a % 3) * stride[0] + (2 * j + a / 3 % 3) * stride[1] + (2 * k + a / 9) * stride[2];
        const int at[3] = {i, j, k};
        for (std::uint32_t f = 0; f < 6; ++f)
          if (at[f / 2] == (f % 2 ? n[f / 2] - 1 : 0))
            mesh.surfaces[f].faces.push_back({static_cast<std::uint32_t>(mesh.cells.size() - 1), f});
      }
  mesh.cell_body.assign(mesh.cells.size(), 0);
  return mesh;
}

solver::Mesh beside(solver::Mesh a, const solver::Mesh &b)
{
  const std::uint32_t nodes = a.nodes.size(), cells = a.cells.size(), bodies = a.bodies.size();
  a.nodes.insert(a.nodes.end(), b.nodes.begin(), b.nodes.end());
  for (auto cell : b.cells) {
    for (auto &node : cell)
      node += nodes;
    a.cells.push_back(cell);
  }
  for (const auto body : b.cell_body)
    a.cell_body.push_back(body + bodies);
  a.bodies.insert(a.bodies.end(), b.bodies.begin(), b.bodies.end());
  for (auto surface : b.surfaces) {
    for (auto &face : surface.faces)
      face.cell += cells;
    a.surfaces.push_back(surface);
  }
  for (auto set : b.node_sets) {
    for (auto &node : set.nodes)
      node += nodes;
    a.node_sets.push_back(set);
  }
  return a;
}

Point3 distorted(Point3 x, double size)
{
  const double bump = size * std::sin(M_PI * x[0]) * std::sin(M_PI * x[1]) * std::sin(M_PI * x[2]);
  return {x[0] + bump, x[1] - 0.7 * bump, x[2] + 0.5 * bump};
}

} // namespace ballonet::tests
