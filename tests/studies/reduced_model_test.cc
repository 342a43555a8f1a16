// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_study.h"
#include "solver/reduced/balloon_tube.h"
#include "studies/content_hash.h"
#include "studies/history_table.h"
#include "studies/paired_model.h"
#include "studies/reduced_parameters.h"
#include "studies/reduced_path.h"
#include "studies/response_names.h"
#include "studies/study_file.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

using namespace ballonet;
using namespace ballonet::studies;
using ballonet::tests::Folder;

namespace
{

const std::string reduced = "[method]\nmodel = \"reduced\"\n";

const std::string search = R"(
[method]
model = "reduced"
kind = "optimize"
algorithm = "LN_COBYLA"
max_evaluations = 12
[[variable]]
key = "material.latex.c10"
min = "120 kPa"
max = "180 kPa"
[[variable]]
key = "actuator.balloon.diameter"
min = "6.4 mm"
max = "8 mm"
[objective]
response = "pressure_kPa_max"
goal = "minimize"
)";

Study study_of(const std::string &text) { return StudyFile("study.toml", text).study(); }

std::string message_of(const std::string &text)
{
  try {
    StudyFile("study.toml", text);
  } catch (const InputError &e) {
    return e.what();
  }
  return {};
}

double largest(const std::vector<Row> &rows, const std::string &column)
{
  double result = value_of(rows.front(), column);
  for (const Row &row : rows)
    result = std::max(result, value_of(row, column));
  return result;
}

} // namespace

TEST_CASE("one study by the reduced model, with the files of a simulation but no mesh")
{
  const Folder folder("reduced_solve");
  tests::StudyRun run(folder, reduced);
  REQUIRE(run() == 0);
  const auto line = run.journal().at(0);
  CHECK(line.at("status") == "ok");
  CHECK(line.at("mesh_hash") == "");
  CHECK(line.at("reason") == "judge.end_angle is reached");
  CHECK(line.at("judgement").at("class").is_string());
  CHECK(run.summary().at("status") == "done");
  const auto evaluation = run.results / "evaluations/0001";
  for (const char *file : {"history.csv", "log.txt", "study.toml", "hash"})
    CHECK(std::filesystem::exists(evaluation / file));
  CHECK_FALSE(std::filesystem::exists(evaluation / "mesh.msh"));
  const auto rows = read_history(evaluation / "history.csv");
  std::set<std::string> columns;
  for (const auto &[name, value] : rows.front())
    columns.insert(name);
  const Study study = study_of(reduced);
  for (const std::string &column : history_columns(study))
    CHECK(columns.count(column) == 1);
  for (const std::string &name : response_names(study))
    CHECK(line.at("responses").count(name) == 1);
  CHECK(value_of(rows.back(), "bending_angle_deg") == Approx(270));
  // A results directory resolves to itself.
  CHECK(content_hash(StudyFile::open((run.results / "resolved.toml").string()).study()) == content_hash(study));
}

