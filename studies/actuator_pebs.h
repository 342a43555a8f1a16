// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/simulation_model.h"

namespace ballonet::studies
{

/// The contact pair of the balloon with the backbone.
constexpr auto cage_pair = "cage";

/// A balloon in a ribbed backbone: both clamped at the bottom, gas inside, contact between them.
std::variant<SimulationModel, geometry::MeshFailure> build_pebs(const Study &study);

/// A balloon alone, clamped at the bottom.
std::variant<SimulationModel, geometry::MeshFailure> build_balloon(const Study &study);

} // namespace ballonet::studies
