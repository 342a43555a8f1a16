// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/history_row.h"
#include "studies/judge.h"

namespace ballonet::studies
{

/// A row of a history, as far as the instabilities of a PEBS are judged by it. NaN where the row has no such column.
struct PathState {
  double pressure = 0;      ///< kPa
  double volume = 0;        ///< mm^3
  double angle = 0;         ///< bending angle, deg
  double bulge = 0;         ///< largest excess of the balloon's radius over the cage's, mm
  double localisation = 0;  ///< largest over mean bulge of the gaps
  double rib_opening = 0;   ///< largest radial growth of a rib, mm
  double touched_share = 0; ///< of the ribs
  double radial_ratio = 0;  ///< mean radius of the balloon over the one at rest
  std::vector<double> gaps; ///< openings from the bottom, deg
  bool past_limit = false;  ///< the pressure has fallen from its last local maximum by more than judge.snap_drop
};

/// The judged part of a path: from the first state whose running pressure maximum reaches judge.window_min to the first
/// at which it reaches judge.window_max. Someone who raises the pressure slowly sees that last state at window_max.
std::vector<PathState> judged_part(const std::vector<Row> &rows, const Judge &judge);

} // namespace ballonet::studies
