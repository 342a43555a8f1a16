// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_study.h"
#include "solver/hdf5_file.h"
#include "studies/evaluation_run.h"
#include "studies/history_table.h"
#include "studies/study_file.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <regex>
#include <set>

using namespace ballonet;
using namespace ballonet::studies;
using ballonet::tests::Folder;

namespace
{

std::string text_of(const std::filesystem::path &file)
{
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// What a fields.pvd lists: file and time.
std::map<std::string, double> collection(const std::filesystem::path &folder)
{
  const std::string text = text_of(folder / "fields.pvd");
  const std::regex entry("<DataSet timestep=\"([^\"]*)\" part=\"0\" file=\"([^\"]*)\"/>");
  std::map<std::string, double> times;
  for (std::sregex_iterator match(text.begin(), text.end(), entry), end; match != end; ++match)
    times[(*match)[2]] = std::stod((*match)[1]);
  return times;
}

std::set<std::string> files_in(const std::filesystem::path &folder)
{
  std::set<std::string> names;
  for (const auto &entry : std::filesystem::directory_iterator(folder))
    names.insert("fields/" + entry.path().filename().string());
  return names;
}

StudyFile bar_in_steps(const Folder &folder, const std::string &shape_every)
{
  tests::write_bar(folder.path / "bar.msh", 4);
  return {folder.path / "study.toml",
          tests::bar_study,
          {{"path.load_steps", "8"}, {"path.checkpoint_every", "2"}, {"output.shape_every", shape_every}}};
}

const char *const search_of_6 = R"(
[[variable]]
key = "material.rubber.youngs_modulus"
min = "0.1 MPa"
max = "2 MPa"
[method]
kind = "optimize"
max_evaluations = 6
[objective]
response = "end"
goal = "maximize"
)";

} // namespace

TEST_CASE("every kept shape has its fields, with displacement and stress on the quadratic cells")
{
  const Folder folder("fields");
  const StudyFile file = bar_in_steps(folder, "3");
  REQUIRE(run_evaluation(file.study(), folder.path, MPI_COMM_WORLD, [] {}).status == optimize::Status::ok);
  const auto times = collection(folder.path);
  const auto rows = read_history(folder.path / "history.csv");
  REQUIRE(rows.size() >= 4);
  const solver::Hdf5File shapes((folder.path / "history.h5").string(), solver::Hdf5File::Mode::read);
  std::set<std::string> expected;
  for (const std::string &step : shapes.names("/states")) {
    const std::string name = "fields/step_" + step + ".vtu";
    expected.insert(name);
    REQUIRE(times.at(name) == Approx(value_of(rows.at(std::stoul(step) - 1), "time_s")));
  }
  REQUIRE(expected.contains("fields/step_000003.vtu"));
  REQUIRE(files_in(folder.path / "fields") == expected);
  REQUIRE(times.size() == expected.size());
  const std::string vtu = text_of(folder.path / *expected.rbegin());
  for (const char *part : {"NumberOfPoints=\"54\"", "NumberOfCells=\"2\"", "Name=\"displacement\"",
                           "Name=\"stress_MPa\"", "Name=\"body\"", "</VTKFile>"})
    REQUIRE_THAT(vtu, Catch::Contains(part));
}

TEST_CASE("the collection of fields survives an interruption and holds nothing that was not reached again")
{
  const Folder folder("fields_resume");
  const StudyFile file = bar_in_steps(folder, "1");
  int steps = 0;
  const auto crash = [&steps] {
    if (++steps == 3) // one step after a checkpoint
      throw std::runtime_error("power failure");
  };
  REQUIRE_THROWS(run_evaluation(file.study(), folder.path, MPI_COMM_WORLD, crash));
  REQUIRE(collection(folder.path).size() == 3);
  folder.write("fields/step_000099.vtu", "of a path that is not gone again");
  REQUIRE(run_evaluation(file.study(), folder.path, MPI_COMM_WORLD, [] {}).status == optimize::Status::ok);
  const auto times = collection(folder.path);
  std::set<std::string> listed;
  for (const auto &[name, time] : times)
    listed.insert(name);
  REQUIRE(listed == files_in(folder.path / "fields"));
  const auto rows = read_history(folder.path / "history.csv");
  REQUIRE(times.size() == rows.size());
  std::size_t i = 0;
  for (const auto &[name, time] : times)
    REQUIRE(time == Approx(value_of(rows.at(i++), "time_s")));
}

TEST_CASE("fields can be left out")
{
  const Folder folder("fields_none");
  Study study = bar_in_steps(folder, "4").study();
  study.output.vtu = false;
  REQUIRE(run_evaluation(study, folder.path, MPI_COMM_WORLD, [] {}).status == optimize::Status::ok);
  REQUIRE(std::filesystem::exists(folder.path / "history.h5"));
  REQUIRE_FALSE(std::filesystem::exists(folder.path / "fields"));
}

TEST_CASE("results.h5 holds the curves of all evaluations and the convergence, also after --resume")
{
  const Folder folder("results_file");
  const auto path = folder.path / "results/results.h5";
  tests::StudyRun run = tests::bar_run(folder, search_of_6);
  REQUIRE(run() == 0);
  for (const bool again : {false, true}) {
    if (again) {
      std::filesystem::remove(path);
      REQUIRE(run({"--resume"}) == 0);
    }
    const solver::Hdf5File file(path.string(), solver::Hdf5File::Mode::read);
    const auto numbers = file.read("/convergence/evaluation"), objective = file.read("/convergence/objective"),
               best = file.read("/convergence/best_so_far");
    REQUIRE(numbers.size() >= 3);
    REQUIRE(file.names("/evaluations").size() == numbers.size());
    for (std::size_t i = 0; i < best.size(); ++i)
      REQUIRE(best[i] == *std::max_element(objective.begin(), objective.begin() + static_cast<std::ptrdiff_t>(i) + 1));
    const auto rows = read_history(folder.path / "results/evaluations/0002/history.csv");
    const auto ends = file.read("/evaluations/0002/end");
    REQUIRE(ends.size() == rows.size());
    REQUIRE(ends.back() == value_of(rows.back(), "end"));
    REQUIRE(objective.at(1) == ends.back());
    const double modulus = file.read_attribute("/evaluations/0002", "material.rubber.youngs_modulus");
    REQUIRE((modulus >= 0.1 && modulus <= 2));
  }
  REQUIRE_FALSE(std::filesystem::exists(path.string() + ".new"));
}

TEST_CASE("a results.h5 that cannot be written is said and loses nothing else")
{
  const Folder folder("results_file_blocked");
  tests::StudyRun run = tests::bar_run(folder, search_of_6);
  REQUIRE(run() == 0);
  std::filesystem::create_directory(folder.path / "results/results.h5.new"); // in the way
  REQUIRE(run({"--resume"}) == 0);
  REQUIRE_THAT(run.text, Catch::Contains("no new results.h5"));
  const solver::Hdf5File old((folder.path / "results/results.h5").string(), solver::Hdf5File::Mode::read);
  REQUIRE(old.has("/evaluations/0001/end"));
  REQUIRE(std::filesystem::exists(folder.path / "results/summary.json"));
}
