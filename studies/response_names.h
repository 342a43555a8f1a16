// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/study.h"
#include <string>
#include <vector>

namespace ballonet::studies
{

/// What stands before the names of the reduced model's responses where both models are asked.
inline constexpr const char *reduced_prefix = "reduced_";

/// Columns of history.csv that measure the actuator; the bookkeeping of the path stands beside them.
std::vector<std::string> history_columns(const Study &study);

/// Names of the responses a simulation of this study has, for objectives and constraints: each column of its history
/// by its name (value at the end of the path), with _max and _min (over the path); for PEBS with a
/// balloon also window_angle_deg, the bending angle of the first state whose running pressure maximum reaches
/// judge.window_max, and margin_names(). The reduced model has no stresses; where both models are asked, its responses
/// stand beside the others with reduced_prefix.
std::vector<std::string> response_names(const Study &study);

} // namespace ballonet::studies
