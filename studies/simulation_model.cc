// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/simulation_model.h"
#include "studies/actuator_mesh.h"
#include "studies/actuator_pebs.h"
#include <stdexcept>

namespace ballonet::studies
{

solver::Parameters shared_parameters(const Study &study)
{
  solver::Parameters parameters;
  parameters.materials = study.materials;
  parameters.gravity = study.gravity;
  parameters.path = study.path;
  parameters.newton = study.newton;
  return parameters;
}

solver::Mesh solver_mesh(const geometry::Mesh &mesh)
{
  solver::Mesh result;
  result.nodes = mesh.nodes;
  result.cells = mesh.cells;
  result.cell_body = mesh.cell_body;
  for (const geometry::Body &body : mesh.bodies)
    result.bodies.push_back({body.name});
  for (const geometry::Surface &surface : mesh.surfaces) {
    auto &faces = result.surfaces.emplace_back(solver::Surface{surface.name, {}}).faces;
    for (const geometry::Face &face : surface.faces)
      faces.push_back({face.cell, face.local});
  }
  for (const geometry::NodeSet &set : mesh.node_sets)
    result.node_sets.push_back({set.name, set.nodes});
  return result;
}

std::variant<SimulationModel, geometry::MeshFailure> build_model(const Study &study)
{
  switch (study.actuator.kind) {
  case ActuatorKind::pebs:
    return build_pebs(study);
  case ActuatorKind::balloon:
    return build_balloon(study);
  case ActuatorKind::mesh:
    return read_problem(study);
  default:
    throw std::logic_error("an actuator without a model passed the checks");
  }
}

} // namespace ballonet::studies
