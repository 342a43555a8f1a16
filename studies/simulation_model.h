// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/pebs_mesh.h"
#include "solver/mesh.h"
#include "studies/study.h"
#include <optional>
#include <variant>

namespace ballonet::studies
{

/// What a simulation of a study is made of.
struct SimulationModel {
  geometry::Mesh mesh;
  std::optional<geometry::PebsLayout> layout; ///< of the built-in actuators
  solver::Parameters parameters;
};

/// The mesh and the solver's parameters of a study, or the reason why there is no mesh.
std::variant<SimulationModel, geometry::MeshFailure> build_model(const Study &study);

/// The same arrays for the solver.
solver::Mesh solver_mesh(const geometry::Mesh &mesh);

/// What every kind of actuator takes from the study unchanged: materials, gravity, path and tolerances.
solver::Parameters shared_parameters(const Study &study);

} // namespace ballonet::studies
