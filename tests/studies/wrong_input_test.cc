// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_study.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>

namespace
{

using ballonet::tests::Folder;
using ballonet::tests::Outcome;
using ballonet::tests::run_program;

struct WrongStudy {
  const char *name;
  std::string text;
  std::vector<const char *> parts; // of the message
};

const std::vector<WrongStudy> wrong_studies = {
    {"unknown key",
     "[actuator.balloon]\ndiamter = \"7 mm\"\n",
     {"study.toml:2:", "actuator.balloon.diamter", "diameter"}},
    {"missing unit", "[actuator.balloon]\ndiameter = 7.2\n", {"study.toml:2:", "7.2", "the unit is missing", "mm"}},
    {"wrong unit",
     "[actuator.balloon]\ndiameter = \"7.2 kPa\"\n",
     {"study.toml:2:", "\"kPa\" measures something else"}},
    {"negative size", "[actuator.balloon]\ndiameter = \"-7.2 mm\"\n", {"study.toml:2:", "0.1 mm to 1000 mm"}},
    {"NaN", "[contact]\nfriction = nan\n", {"study.toml:2:", "contact.friction: given nan", "0 to 10"}},
    {"overlapping ribs",
     "[actuator.ribs]\ncount = 3\nwidth = \"2 mm\"\nposition = [\"20 mm\", \"21 mm\", \"96 mm\"]\n",
     {"study.toml:3:", "actuator.ribs.width", "actuator.ribs.position", "rib 2"}},
    {"missing file",
     "[actuator]\nkind = \"mesh\"\nfile = \"nowhere.msh\"\n",
     {"study.toml:3:", "actuator.file", "nowhere.msh", "does not exist"}},
    {"release without mass",
     "[path]\ncontrol = \"release\"\ninertia = false\n",
     {"study.toml:3:", "path.inertia", "release"}},
    {"unknown integrator",
     "[path]\nintegrator = \"newmark\"\n",
     {"study.toml:2:", "path.integrator", "newmark", "generalised_alpha"}},
    {"unknown algorithm",
     "[[variable]]\nkey = \"contact.friction\"\nmin = 0.1\nmax = 0.2\n[method]\nkind = \"optimize\"\n"
     "algorithm = \"LN_COBYLLA\"\n[objective]\nresponse = \"window_angle_deg\"\n",
     {"study.toml:7:", "method.algorithm", "LN_COBYLLA", "LN_COBYLA"}},
    {"empty file", "\n\n", {"study.toml: ", "an empty file"}},
    {"binary file",
     std::string("\x7f"
                 "ELF\0\0\x01\x02",
                 8),
     {"study.toml: ", "binary data"}},
    {"not UTF-8", "[study]\nname = \"\xff\xfe\"\n", {"study.toml:2:", "not TOML"}},
    {"broken TOML", "[study\nname = 3\n", {"study.toml:1:", "not TOML"}},
    {"string file", "[study]\nname = 3\n", {"study.toml:2:", "a text in quotes"}},
};

} // namespace

TEST_CASE("a wrong study ends with exit code 2, one clear message and no results directory")
{
  const Folder folder("wrong_input");
  for (const WrongStudy &wrong : wrong_studies)
    for (const std::string command : {"check", "run", "mesh"}) {
      CAPTURE(wrong.name, command);
      std::vector<std::string> arguments = {command, folder.write("study.toml", wrong.text)};
      if (command != "check")
        arguments.insert(arguments.end(), {"-o", (folder.path / "results").string()});
      const Outcome outcome = run_program(arguments);
      CAPTURE(outcome.err);
      CHECK(outcome.code == 2);
      CHECK(std::count(outcome.err.begin(), outcome.err.end(), '\n') == 1);
      CHECK(outcome.out.empty());
      for (const char *part : wrong.parts)
        CHECK_THAT(outcome.err, Catch::Contains(part));
      CHECK_FALSE(std::filesystem::exists(folder.path / "results"));
    }
}

TEST_CASE("a missing study and a folder as study are wrong input")
{
  const Folder folder("wrong_input");
  REQUIRE(run_program({"check", (folder.path / "nothing.toml").string()}).code == 2);
  REQUIRE_THAT(run_program({"check", folder.path.string()}).err, Catch::Contains("a folder"));
}

TEST_CASE("mistakes on the command line are wrong input")
{
  const Folder folder("wrong_input");
  const std::string study = folder.write("study.toml", "[actuator]\n");
  REQUIRE(run_program({}).code == 2);
  REQUIRE(run_program({"fly"}).code == 2);
  REQUIRE(run_program({"run"}).code == 2);
  REQUIRE(run_program({"check", study, "--set", "nothing"}).code == 2);
  REQUIRE(run_program({"check", study, "--what"}).code == 2);
  REQUIRE(run_program({"describe", "actuator.baloon"}).code == 2);
}

TEST_CASE("a correct study, --set, describe, --help and --version end with 0")
{
  const Folder folder("wrong_input");
  const std::string study = folder.write("study.toml", "[actuator]\n");
  REQUIRE(run_program({"check", study}).code == 0);
  REQUIRE(run_program({"check", study, "--set", "actuator.balloon.diameter=7 mm", "--set", "study.name=x"}).code == 0);
  REQUIRE_THAT(run_program({"check", study, "--set", "actuator.balloon.diameter=7 kPa"}).err,
               Catch::Contains("--set actuator.balloon.diameter=7 kPa"));
  REQUIRE_THAT(run_program({"describe", "contact.friction"}).out, Catch::Contains("Coulomb"));
  REQUIRE_THAT(run_program({"describe"}).out, Catch::Contains("actuator.balloon.diameter"));
  REQUIRE_THAT(run_program({"--version"}).out, Catch::Contains("ballonet "));
  REQUIRE(run_program({"--version"}).code == 0);
  REQUIRE_THAT(run_program({"run", "--help"}).out, Catch::Contains("--dry-run"));
  REQUIRE(run_program({"run", "--help"}).code == 0);
}
