// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/mesh_io.h"
#include "mesh_study.h"
#include "studies/history_table.h"
#include <catch2/catch.hpp>

using namespace ballonet;
using ballonet::tests::Folder;

namespace
{

/// The bar with its clamped end as the set "clamp" and the corners of its free end as the set "corners".
void write_bar_with_sets(const std::filesystem::path &file)
{
  tests::write_bar(file, 4);
  auto mesh = std::get<geometry::Mesh>(geometry::read_msh(file));
  mesh.node_sets = {{"clamp", {}}, {"corners", {}}};
  for (std::uint32_t n = 0; n < mesh.nodes.size(); ++n) {
    const auto &x = mesh.nodes[n];
    if (x[0] == 0)
      mesh.node_sets[0].nodes.push_back(n);
    if (x[0] == 4 && x[1] != 0.5 && x[2] != 0.5)
      mesh.node_sets[1].nodes.push_back(n);
  }
  REQUIRE(mesh.node_sets[1].nodes.size() == 4);
  REQUIRE_FALSE(geometry::write_msh(mesh, file));
}

std::string replaced(std::string text, const std::string &from, const std::string &to)
{
  for (std::size_t at; (at = text.find(from)) != std::string::npos;)
    text.replace(at, from.size(), to);
  return text;
}

/// The bar's study with sets of nodes in place of its surfaces.
std::string study_with_sets()
{
  std::string text = replaced(tests::bar_study, R"(surface = "x0")", R"(nodes = "clamp")");
  text = replaced(text, R"(traction = ["10 kPa", "0 kPa", "0 kPa"])", R"(force = ["0.01 N", "0 N", "0 N"])");
  return replaced(text, R"(surface = "x1")", R"(nodes = "corners")");
}

tests::StudyRun run_of(const Folder &folder, const std::string &study)
{
  write_bar_with_sets(folder.path / "bar.msh");
  return {folder, study};
}

} // namespace

TEST_CASE("supports, loads and responses on physical curves and points of a mesh file")
{
  const Folder folder("node_sets");
  auto run = run_of(folder, study_with_sets());
  REQUIRE(run() == 0);
  const auto journal = run.journal();
  CHECK(journal.at(0).at("responses").at("pull").get<double>() == Approx(-0.01).epsilon(1e-6));
  CHECK(journal.at(0).at("responses").at("end").get<double>() > 4.01);
}

TEST_CASE("a place that does not exist, or carries what it cannot, is wrong input that says what is allowed")
{
  const Folder folder("wrong_node_sets");
  const std::string good = study_with_sets();
  const auto [from, to, message] =
      GENERATE(std::tuple{R"(nodes = "clamp")", R"(nodes = "clmp")", "a physical curve or point of the mesh"},
               std::tuple{R"(nodes = "clamp")", "nodes = \"clamp\"\nsurface = \"x0\"", "either surface or nodes"},
               std::tuple{R"(force = ["0.01 N", "0 N", "0 N"])", R"(pressure = "1 kPa")", "force, or a surface"});
  auto run = run_of(folder, replaced(replaced(good, from, "@@"), "@@", to));
  CHECK(run() == 2);
  INFO(run.text);
  CHECK(run.text.find(message) != std::string::npos);
}
