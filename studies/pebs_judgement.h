// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/evaluation.h"
#include "studies/instability.h"
#include "studies/study.h"
#include <map>
#include <optional>

namespace ballonet::studies
{

/// Whether the paths of a study are judged: those that drive the cavity of a PEBS with a free head.
bool is_judged(const Study &study);

/// The judgement of a path that ended with `status`; nothing if paths of this study are not judged. A path whose status
/// is not ok is not_converged.
std::optional<Judgement> judgement_of(const Study &study, const std::vector<Row> &rows, optimize::Status status,
                                      const std::string &reason);

/// The responses a judgement amounts to: margin_interaction_failure, margin_losing_control, margin_overload, margin
/// (the smallest of these) and margin_weak. NaN for a path that is not_converged.
std::map<std::string, double> margins_of(const Judgement &judgement);

/// The names of these responses; none if paths of this study are not judged.
std::vector<std::string> margin_names(const Study &study);

} // namespace ballonet::studies
