// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/simulation_model.h"

namespace ballonet::studies
{

/// A mesh file with the problem written in the study.
std::variant<SimulationModel, geometry::MeshFailure> read_problem(const Study &study);

} // namespace ballonet::studies
