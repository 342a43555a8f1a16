// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_study.h"
#include "studies/content_hash.h"
#include "studies/study_file.h"
#include <algorithm>
#include <catch2/catch.hpp>

using namespace ballonet::studies;

namespace
{

const std::string search = R"(
[study]
name = "search"
[actuator]
kind = "pebs"
[actuator.balloon]
diameter = "7.2 mm"
[material.latex]
c10 = "140 kPa"
[[variable]]
key = "actuator.balloon.diameter"
min = "6 mm"
max = "0.8 cm"
[[variable]]
key = "actuator.ribs.count"
min = 18
max = 20
[[variable]]
key = "material.latex.c10"
values = ["120 kPa", "160 kPa"]
[[variable]]
key = "contact.friction"
min = 0.1
max = 0.5
[method]
kind = "optimize"
algorithm = "LN_COBYLA"
[objective]
response = "window_angle_deg"
goal = "maximize"
[[constraint]]
response = "balloon_stress_max_MPa_max"
max = 5.0
)";

/// The bar with more blocks.
class MeshStudy
{
public:
  MeshStudy() { write_mesh(4); }
  StudyFile read(const std::string &more = "") const
  {
    return {(folder_.path / "study.toml").string(), ballonet::tests::bar_study + more};
  }
  void write_mesh(double length) const { ballonet::tests::write_bar(folder_.path / "bar.msh", length); }

private:
  ballonet::tests::Folder folder_{"study_file"};
};

} // namespace

TEST_CASE("an empty block [actuator] is the base design")
{
  const StudyFile file("study.toml", "[actuator]\n");
  REQUIRE(file.study().actuator.kind == ActuatorKind::pebs);
  REQUIRE(file.study().actuator.pebs.ribs.count == 20);
  REQUIRE(file.study().gravity[2] == -9810);
  REQUIRE(file.study().materials.size() == 2);
  REQUIRE(file.space().size() == 0);
}

TEST_CASE("a block of a built-in material changes what it names and keeps the rest")
{
  const Study study = StudyFile("study.toml", search).study();
  REQUIRE(study.materials[0].name == "latex");
  REQUIRE(study.materials[0].c10 == 0.14);
  REQUIRE(study.materials[0].density == 1.08e-9);
}

TEST_CASE("variables have the unit of their key and are set like any key")
{
  const StudyFile file("study.toml", search);
  REQUIRE(file.space().size() == 4);
  REQUIRE(file.space().variable(0).unit == "mm");
  REQUIRE(file.space().variable(0).max == 8);
  REQUIRE(file.space().variable(1).integer);
  REQUIRE(file.space().variable(2).values == std::vector<double>{0.12, 0.16});
  const Study study = file.with({6.5, 19, 0.12, 0.25});
  REQUIRE(study.actuator.pebs.balloon.diameter == 6.5);
  REQUIRE(study.actuator.pebs.ribs.count == 19);
  REQUIRE(study.materials[0].c10 == 0.12);
  REQUIRE(study.contact.friction == 0.25);
  REQUIRE(file.study().actuator.pebs.balloon.diameter == 7.2);
}

TEST_CASE("the resolved study reads back to the identical text")
{
  for (const std::string &text : {search, std::string("[actuator]\nkind = \"balloon\"\n")}) {
    const std::string resolved = resolved_text(StudyFile("study.toml", text).study());
    REQUIRE(resolved_text(StudyFile("other.toml", resolved).study()) == resolved);
    REQUIRE(resolved_text(StudyFile("other.toml", resolved + "[run]\nranks = 4\n").study()) == resolved);
  }
  const MeshStudy mesh;
  const std::string resolved = resolved_text(mesh.read().study());
  REQUIRE(resolved_text(StudyFile("elsewhere/other.toml", resolved).study()) == resolved);
}

TEST_CASE("--set comes after the file, variables come after --set")
{
  const StudyFile file("study.toml", search, {{"actuator.balloon.diameter", "6.1 mm"}, {"contact.friction", "0.4"}});
  REQUIRE(file.study().actuator.pebs.balloon.diameter == 6.1);
  REQUIRE(file.study().contact.friction == 0.4);
  REQUIRE(file.with({6.5, 19, 0.12, 0.25}).actuator.pebs.balloon.diameter == 6.5);
}

