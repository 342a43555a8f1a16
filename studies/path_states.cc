// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/path_states.h"
#include <algorithm>

namespace ballonet::studies
{
namespace
{

constexpr double kPa_per_MPa = 1e3;

PathState state_of(const Row &row)
{
  PathState state;
  state.pressure = value_of(row, "pressure_kPa");
  state.volume = value_of(row, "volume_mm3");
  state.angle = value_of(row, "bending_angle_deg");
  state.bulge = value_of(row, "max_bulge_mm");
  state.localisation = value_of(row, "localisation_index");
  state.rib_opening = value_of(row, "rib_opening_mm");
  state.touched_share = value_of(row, "rib_contact_fraction");
  state.radial_ratio = value_of(row, "radial_ratio");
  for (const auto &[name, value] : row)
    if (name.starts_with("gap_") && name.ends_with("_deg"))
      state.gaps.push_back(value);
  return state;
}

/// A rise of the pressure starts from a new minimum: only the last fall counts.
void mark_falls(std::vector<PathState> &states, double snap_drop)
{
  double peak = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const double pressure = states[i].pressure;
    if (i == 0 || pressure > states[i - 1].pressure)
      peak = pressure;
    states[i].past_limit = peak > 0 && peak - pressure > snap_drop * peak;
  }
}

} // namespace

std::vector<PathState> judged_part(const std::vector<Row> &rows, const Judge &judge)
{
  const auto reaches = [](double pressure_MPa) {
    return [=](const PathState &state) { return state.pressure >= kPa_per_MPa * pressure_MPa; };
  };
  std::vector<PathState> states;
  for (const Row &row : rows)
    states.push_back(state_of(row));
  mark_falls(states, judge.snap_drop);
  const auto begin = std::find_if(states.begin(), states.end(), reaches(judge.window_min));
  const auto end = std::find_if(begin, states.end(), reaches(judge.window_max));
  return {begin, end == states.end() ? end : end + 1};
}

} // namespace ballonet::studies
