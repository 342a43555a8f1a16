// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/measurement.h"

namespace ballonet::studies
{

/// The stages of a balloon in its cage, in the order in which a path goes through them.
enum class Stage {
  separation,   ///< the balloon does not press on the head
  insufficient, ///< it does, but touches few ribs
  sufficient,   ///< it touches nearly all ribs
  excessive     ///< it bulges out between them
};

/// The column of history.csv that holds the stage: a word there, the number of the stage in a Row.
inline constexpr const char *stage_column = "stage";

std::string word_of(Stage stage);

/// All of them in the order of the stages.
std::vector<std::string> all_stage_words();

/// Where the stages begin.
struct StageThresholds {
  double head_force_share = 0.02; ///< insufficient: head force over pressure x balloon cross-section above this
  double contact_share = 0.9;     ///< sufficient: share of ribs touched
  double cross_section = 0;       ///< of the balloon at rest, mm^2
  double rib_thickness = 0;       ///< excessive: bulge, mm
};

/// Those of a PEBS study.
StageThresholds stage_thresholds(const Study &study);

/// Tells the stage from the rows of a history. A stage once reached is not left for an earlier one; it may be skipped.
class StageTracker
{
public:
  explicit StageTracker(const StageThresholds &thresholds) : thresholds_(thresholds) {}

  /// The stage of the next row, from its pressure_kPa, head_force_N, rib_contact_fraction and max_bulge_mm. The head
  /// force counts when it is above its threshold in two rows in a row.
  Stage advance(const Row &row);

  /// Goes on after a row that has its stage.
  void go_on_after(const Row &row);

private:
  bool presses_on_head(const Row &row) const;

  StageThresholds thresholds_;
  Stage stage_ = Stage::separation;
  bool pressed_ = false; // in the row before
};

/// The column stage; stands behind the gauges whose columns it reads.
class StageGauge : public Gauge
{
public:
  explicit StageGauge(const StageThresholds &thresholds) : tracker_(thresholds) {}
  void measure(const solver::PathPoint &, const solver::Equilibrium &, Row &row) override
  {
    row.emplace_back(stage_column, static_cast<double>(tracker_.advance(row)));
  }
  void go_on_after(const Row &row) override { tracker_.go_on_after(row); }

private:
  StageTracker tracker_;
};

} // namespace ballonet::studies
