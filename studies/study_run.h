// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/evaluator.h"
#include "optimize/result.h"
#include "studies/study_file.h"

namespace ballonet::studies
{

/// Does what the method of the study asks: one simulation, a sample or a search.
optimize::Result run_method(const StudyFile &study, optimize::Evaluator &evaluator,
                            const optimize::OnFinished &on_finished);

/// Whether the run has what it was for: a simulation that came to its end, one usable design of a sample, a feasible
/// best design of a search.
bool has_result(const Study &study, const optimize::Result &result);

/// The optimization problem of a study.
optimize::Problem problem_of(const StudyFile &study);

/// How many simulations the method asks for at most.
std::size_t largest_number_of_evaluations(const StudyFile &study);

} // namespace ballonet::studies
