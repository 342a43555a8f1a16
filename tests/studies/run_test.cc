// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_study.h"
#include "studies/evaluation_run.h"
#include "studies/history_table.h"
#include "studies/journal_format.h"
#include "studies/path_responses.h"
#include "studies/response_names.h"
#include "studies/study_file.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

using namespace ballonet;
using namespace ballonet::studies;
using ballonet::tests::Folder;

namespace
{

const std::string sample_of_4 = R"(
[[variable]]
key = "material.rubber.youngs_modulus"
min = "0.5 MPa"
max = "2 MPa"
[method]
kind = "sample"
max_evaluations = 4
)";

const std::string stretch_to_4_2 = R"(
[[variable]]
key = "material.rubber.youngs_modulus"
min = "0.1 MPa"
max = "2 MPa"
[method]
kind = "optimize"
max_evaluations = 12
[objective]
response = "end"
goal = "maximize"
[[constraint]]
response = "end"
max = 4.1
)";

} // namespace

TEST_CASE("a study without a method is one simulation with all its files")
{
  const Folder folder("run_solve");
  tests::StudyRun run = tests::bar_run(folder);
  REQUIRE(run() == 0);
  for (const char *file :
       {"resolved.toml", "journal.jsonl", "summary.json", "evaluations/0001/mesh.msh", "evaluations/0001/history.csv",
        "evaluations/0001/log.txt", "evaluations/0001/history.h5", "evaluations/0001/study.toml"}) {
    CAPTURE(file);
    REQUIRE(std::filesystem::exists(folder.path / "results" / file));
  }
  REQUIRE(run.summary().at("status") == "done");
  REQUIRE(run.summary().at("counts").at("ok") == 1);
  const auto line = run.journal().at(0);
  REQUIRE(line.at("id") == 1);
  REQUIRE(line.at("status") == "ok");
  REQUIRE(std::abs(line.at("responses").at("pull").get<double>()) == Approx(0.01).epsilon(1e-4)); // 10 kPa on 1 mm^2
  REQUIRE(line.at("responses").at("end").get<double>() > 4);
  const auto rows = read_history(folder.path / "results/evaluations/0001/history.csv");
  REQUIRE(value_of(rows.back(), "load_factor") == 1);
  const std::string resolved = (folder.path / "results/resolved.toml").string();
  REQUIRE(resolved_text(StudyFile::open(resolved).study()) ==
          resolved_text(StudyFile::open((folder.path / "study.toml").string()).study()));
}

TEST_CASE("an occupied directory is refused, --resume computes nothing twice")
{
  const Folder folder("run_resume");
  tests::StudyRun run = tests::bar_run(folder, sample_of_4);
  REQUIRE(run() == 0);
  REQUIRE(run.journal().size() == 4);
  REQUIRE(run() == 2);
  REQUIRE_THAT(run.text, Catch::Contains("--resume"));
  const auto before = run.journal();
  REQUIRE(run({"--resume"}) == 0);
  REQUIRE(run.journal() == before);
  REQUIRE(run.summary().at("replayed") == 4);
  REQUIRE(run({"--resume", "--set", "method.max_evaluations=4", "--set", "variable[0].key=path.step_max", "--set",
               "variable[0].min=1 s", "--set", "variable[0].max=2 s"}) == 2);
  REQUIRE_THAT(run.text, Catch::Contains("other variables"));
}

TEST_CASE("an evaluation lost from the journal goes on in its old folder")
{
  const Folder folder("run_lost");
  tests::StudyRun run = tests::bar_run(folder, sample_of_4);
  REQUIRE(run() == 0);
  const auto before = run.journal();
  std::ofstream(folder.path / "results/journal.jsonl") << before[0].dump() << "\n" << before[1].dump().substr(0, 40);
  REQUIRE(run({"--resume"}) == 0);
  const auto after = run.journal();
  REQUIRE(after.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    REQUIRE(after[i].at("id") == before[i].at("id"));
    REQUIRE(after[i].at("responses").at("end").get<double>() ==
            Approx(before[i].at("responses").at("end").get<double>()).epsilon(1e-10));
  }
  REQUIRE_FALSE(std::filesystem::exists(folder.path / "results/evaluations/0005"));
}

TEST_CASE("a path that ends without its result is told by exit code, journal and summary")
{
  const Folder folder("run_no_result");
  tests::StudyRun run = tests::bar_run(folder);
  REQUIRE(run({"--set", "path.load_steps=8", "--set", "path.max_steps=3"}) == 1);
  REQUIRE(run.summary().at("status") == "no_result");
  REQUIRE_THAT(run.summary().at("reason").get<std::string>(), Catch::Contains("max_steps"));
  REQUIRE(run.journal().at(0).at("status") == "step_limit");
  REQUIRE(read_history(folder.path / "results/evaluations/0001/history.csv").size() == 3);
}

