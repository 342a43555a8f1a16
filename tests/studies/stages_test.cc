// SPDX-License-Identifier: LGPL-2.1-or-later
#include "mesh_study.h"
#include "studies/history_table.h"
#include "studies/stages.h"
#include "studies/word_columns.h"
#include <catch2/catch.hpp>
#include <fstream>

using namespace ballonet;
using namespace ballonet::studies;

namespace
{

/// The head force counts above 0.02 x 0.04 MPa x 50 mm^2 = 0.04 N at 40 kPa.
const StageThresholds thresholds = {0.02, 0.9, 50, 1.5};

Row row(double head_force, double touched, double bulge, double pressure_kPa = 40)
{
  return {{"pressure_kPa", pressure_kPa},
          {"head_force_N", head_force},
          {"rib_contact_fraction", touched},
          {"max_bulge_mm", bulge}};
}

std::vector<Stage> stages_of(const std::vector<Row> &rows)
{
  StageTracker tracker(thresholds);
  std::vector<Stage> stages;
  for (const Row &r : rows)
    stages.push_back(tracker.advance(r));
  return stages;
}

} // namespace

TEST_CASE("a path goes through the four stages")
{
  using enum Stage;
  const auto stages =
      stages_of({row(0, 0, -4), row(0.05, 0, -1), row(0.05, 0.3, 0), row(0.05, 0.9, 1), row(1, 1, 1.5)});
  REQUIRE(stages == std::vector{separation, separation, insufficient, sufficient, excessive});
}

TEST_CASE("separation ends with a head force in two rows in a row, above a share of the pressure's force")
{
  using enum Stage;
  REQUIRE(stages_of({row(0.05, 0, 0), row(0, 0, 0), row(0.05, 0, 0), row(0.03, 0, 0)}).back() == separation);
  REQUIRE(stages_of({row(0.05, 0, 0), row(0.05, 0, 0)}).back() == insufficient);
  REQUIRE(stages_of({row(0.05, 0, 0, 60), row(0.05, 0, 0, 60)}).back() == separation); // 0.06 N are needed
  REQUIRE(stages_of({row(0, 0, 0, -1), row(0, 0, 0, -1)}).back() == separation);       // no force, in spite of suction
}

TEST_CASE("a stage is not left for an earlier one and may be skipped")
{
  using enum Stage;
  REQUIRE(stages_of({row(0, 0.95, 0), row(0, 0.2, 0)}) == std::vector{sufficient, sufficient});
  REQUIRE(stages_of({row(0, 0.2, 2), row(1, 0.95, 0), row(1, 0.95, 0)}) ==
          std::vector{excessive, excessive, excessive});
}

TEST_CASE("an interrupted path goes on in its stage, with the head force of its last row")
{
  Row last = row(0.05, 0, 0);
  last.emplace_back(stage_column, static_cast<double>(Stage::separation));
  StageTracker tracker(thresholds);
  tracker.go_on_after(last);
  REQUIRE(tracker.advance(row(0.05, 0, 0)) == Stage::insufficient);

  last.back().second = static_cast<double>(Stage::sufficient);
  tracker.go_on_after(last);
  REQUIRE(tracker.advance(row(0, 0, 0)) == Stage::sufficient);
}

TEST_CASE("stages are words in a history")
{
  const tests::Folder folder("stage_words");
  const auto file = folder.path / "history.csv";
  {
    HistoryTable table(file, {});
    for (const Stage stage : {Stage::separation, Stage::excessive})
      table.append({{"step", 1}, {stage_column, static_cast<double>(stage)}});
  }
  std::ifstream stream(file);
  REQUIRE(std::string(std::istreambuf_iterator<char>(stream), {}) == "step,stage\n1,separation\n1,excessive\n");
  const auto rows = read_history(file);
  REQUIRE(value_of(rows.at(0), stage_column) == 0);
  REQUIRE(value_of(rows.at(1), stage_column) == 3);
  for (const Stage stage : {Stage::separation, Stage::insufficient, Stage::sufficient, Stage::excessive})
    REQUIRE(number_of(stage_column, word_of(stage)) == static_cast<double>(stage));
  REQUIRE_THROWS_AS(number_of(stage_column, "unheard"), std::invalid_argument);
  REQUIRE(all_words_of(stage_column) == "separation,insufficient,sufficient,excessive");
  REQUIRE(number_of(state_column, "equilibrium") == 1);
  REQUIRE(words_of("pressure_kPa").empty());
}
