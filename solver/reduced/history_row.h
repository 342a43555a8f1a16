// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/reduced/pebs_model.h"
#include <string>
#include <utility>
#include <vector>

namespace ballonet::solver::reduced
{

/// A state under the names and units the columns of a simulation's history.csv have, as far as this model knows them:
/// the unit is the end of the name. The reduced model is planar: no twist. The head is free: no tip force. A balloon
/// that runs out of a gap has an infinite bulge, and a localisation index of the number of gaps.
std::vector<std::pair<std::string, double>> history_row(const PebsModel &model, const State &state);

} // namespace ballonet::solver::reduced
