// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/reduced/pebs_path.h"
#include "studies/evaluation_run.h"
#include "studies/history_row.h"

namespace ballonet::studies
{

/// The path of the reduced model that a study asks for, as a history.
struct ReducedPath {
  optimize::Status status = optimize::Status::failed;
  std::string reason; ///< why it ended
  std::vector<Row> rows;
};

/// Ramps are followed in time, all other controls along the static path, from zero pressure past every limit point; its
/// limits, the first contact with the ribs and the pressures at which it ends or is judged have rows of their own. The
/// path ends where that of a simulation would: at path.volume_max, path.pressure_max or judge.end_angle; and where the
/// balloon runs out of a gap, which has no equilibrium. A design out of the model's range is `failed`.
ReducedPath reduced_path(const Study &study);

/// A finished evaluation by the reduced model: leaves history.csv and log.txt in `folder`, which exists. There is
/// nothing to go on from: it takes milliseconds and starts again.
EvaluationOutcome run_reduced_evaluation(const Study &study, const std::filesystem::path &folder);

} // namespace ballonet::studies
