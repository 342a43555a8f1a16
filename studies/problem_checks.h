// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/study.h"
#include "studies/toml_document.h"

namespace ballonet::studies
{

/// Checks of a problem written in the study (kind mesh): file, materials, names, control. Throws InputError.
void check_problem(const Study &study, const TomlDocument &document);

/// Checks of a parametric actuator: materials, and geometry parameters that do not go together. Throws InputError.
void check_actuator(const Study &study, const TomlDocument &document);

} // namespace ballonet::studies
