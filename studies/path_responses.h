// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/pebs_judgement.h"
#include <map>

namespace ballonet::studies
{

/// The responses of a path and its judgement, see response_names(). `complete`: the path ended where it should; a
/// window angle that was not reached is the last angle then (the actuator stopped at judge.end_angle), else not a
/// number.
std::map<std::string, double> responses_of(const Study &study, const std::vector<Row> &rows, bool complete,
                                           const std::optional<Judgement> &judgement);

/// The bending angle of the first row whose running maximum of the pressure reaches `pressure_kPa`, NaN if none does.
double angle_at_pressure(const std::vector<Row> &rows, double pressure_kPa);

} // namespace ballonet::studies
