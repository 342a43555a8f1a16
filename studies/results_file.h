// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/result.h"
#include "studies/journal_format.h"
#include "studies/results_directory.h"

namespace ballonet::studies
{

/// Writes results.h5, the numbers of a whole run in one file:
///
///   /evaluations        attributes: the unit of each variable, by its key
///   /evaluations/0001   one data set per column of its history.csv (words by their numbers, all of them in the
///   attribute
///                       `words`); attributes status, reason, hash, class (of judged paths) and the value of each
///                       variable, by its key
///   /convergence        data sets evaluation (number), objective, best_so_far (NaN where there is none), feasible
///                       (whether the best so far keeps all constraints), in the order in which designs were asked for
///
/// Everything in it is in the journal and the histories too. Replaces the file in one move; throws an exception and
/// leaves the old file if it cannot be written.
void write_results_file(const ResultsDirectory &directory, const StudyFile &study, const optimize::Result &result,
                        const JournalFormat &format);

} // namespace ballonet::studies
