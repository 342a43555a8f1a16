// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/design.h"
#include "studies/study.h"
#include "studies/toml_document.h"
#include <vector>

namespace ballonet::studies
{

/// The variables of a study with units and numbers. Throws InputError for a key that does not exist or has no number,
/// and for bounds or values that are missing or make no sense.
optimize::DesignSpace design_space(const Study &study, const TomlDocument &document);

/// min and max, or all values.
std::vector<double> extreme_values(const optimize::Variable &variable);

struct VariableValue {
  optimize::Variable variable;
  double value;
};

/// `overrides` followed by one for each variable.
std::vector<Override> overrides_with(std::vector<Override> overrides, const std::vector<VariableValue> &values);

} // namespace ballonet::studies
