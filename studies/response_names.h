// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/study.h"
#include <string>
#include <vector>

namespace ballonet::studies
{

/// Columns of history.csv that measure the actuator; the bookkeeping of the path stands beside them.
std::vector<std::string> history_columns(const Study &study);

/// Names of the responses a simulation of this study has, for objectives and constraints: each column of its history
/// by its name (value at the end of the path), with _max and _min (over the path); for PEBS also window_angle_deg, the
/// bending angle of the first state whose running pressure maximum reaches judge.window_max.
std::vector<std::string> response_names(const Study &study);

} // namespace ballonet::studies
