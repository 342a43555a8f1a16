// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_study.h"
#include "geometry/mesh_io.h"
#include <catch2/catch.hpp>
#include <fstream>

namespace ballonet::tests
{

Folder::Folder(const std::string &name) : path(std::filesystem::temp_directory_path() / ("ballonet_" + name))
{
  std::filesystem::remove_all(path);
  std::filesystem::create_directories(path);
}

Folder::~Folder() { std::filesystem::remove_all(path); }

std::string Folder::write(const std::string &name, const std::string &text) const
{
  std::ofstream(path / name, std::ios::binary) << text;
  return (path / name).string();
}

void write_bar(const std::filesystem::path &file, double length)
{
  geometry::Mesh mesh;
  for (int k = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 5; ++i)
        mesh.nodes.push_back({length * i / 4, j / 2., k / 2.});
  for (std::uint32_t cell = 0; cell < 2; ++cell) {
    auto &nodes = mesh.cells.emplace_back();
    for (std::uint32_t n = 0; n < 27; ++n)
      nodes[n] = 2 * cell + n % 3 + 5 * (n / 3 % 3) + 15 * (n / 9);
  }
  mesh.cell_body = {0, 0};
  mesh.bodies = {{"bar"}};
  mesh.surfaces = {{"x0", {{0, 0}}}, {"x1", {{1, 1}}}};
  REQUIRE_FALSE(geometry::write_msh(mesh, file));
}

const char *const bar_study = R"(
[study]
name = "bar"
[actuator]
kind = "mesh"
file = "bar.msh"
[material.rubber]
law = "neo_hookean"
youngs_modulus = "1 MPa"
poisson_ratio = 0.3
[[body]]
name = "bar"
material = "rubber"
[[support]]
surface = "x0"
fix = ["x", "y", "z"]
[[load]]
surface = "x1"
traction = ["10 kPa", "0 kPa", "0 kPa"]
[[response]]
name = "pull"
kind = "reaction"
surface = "x0"
component = "x"
[[response]]
name = "end"
kind = "position"
surface = "x1"
component = "x"
[path]
control = "load"
load_steps = 2
)";

} // namespace ballonet::tests
