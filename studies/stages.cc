// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/stages.h"
#include <algorithm>
#include <array>
#include <numbers>
#include <stdexcept>

namespace ballonet::studies
{
namespace
{

constexpr std::array<const char *, 4> words = {"separation", "insufficient", "sufficient", "excessive"};
constexpr double MPa_per_kPa = 1e-3;

} // namespace

StageThresholds stage_thresholds(const Study &study)
{
  const geometry::Pebs &pebs = study.actuator.pebs;
  const double radius = pebs.balloon.diameter / 2;
  return {study.judge.head_force_share, study.judge.contact_share, std::numbers::pi * radius * radius,
          pebs.ribs.thickness};
}

std::string word_of(Stage stage) { return words.at(static_cast<std::size_t>(stage)); }

std::vector<std::string> all_stage_words() { return {words.begin(), words.end()}; }

bool StageTracker::presses_on_head(const Row &row) const
{
  const double pressure = std::max(0., MPa_per_kPa * value_of(row, "pressure_kPa"));
  return value_of(row, "head_force_N") > thresholds_.head_force_share * pressure * thresholds_.cross_section;
}

Stage StageTracker::advance(const Row &row)
{
  const bool presses = presses_on_head(row);
  if (presses && pressed_)
    stage_ = std::max(stage_, Stage::insufficient);
  pressed_ = presses;
  if (value_of(row, "rib_contact_fraction") >= thresholds_.contact_share)
    stage_ = std::max(stage_, Stage::sufficient);
  if (value_of(row, "max_bulge_mm") >= thresholds_.rib_thickness)
    stage_ = Stage::excessive;
  return stage_;
}

void StageTracker::go_on_after(const Row &row)
{
  stage_ = static_cast<Stage>(static_cast<int>(value_of(row, stage_column)));
  pressed_ = presses_on_head(row);
}

} // namespace ballonet::studies