TEST_CASE("an interrupted path goes on from its checkpoint to the same end")
{
  const Folder folder("run_checkpoint");
  tests::write_bar(folder.path / "bar.msh", 4);
  const StudyFile file(folder.path / "study.toml", tests::bar_study,
                       {{"path.load_steps", "8"}, {"path.checkpoint_every", "2"}});
  const auto whole = folder.path / "whole", broken = folder.path / "broken";
  std::filesystem::create_directory(whole);
  std::filesystem::create_directory(broken);
  const auto expected = run_evaluation(file.study(), whole, MPI_COMM_WORLD, [] {});
  REQUIRE(expected.status == optimize::Status::ok);

  int steps = 0;
  const auto crash = [&steps] {
    if (++steps == 3) // one step after a checkpoint
      throw std::runtime_error("power failure");
  };
  REQUIRE_THROWS(run_evaluation(file.study(), broken, MPI_COMM_WORLD, crash));
  REQUIRE(read_history(broken / "history.csv").size() == 3);
  const auto outcome = run_evaluation(file.study(), broken, MPI_COMM_WORLD, [] {});
  REQUIRE(outcome.status == optimize::Status::ok);
  REQUIRE(outcome.responses.at("end") == Approx(expected.responses.at("end")).epsilon(1e-12));
  const auto rows = read_history(broken / "history.csv"), all = read_history(whole / "history.csv");
  REQUIRE(rows.size() == all.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
    REQUIRE(value_of(rows[i], "step") == static_cast<double>(i + 1));
}

TEST_CASE("a search finds the softest bar that keeps its constraint")
{
  const Folder folder("run_search");
  tests::StudyRun run = tests::bar_run(folder, stretch_to_4_2);
  REQUIRE(run() == 0);
  const auto best = run.summary().at("best");
  REQUIRE(best.at("feasible") == true);
  REQUIRE(best.at("responses").at("end").get<double>() <= 4.1 + 1e-3);
  REQUIRE(best.at("responses").at("end").get<double>() > 4.05);
}

TEST_CASE("a dry run says what would be done and writes nothing")
{
  const Folder folder("run_dry");
  tests::StudyRun run = tests::bar_run(folder, sample_of_4);
  REQUIRE(run({"--dry-run"}) == 0);
  REQUIRE_THAT(run.text, Catch::Contains("2 cells, 45 nodes") && Catch::Contains("at most 4"));
  REQUIRE_FALSE(std::filesystem::exists(folder.path / "results"));
}

TEST_CASE("more ranks per evaluation than there are is wrong input")
{
  const Folder folder("run_ranks");
  tests::StudyRun run = tests::bar_run(folder);
  REQUIRE(run({"--set", "parallel.ranks_per_evaluation=64"}) == 2);
  REQUIRE_THAT(run.text, Catch::Contains("parallel.ranks_per_evaluation"));
}

TEST_CASE("mesh and export write their files")
{
  const Folder folder("run_mesh");
  const std::string study =
      folder.write("study.toml", "[actuator.ribs]\ncount = 3\n[actuator.balloon]\nlength = \"9 mm\"\n");
  const auto meshed = tests::run_program({"mesh", study, "-o", folder.path.string()});
  REQUIRE(meshed.code == 0);
  REQUIRE(std::filesystem::file_size(folder.path / "mesh.msh") > 1000);
  REQUIRE_THAT(meshed.text(), Catch::Contains("smallest scaled Jacobian"));
  REQUIRE(tests::run_program({"export", study, "--stl", (folder.path / "part.stl").string()}).code == 0);
  REQUIRE(std::filesystem::file_size(folder.path / "part.stl") > 1000);
  REQUIRE(tests::run_program({"export", study, "--step", (folder.path / "part.step").string()}).code == 2);
  REQUIRE(tests::run_program({"export", study}).code == 2);
}

TEST_CASE("evaluations survive the journal bit by bit")
{
  optimize::Variable variable;
  variable.key = "a.b";
  variable.unit = "mm";
  JournalFormat format(optimize::DesignSpace({variable}));
  optimize::Evaluation e;
  e.hash = "0123456789abcdef";
  e.design = {1. / 3};
  e.status = optimize::Status::diverged;
  e.reason = "a \"reason\"\nof two lines";
  e.responses = {{"x", 0.1 + 0.2}, {"nothing", std::nan("")}};
  e.seconds = 1e-3 / 7;
  format.set_origin(e.hash, {12, "mesh"});
  const std::string line = format.write(e);
  REQUIRE(line.find('\n') == std::string::npos);
  JournalFormat other(optimize::DesignSpace({variable}));
  const auto read = other.read(line);
  REQUIRE(read.design == e.design);
  REQUIRE(read.status == e.status);
  REQUIRE(read.reason == e.reason);
  REQUIRE(read.responses.at("x") == e.responses.at("x"));
  REQUIRE(std::isnan(read.responses.at("nothing")));
  REQUIRE(read.seconds == e.seconds);
  REQUIRE(other.origin(e.hash).number == 12);
  REQUIRE_THROWS_AS(other.read("{}"), std::invalid_argument);
  REQUIRE_THROWS_AS(other.read("no json"), std::invalid_argument);
}

TEST_CASE("a judgement survives the journal, and a journal without one is read")
{
  JournalFormat format{optimize::DesignSpace{}};
  optimize::Evaluation e;
  e.hash = "0123456789abcdef";
  format.set_origin(e.hash, {1, "mesh"});
  REQUIRE(format.judgement(e.hash) == nullptr);
  const std::string old_line = format.write(e);
  REQUIRE(old_line.find("judgement") == std::string::npos);
  JournalFormat old{optimize::DesignSpace{}};
  old.read(old_line);
  REQUIRE(old.judgement(e.hash) == nullptr);

  Judgement judgement;
  judgement.path_class = PathClass::losing_control;
  judgement.reason = "droop 91 deg, at most 90 deg";
  judgement.stage = "sufficient";
  judgement.criteria = {{"droop_angle", PathClass::losing_control, "droop", 91. / 3, 90, "deg", true, -1. / 90},
                        {"gap_ratio", PathClass::losing_control, "gap", std::nan(""), 2.5, "", true, std::nan("")}};
  judgement.snaps = {{{36, 1. / 7, 1000, -1}, {36, 190, 2000, 0.1 + 0.2}, true}};
  format.set_judgement(e.hash, judgement);
  JournalFormat other{optimize::DesignSpace{}};
  other.read(format.write(e));
  const Judgement *read = other.judgement(e.hash);
  REQUIRE(read != nullptr);
  REQUIRE(read->path_class == judgement.path_class);
  REQUIRE(read->reason == judgement.reason);
  REQUIRE(read->stage == judgement.stage);
  REQUIRE(read->snaps == judgement.snaps);
  REQUIRE(read->criteria.size() == 2);
  REQUIRE(read->criteria[0].value == 91. / 3);
  REQUIRE(read->criteria[0].margin == -1. / 90);
  REQUIRE(std::isnan(read->criteria[1].margin));
  REQUIRE(read->margin(PathClass::losing_control) == -1. / 90);
  REQUIRE(other.write(e) == format.write(e));
}

TEST_CASE("a history is read back, without a row that was cut short")
{
  const Folder folder("history");
  const auto file = folder.path / "history.csv";
  {
    HistoryTable table(file, {});
    table.append({{"step", 1}, {"x", 1. / 3}});
    table.append({{"step", 2}, {"x", std::nan("")}});
    REQUIRE_THROWS_AS(table.append({{"step", 3}, {"y", 0}}), std::logic_error);
  }
  std::ofstream(file, std::ios::app) << "3,0.5";
  const auto rows = read_history(file);
  REQUIRE(rows.size() == 2);
  REQUIRE(value_of(rows[0], "x") == 1. / 3);
  REQUIRE(std::isnan(value_of(rows[1], "x")));
  REQUIRE(read_history(folder.path / "nothing.csv").empty());
}

TEST_CASE("the window angle is that of the first state at the pressure")
{
  const StudyFile file("study.toml", "[judge]\nwindow_max = \"40 kPa\"\n");
  std::vector<Row> rows;
  const std::vector<std::pair<double, double>> path = {{30, 10}, {36, 20}, {33, 60}, {41, 90}, {39, 120}};
  for (const auto &[pressure, angle] : path) {
    Row row;
    for (const std::string &column : history_columns(file.study()))
      row.emplace_back(column, column == "pressure_kPa" ? pressure : column == "bending_angle_deg" ? angle : 1);
    rows.push_back(row);
  }
  const auto judgement = judgement_of(file.study(), rows, optimize::Status::ok, "end");
  const auto responses = responses_of(file.study(), rows, true, judgement);
  REQUIRE(responses.at("window_angle_deg") == 90);
  REQUIRE(responses.at("bending_angle_deg") == 120);
  REQUIRE(responses.at("pressure_kPa_max") == 41);
  REQUIRE(responses.at("pressure_kPa_min") == 30);
  for (const std::string &name : response_names(file.study()))
    REQUIRE(responses.count(name) == 1);
  rows.resize(3); // the window is not reached
  REQUIRE(std::isnan(responses_of(file.study(), rows, false, {}).at("window_angle_deg")));
  REQUIRE(responses_of(file.study(), rows, true, {}).at("window_angle_deg") == 60);
}
