// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/result.h"
#include "studies/journal_format.h"
#include "studies/study_file.h"
#include <optional>
#include <string>

namespace ballonet::studies
{

/// What summary.json says about a run.
struct Summary {
  std::string status = "running"; ///< running, done, no_result
  std::string reason;             ///< why it ended, in words
  optimize::Result result;
  double wall_seconds = 0;
  int ranks = 1;
};

/// The text of summary.json: study, question, status, reason, best (id, design, responses, feasible, judgement,
/// and where both models were asked disagreements: {"RESPONSE": {"fem", "reduced"}}), objective, counts by status,
/// classes (counts of judged paths), evaluations, replayed, how discrete variables and failures were treated,
/// wall_seconds, version, commit, ranks.
std::string summary_text(const Summary &summary, const StudyFile &study, const JournalFormat &format);

} // namespace ballonet::studies
