// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/actuator_mesh.h"
#include "geometry/mesh_io.h"

namespace ballonet::studies
{

std::variant<SimulationModel, geometry::MeshFailure> read_problem(const Study &study)
{
  auto mesh = geometry::read_msh(study.actuator.file);
  if (auto *failure = std::get_if<geometry::MeshFailure>(&mesh))
    return std::move(*failure);
  solver::Parameters parameters = shared_parameters(study);
  parameters.bodies = study.bodies;
  parameters.supports = study.supports;
  if (!study.cavities.empty())
    parameters.cavity = study.cavities.front();
  parameters.loads = study.loads;
  parameters.contact_pairs = study.contact_pairs;
  parameters.rigid_bodies = study.rigid_bodies;
  parameters.responses = study.responses;
  return SimulationModel{std::get<geometry::Mesh>(std::move(mesh)), {}, std::move(parameters)};
}

} // namespace ballonet::studies
