// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/round_mesh.h"
#include "tests/support/box_mesh.h"
#include <algorithm>
#include <cmath>
#include <map>

namespace ballonet::tests
{

namespace
{

/// Gives the surface its name, or removes it when the name is empty.
void name_surfaces(solver::Mesh &mesh, const std::array<std::string, 6> &names)
{
  for (std::size_t i = 0; i < names.size(); ++i)
    mesh.surfaces[i].name = names[i];
  std::erase_if(mesh.surfaces, [](const auto &surface) { return surface.name.empty(); });
}

/// The part of the sphere nearest to axis `k`, on a cube's face with equal angles.
solver::Mesh sphere_block(int k, double inner, double outer, int through, int around)
{
  auto mesh = box_mesh(around, around, through, [&](Point3 p) {
    const double s = std::tan(M_PI / 4 * p[0]), t = std::tan(M_PI / 4 * p[1]);
    const double r = (inner + (outer - inner) * p[2]) / std::sqrt(1 + s * s + t * t);
    Point3 x;
    x[k] = r, x[(k + 1) % 3] = r * s, x[(k + 2) % 3] = r * t;
    return x;
  });
  const std::string planes[3] = {"x0", "y0", "z0"};
  name_surfaces(mesh, {planes[(k + 1) % 3], "", planes[(k + 2) % 3], "", "inner", "outer"});
  return mesh;
}

} // namespace

solver::Mesh quarter_tube(double inner, double outer, double length, int through, int around, int along,
                          const std::string &body, const std::string &prefix)
{
  const auto map = [&](Point3 p) {
    const double r = inner + (outer - inner) * p[0], angle = M_PI / 2 * p[1];
    return Point3{r * std::cos(angle), r * std::sin(angle), length * p[2]};
  };
  auto mesh = box_mesh(through, around, along, map, body);
  name_surfaces(mesh, {prefix + "inner", prefix + "outer", prefix + "y0", prefix + "x0", prefix + "z0", prefix + "z1"});
  return mesh;
}

solver::Mesh whole_tube(double inner, double outer, double length, int through, int around, int along, double pitch)
{
  const auto map = [&](Point3 p) {
    const double r = inner + (outer - inner) * p[0], z = length * p[2], angle = 2 * M_PI * p[1] + pitch * z;
    return Point3{r * std::cos(angle), r * std::sin(angle), z};
  };
  auto mesh = box_mesh(through, around, along, map);
  name_surfaces(mesh, {"inner", "outer", "", "", "z0", "z1"});
  return merged(mesh);
}

solver::Mesh eighth_sphere(double inner, double outer, int through, int around)
{
  auto mesh = sphere_block(0, inner, outer, through, around);
  for (int k = 1; k < 3; ++k)
    mesh = beside(std::move(mesh), sphere_block(k, inner, outer, through, around));
  return merged(mesh);
}

solver::Mesh merged(const solver::Mesh &mesh)
{
  solver::Mesh result;
  std::map<std::array<long, 3>, std::uint32_t> known;
  std::vector<std::uint32_t> number;
  for (const auto &x : mesh.nodes) {
    const std::array<long, 3> key = {std::lround(1e7 * x[0]), std::lround(1e7 * x[1]), std::lround(1e7 * x[2])};
    const auto [at, is_new] = known.try_emplace(key, static_cast<std::uint32_t>(result.nodes.size()));
    if (is_new)
      result.nodes.push_back(x);
    number.push_back(at->second);
  }
  for (auto cell : mesh.cells) {
    for (auto &node : cell)
      node = number[node];
    result.cells.push_back(cell);
  }
  for (const auto body : mesh.cell_body) {
    const auto &name = mesh.bodies[body];
    auto at = std::find(result.bodies.begin(), result.bodies.end(), name);
    result.cell_body.push_back(at - result.bodies.begin());
    if (at == result.bodies.end())
      result.bodies.push_back(name);
  }
  for (const auto &surface : mesh.surfaces) {
    auto at = std::find_if(result.surfaces.begin(), result.surfaces.end(),
                           [&](const auto &other) { return other.name == surface.name; });
    if (at == result.surfaces.end())
      at = result.surfaces.insert(at, {surface.name, {}});
    at->faces.insert(at->faces.end(), surface.faces.begin(), surface.faces.end());
  }
  return result;
}

} // namespace ballonet::tests
