// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/evaluation.h"
#include "studies/journal_format.h"
#include "studies/study.h"
#include <filesystem>
#include <functional>
#include <mpi.h>
#include <optional>

namespace ballonet::studies
{

/// What came out of one simulation.
struct EvaluationOutcome {
  optimize::Status status = optimize::Status::failed;
  std::string reason; ///< why the path ended, also if all is well
  std::map<std::string, double> responses;
  std::optional<Judgement> judgement;          ///< of the path, where paths are judged
  std::vector<CriticalRecord> critical_points; ///< located along the path
  std::string mesh_hash;
  double seconds = 0; ///< wall time of this session
};

/// The evaluation an outcome amounts to; what is kept beside it (folder, mesh, judgement) goes into `format`.
optimize::Evaluation recorded_evaluation(JournalFormat &format, const std::string &hash, const optimize::Design &design,
                                         int number, const EvaluationOutcome &outcome);

/// Simulates a study and leaves mesh.msh, history.csv, history.h5, fields, log.txt and checkpoint.h5 in `folder`, which
/// exists. If there is a checkpoint the path goes on from it. Called by all ranks of `communicator`; all get the same
/// outcome. `between_steps` is called on every rank after every step.
EvaluationOutcome run_evaluation(const Study &study, const std::filesystem::path &folder, MPI_Comm communicator,
                                 const std::function<void()> &between_steps);

} // namespace ballonet::studies
