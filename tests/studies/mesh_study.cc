// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_study.h"
#include "geometry/mesh_io.h"
#include "studies/command_line.h"
#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

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

Outcome run_program(const std::vector<std::string> &arguments)
{
  std::ostringstream out, err;
  const int code = studies::run_command_line(arguments, MPI_COMM_WORLD, out, err);
  return {code, out.str(), err.str()};
}

StudyRun::StudyRun(const Folder &folder, const std::string &text)
    : results(folder.path / "results"), study(folder.write("study.toml", text))
{
}

int StudyRun::operator()(const std::vector<std::string> &more)
{
  std::vector<std::string> arguments = {"run", study, "-o", results.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = run_program(arguments);
  text = outcome.text();
  return outcome.code;
}

std::vector<nlohmann::json> StudyRun::journal() const
{
  std::ifstream stream(results / "journal.jsonl");
  std::vector<nlohmann::json> lines;
  for (std::string line; std::getline(stream, line);)
    lines.push_back(nlohmann::json::parse(line));
  return lines;
}

nlohmann::json StudyRun::summary() const { return nlohmann::json::parse(std::ifstream(results / "summary.json")); }

StudyRun bar_run(const Folder &folder, const std::string &more)
{
  write_bar(folder.path / "bar.msh", 4);
  return {folder, bar_study + more};
}

} // namespace ballonet::tests