TEST_CASE("a study becomes the parameters of the reduced model")
{
  const auto given = reduced_parameters(study_of(reduced + R"(
[actuator.balloon]
diameter = "7 mm"
[actuator.wall]
rise = "1.2 mm"
[material.latex]
c10 = "150 kPa"
[path]
control = "ramp"
pressure_rate = "40 kPa/s"
pressure_max = "60 kPa"
)"));
  CHECK(given.balloon.diameter == 7);
  CHECK(given.balloon.c10 == Approx(0.15));
  CHECK(given.balloon.density == Approx(1.08e-9));
  CHECK(given.wall.rise == 1.2);
  CHECK(given.wall.thickness == 0.9);
  CHECK(given.wall.youngs_modulus == Approx(180));
  CHECK(given.wall.poisson_ratio == Approx(0.45));
  CHECK(given.ribs.count == 20);
  CHECK(given.gravity == 9810);
  CHECK(given.ramp.duration == Approx(1.5));
}

TEST_CASE("the static path has rows at its limit and at the end of the pressure")
{
  const auto whole = reduced_path(study_of(reduced)),
             cut = reduced_path(study_of(reduced + "[path]\npressure_max = \"30 kPa\"\n"));
  const solver::reduced::BalloonTube tube(reduced_parameters(study_of(reduced)).balloon);
  CHECK(whole.status == optimize::Status::ok);
  CHECK(largest(whole.rows, "pressure_kPa") > 1e3 * tube.limit().pressure); // the backbone holds it back
  CHECK(largest(whole.rows, "pressure_kPa") < 1.05e3 * tube.limit().pressure);
  CHECK(value_of(whole.rows.front(), "pressure_kPa") < 1);
  CHECK(cut.reason == "path.pressure_max is reached");
  CHECK(largest(cut.rows, "pressure_kPa") == Approx(30).epsilon(1e-9));
  for (std::size_t i = 1; i < cut.rows.size(); ++i)
    CHECK(value_of(cut.rows[i], "bending_angle_deg") > value_of(cut.rows[i - 1], "bending_angle_deg"));
}

TEST_CASE("a ramp is followed in time")
{
  const auto path = reduced_path(study_of(reduced + "[path]\ncontrol = \"ramp\"\npressure_max = \"38 kPa\"\n"));
  CHECK(path.status == optimize::Status::ok);
  CHECK(path.reason == "path.pressure_max is reached");
  CHECK(value_of(path.rows.back(), "time_s") == Approx(38. / 80).epsilon(1e-3));
  CHECK(value_of(path.rows.back(), "pressure_kPa") == Approx(38).epsilon(1e-3));
  CHECK(value_of(path.rows.front(), "bending_angle_deg") < -10); // it droops
}

TEST_CASE("the path ends where the balloon runs out of its cage, an interaction failure that survives the journal")
{
  const Folder folder("reduced_run_out");
  tests::StudyRun run(folder, reduced + R"(
[path]
pressure_max = "100 kPa"
[judge]
window_max = "100 kPa"
end_angle = "500 deg"
[material.latex]
c10 = "60 kPa"
)");
  REQUIRE(run() == 0);
  const auto line = run.journal().at(0);
  CHECK(line.at("reason") == "the balloon runs out of the widest gap");
  CHECK(line.at("judgement").at("class") == "interaction_failure");
  CHECK(line.at("responses").at("max_bulge_mm").is_null()); // no number is large enough
  REQUIRE(run({"--resume"}) == 0);
  CHECK(run.journal().at(0) == line);
  CHECK(run.summary().at("best").at("judgement").at("class") == "interaction_failure");
}

TEST_CASE("a backbone that does not carry itself is a failure with a reason")
{
  const auto path = reduced_path(study_of(reduced + "[actuator.wall]\nthickness = \"0.3 mm\"\n"));
  CHECK(path.status == optimize::Status::diverged);
  CHECK_THAT(path.reason, Catch::Contains("droop"));
}

TEST_CASE("a design out of the reduced model's range fails, a study out of it is wrong input")
{
  Study study = study_of(reduced);
  study.actuator.pebs.balloon.diameter = 17;
  const auto path = reduced_path(study);
  CHECK(path.status == optimize::Status::failed);
  CHECK_THAT(path.reason, Catch::Contains("balloon.diameter"));
  CHECK_FALSE(message_of(reduced + "[actuator.ribs]\ncount = 1\n[actuator.balloon]\nlength = \"4 mm\"\n").empty());
}

TEST_CASE("a killed search goes on, and what it had is not computed again")
{
  const Folder folder("reduced_resume");
  tests::StudyRun run(folder, search);
  REQUIRE(run() == 0);
  const auto whole = run.journal();
  const auto best = run.summary().at("best").at("design");
  REQUIRE(whole.size() == 12);
  std::ofstream(run.results / "journal.jsonl") << whole[0] << "\n" << whole[1] << "\n" << whole[2].dump().substr(0, 99);
  REQUIRE(run({"--resume"}) == 0);
  const auto again = run.journal();
  REQUIRE(again.size() == 12);
  for (std::size_t i = 0; i < whole.size(); ++i) {
    auto a = whole[i], b = again[i];
    a.erase("seconds");
    b.erase("seconds");
    CHECK(a == b);
  }
  CHECK(run.summary().at("best").at("design") == best);
  CHECK(run.summary().at("replayed") == 2);
  REQUIRE(run({"--resume"}) == 0);
  CHECK(run.summary().at("replayed") == 12);
  CHECK(run.journal() == again);
}

TEST_CASE("what the reduced model does not know is wrong input at its key")
{
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"[actuator.ribs]\nslope = \"2 deg\"\n", "actuator.ribs.slope"},
      {"[actuator.ribs]\nv_angle = \"10 deg\"\n", "actuator.ribs.v_angle"},
      {"[actuator.ribs]\norientation = \"90 deg\"\n", "actuator.ribs.orientation"},
      {"[actuator.ribs]\narc = \"300 deg\"\n", "actuator.ribs.arc"},
      {"[actuator.wall]\nvalley_share = 0.5\n", "actuator.wall.valley_share"},
      {"[actuator.wall]\nthick_land = true\n", "actuator.wall.thick_land"},
      {"[actuator]\nhead_held = true\n", "actuator.head_held"},
      {"[actuator]\nwith_balloon = false\n[path]\ncontrol = \"load\"\n", "actuator.with_balloon"},
      {"[path]\ncontrol = \"load\"\n", "path.control"},
      {"[contact]\nfriction = 0.2\n", "contact.friction"},
      {"[material.latex]\nd1 = \"1 1/MPa\"\n", "material.latex"},
      {"[material.latex]\nlaw = \"saint_venant\"\nyoungs_modulus = \"1 MPa\"\npoisson_ratio = 0.49\n",
       "material.latex.law"},
      {"[actuator]\nkind = \"balloon\"\n", "method.model"},
      {"[objective]\nresponse = \"balloon_stress_max_MPa\"\n", "objective.response"},
  };
  for (const auto &[block, key] : wrong) {
    CAPTURE(block);
    CHECK_THAT(message_of(block + reduced), Catch::Contains(key + ": given"));
    if (key != "objective.response")
      CHECK_THAT(message_of(block + reduced), Catch::Contains("reduced model"));
  }
  CHECK_THAT(message_of("gravity = [\"1 m/s^2\", \"0 m/s^2\", \"0 m/s^2\"]\n" + reduced), Catch::Contains("gravity"));
  CHECK(message_of("[actuator.ribs]\nslope = [\"0 deg\"]\n[contact]\nfriction = 0\n[mesh]\nalong_fold = 6\n" + reduced)
            .empty());
}