TEST_CASE("the content hash sees what changes the result and nothing else")
{
  const auto hash = [](const std::vector<Override> &overrides) {
    return content_hash(StudyFile("study.toml", "[actuator]\n", overrides).study());
  };
  const std::string base = hash({});
  REQUIRE(base.size() == 16);
  REQUIRE(hash({{"actuator.balloon.diameter", "0.72 cm"}}) == base);
  REQUIRE(hash({{"study.name", "other"}}) == base);
  REQUIRE(hash({{"parallel.ranks_per_evaluation", "2"}}) == base);
  REQUIRE(hash({{"actuator.balloon.diameter", "7.3 mm"}}) != base);
  REQUIRE(hash({{"newton.tolerance", "1e-7"}}) != base);
  REQUIRE(text_hash("") == "cbf29ce484222325"); // published FNV-1a test vectors
  REQUIRE(text_hash("a") == "af63dc4c8601ec8c");
  REQUIRE(text_hash("foobar") == "85944171f73967e8");
}

TEST_CASE("the content hash sees the content of a mesh file")
{
  const MeshStudy mesh;
  const std::string first = content_hash(mesh.read().study());
  mesh.write_mesh(5);
  REQUIRE(content_hash(mesh.read().study()) != first);
}

TEST_CASE("contradictions between blocks are refused at their key")
{
  struct Row {
    const char *more, *part;
  };
  const MeshStudy mesh;
  const Row rows[] = {
      {"[[body]]\nname = \"b\"\nmaterial = \"ruber\"", "body[1].material: given \"ruber\""},
      {"[[body]]\nname = \"bar\"\nmaterial = \"rubber\"\n", "a name used before"},
      {"[[body]]\nname = \"b\"\nmaterial = \"rubber\"\n", "a physical volume of the mesh"},
      {"[[cavity]]\nsurface = \"x0\"\n[[cavity]]\nsurface = \"x1\"", "one cavity"},
      {"[[cavity]]\nsurface = \"x2\"", "cavity[0].surface: given \"x2\"; allowed: a physical surface"},
      {"[[response]]\nname = \"r\"", "either surface, nodes or point"},
      {"[[response]]\nname = \"end\"\nsurface = \"x0\"", "a name of its own"},
      {"[[response]]\nname = \"r\"\nkind = \"max_stress\"\nbody = \"x\"", "[[body]]"},
      {"[[response]]\nname = \"r\"\nkind = \"contact_force\"\npair = \"x\"", "[[contact_pair]]"},
      {"[[response]]\nname = \"r\"\nkind = \"volume\"", "[[cavity]]"},
      {"[material.m]\nlaw = \"saint_venant\"\nyoungs_modulus = \"1 MPa\"", "poisson_ratio"},
      {"[judge]\nrib_opening = 0.1", "unknown key"},
      {"[objective]\nresponse = \"q\"", "a response of this study"},
      {"[[constraint]]\nresponse = \"q\"\nmin = 1.0", "a response of this study"},
  };
  for (const Row &row : rows) {
    CAPTURE(row.more);
    REQUIRE_THROWS_WITH(mesh.read(row.more), Catch::Contains(row.part));
    REQUIRE_THROWS_AS(mesh.read(row.more), InputError);
  }
}

TEST_CASE("a problem without cavity needs load control, a file has to be a mesh")
{
  const ballonet::tests::Folder folder("wrong_mesh");
  folder.write("bar.msh", "no mesh");
  REQUIRE_THROWS_WITH(StudyFile((folder.path / "study.toml").string(), ballonet::tests::bar_study),
                      Catch::Contains("actuator.file") && Catch::Contains("a gmsh file of hexahedra"));
  ballonet::tests::write_bar(folder.path / "bar.msh", 4);
  REQUIRE_THROWS_WITH(
      StudyFile((folder.path / "study.toml").string(), ballonet::tests::bar_study, {{"path.control", "volume"}}),
      Catch::Contains("[[cavity]]"));
}

