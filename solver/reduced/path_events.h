// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/reduced/pebs_path.h"

namespace ballonet::solver::reduced
{

enum class PathKind { quasi_static, ramp };

/// The events between the rows of a path, in the order of its angles or times. On a quasi-static path, limits and first
/// contact with the ribs are solved for; a ramp has no limits.
std::vector<Event> find_events(const std::vector<State> &rows, const PebsModel &model, PathKind kind);

} // namespace ballonet::solver::reduced