TEST_CASE("variables the reduced model cannot follow are wrong input")
{
  const auto varied = [](const std::string &key, const std::string &min, const std::string &max) {
    return "[actuator.ribs]\nslope = [\"0 deg\"]\n[method]\nmodel = \"reduced\"\nkind = \"sample\"\n[[variable]]\nkey "
           "= \"" +
           key + "\"\nmin = \"" + min + "\"\nmax = \"" + max + "\"\n";
  };
  CHECK(message_of(varied("actuator.balloon.diameter", "7 mm", "8 mm")).empty());
  CHECK_THAT(message_of(varied("actuator.ribs.slope", "0 deg", "9 deg")), Catch::Contains("actuator.ribs.slope = "));
  CHECK_THAT(message_of(varied("path.step_max", "1 ms", "9 ms")), Catch::Contains("makes a difference"));
  CHECK_THAT(message_of(varied("actuator.balloon.diameter", "7 mm", "8 mm") + "[path]\ncontrol = \"load\"\n"),
             Catch::Contains("path.control"));
}

TEST_CASE("the hash knows the model and what the reduced model takes notice of")
{
  CHECK(content_hash(study_of(reduced)) != content_hash(study_of("[actuator]\n")));
  CHECK(content_hash(study_of(reduced)) == content_hash(study_of(reduced + "[mesh]\nalong_fold = 6\n")));
  CHECK(content_hash(study_of(reduced)) != content_hash(study_of(reduced + "[actuator.balloon]\nwall = \"0.6 mm\"\n")));
  CHECK(content_hash(study_of("[actuator]\n")) != content_hash(study_of("[mesh]\nalong_fold = 6\n")));
  CHECK(content_hash(study_of(reduced)) != content_hash(study_of(reduced + "[judge]\nend_angle = \"200 deg\"\n")));
}

TEST_CASE("a dry run of the reduced model makes no mesh")
{
  const Folder folder("reduced_dry");
  tests::StudyRun run(folder, search);
  REQUIRE(run({"--dry-run"}) == 0);
  CHECK_THAT(run.text, Catch::Contains("needs none") && Catch::Contains("at most 12"));
}

TEST_CASE("both models are asked, and where they disagree both are told")
{
  const Folder folder("reduced_both");
  tests::StudyRun run(folder, R"(
[actuator.ribs]
count = 3
[actuator.balloon]
length = "13 mm"
[judge]
end_angle = "40 deg"
[mesh]
smallest_jacobian = 1 # no mesh is that good: the simulation fails at once
[method]
model = "both"
kind = "sample"
max_evaluations = 2
[[variable]]
key = "material.latex.c10"
min = "120 kPa"
max = "180 kPa"
[objective]
response = "reduced_window_angle_deg"
goal = "maximize"
)");
  REQUIRE(run() == 1);
  const auto before = run.journal();
  REQUIRE(before.size() == 2);
  const auto line = before.front();
  CHECK(line.at("status") == "mesh_failed");
  CHECK(line.at("responses").at("reduced_bending_angle_deg").get<double>() == Approx(40));
  CHECK(line.at("responses").count("bending_angle_deg") == 0);
  CHECK(std::filesystem::exists(run.results / "evaluations/0002/reduced/history.csv"));
  REQUIRE(run({"--resume"}) == 1);
  CHECK(run.journal() == before);
  CHECK(content_hash(study_of("[method]\nmodel = \"both\"\n")) != content_hash(study_of("[actuator]\n")));
  CHECK(content_hash(study_of("[method]\nmodel = \"both\"\n")) != content_hash(study_of(reduced)));
  CHECK_THAT(message_of("[actuator.ribs]\nslope = \"2 deg\"\n[method]\nmodel = \"both\"\n"),
             Catch::Contains("actuator.ribs.slope"));
}

TEST_CASE("models disagree where a response differs by more than a share, or one of them has none")
{
  optimize::Evaluation evaluation;
  const double none = std::nan("");
  evaluation.responses = {{"a", 100}, {"reduced_a", 104},  {"b", 100}, {"reduced_b", 110}, {"c", none},
                          {"d", 1},   {"reduced_d", none}, {"e", 0},   {"reduced_e", 1e-9}};
  const auto found = disagreements(evaluation);
  REQUIRE(found.size() == 2);
  CHECK(found[0].response == "b");
  CHECK(found[0].reduced == 110);
  CHECK(found[1].response == "d");
}