TEST_CASE("a problem that is let go needs no cavity, and its supports rest")
{
  const ballonet::tests::Folder folder("released");
  ballonet::tests::write_bar(folder.path / "bar.msh", 4);
  const std::string file = (folder.path / "study.toml").string(), text = ballonet::tests::bar_study;
  REQUIRE_NOTHROW(StudyFile(file, text, {{"path.control", "release"}}));
  const auto support = text.find("fix = ");
  const std::string moved = text.substr(0, support) + "move = {x = \"1 mm\"}\n" + text.substr(support);
  REQUIRE_NOTHROW(StudyFile(file, moved));
  REQUIRE_THROWS_WITH(StudyFile(file, moved, {{"path.control", "release"}}),
                      Catch::Contains("support[0].move") && Catch::Contains("release"));
}

TEST_CASE("contradictions of a search are refused at their key")
{
  struct Row {
    std::vector<Override> overrides;
    const char *part;
  };
  const Row rows[] = {
      {{{"variable[0].key", "actuator.balloon.diamter"}}, "nearest known: actuator.balloon.diameter"},
      {{{"variable[0].key", "study.name"}}, "one number"},
      {{{"variable[0].min", "9 mm"}}, "less than max"},
      {{{"variable[0].min", "6 kPa"}}, "measures something else"},
      {{{"variable[0].min", "0 mm"}}, "actuator.balloon.diameter"},
      {{{"variable[0].max", "inf"}}, "a number with a unit"},
      {{{"variable[2].min", "100 kPa"}}, "either both min and max, or a list of values"},
      {{{"variable[1].key", "actuator.balloon.diameter"}, {"variable[1].min", "1 mm"}, {"variable[1].max", "2 mm"}},
       "different keys"},
      {{{"method.algorithm", "LN_COBYLLA"}}, "LN_COBYLA"},
      {{{"method.kind", "map"}}, "not available in this version"},
      {{{"method.kind", "solve"}}, "variables in a study that only solves"},
      {{{"objective.response", "window_angle"}}, "nearest known: window_angle_deg"},
      {{{"constraint[0].min", "9.0"}}, "min at most max"},
      {{{"actuator.kind", "pba"}}, "balloon"},
      {{{"actuator.balloon_material", "latx"}}, "nearest known: latex"},
      {{{"material.latex.youngs_modulus", "1 MPa"}}, "c10 together with youngs_modulus"},
  };
  for (const Row &row : rows) {
    CAPTURE(row.overrides[0].key, row.overrides[0].value);
    REQUIRE_THROWS_WITH(StudyFile("study.toml", search, row.overrides), Catch::Contains(row.part));
    REQUIRE_THROWS_AS(StudyFile("study.toml", search, row.overrides), InputError);
  }
}

TEST_CASE("describe knows every key with unit and help")
{
  const auto rows = describe_all_keys();
  for (const KeyDescription &row : rows) {
    CAPTURE(row.key);
    REQUIRE(row.help.size() > 5);
    REQUIRE_FALSE(row.type.empty());
    const bool dimensional = row.type == "quantity" || row.type == "list of quantities";
    REQUIRE((!dimensional || !row.unit.empty()));
  }
  const auto has = [&](const std::string &key) {
    return std::any_of(rows.begin(), rows.end(), [&](const auto &row) { return row.key == key; });
  };
  for (const char *key : {"study.name",
                          "actuator.kind",
                          "actuator.balloon.diameter",
                          "actuator.ribs.gap",
                          "actuator.file",
                          "material.X.c10",
                          "mesh.symmetry",
                          "path.control",
                          "newton.tolerance",
                          "contact.friction",
                          "judge.window_max",
                          "variable[].key",
                          "method.algorithm",
                          "objective.response",
                          "constraint[].max",
                          "parallel.ranks_per_evaluation",
                          "body[].material",
                          "support[].move.x",
                          "cavity[].surface",
                          "load[].traction",
                          "contact_pair[].secondary",
                          "response[].kind",
                          "gravity"}) {
    CAPTURE(key);
    REQUIRE(has(key));
  }
}
