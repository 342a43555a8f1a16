// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/actuator_pebs.h"

namespace ballonet::studies
{
namespace
{

/// The clamped balloon and the gas in it; the cavity is closed by the base plane z = 0 and, in a half model, by y = 0.
void add_balloon(solver::Parameters &parameters, const Study &study)
{
  parameters.bodies.push_back({"balloon", study.actuator.balloon_material, true});
  parameters.supports.push_back({"balloon_base", {"x", "y", "z"}, {}});
  parameters.cavity = solver::Cavity{"balloon_inner", {0, 0, 0}, {"x", "y", "z"}};
}

void add_backbone(solver::Parameters &parameters, const Study &study)
{
  parameters.bodies.push_back({"backbone", study.actuator.backbone_material, false});
  parameters.supports.push_back({"base_bottom", {"x", "y", "z"}, {}});
  if (study.actuator.head_held)
    parameters.supports.push_back({"head_top", {"x", "y", "z"}, {}});
}

void add_symmetry(solver::Parameters &parameters, const Study &study)
{
  if (study.mesh.symmetry)
    parameters.supports.push_back({"symmetry", {"y"}, {}});
}

solver::ContactPair cage_contact(const ContactDefaults &contact)
{
  solver::ContactPair pair;
  pair.name = "cage";
  pair.secondary = {"balloon_outer"};
  pair.primary = {"backbone_contact"};
  pair.friction = contact.friction;
  pair.stiffness = contact.stiffness;
  pair.thickness = contact.thickness;
  pair.onset = contact.onset;
  pair.points_per_side = contact.points_per_side;
  pair.passes = contact.passes;
  pair.elastic_slip = contact.elastic_slip;
  pair.viscous_velocity = contact.viscous_velocity;
  pair.penetration_limit = contact.penetration_limit;
  return pair;
}

SimulationModel model_of(geometry::PebsMesh built, solver::Parameters parameters)
{
  return {std::move(built.mesh), std::move(built.layout), std::move(parameters)};
}

} // namespace

std::variant<SimulationModel, geometry::MeshFailure> build_pebs(const Study &study)
{
  auto built = geometry::build_mesh(study.actuator.pebs, study.mesh);
  if (auto *failure = std::get_if<geometry::MeshFailure>(&built))
    return std::move(*failure);
  solver::Parameters parameters = shared_parameters(study);
  add_backbone(parameters, study);
  if (study.actuator.pebs.with_balloon) {
    add_balloon(parameters, study);
    parameters.contact_pairs.push_back(cage_contact(study.contact));
  }
  add_symmetry(parameters, study);
  return model_of(std::get<geometry::PebsMesh>(std::move(built)), std::move(parameters));
}

std::variant<SimulationModel, geometry::MeshFailure> build_balloon(const Study &study)
{
  auto built = geometry::build_mesh(study.actuator.balloon, study.mesh);
  if (auto *failure = std::get_if<geometry::MeshFailure>(&built))
    return std::move(*failure);
  solver::Parameters parameters = shared_parameters(study);
  add_balloon(parameters, study);
  add_symmetry(parameters, study);
  return model_of(std::get<geometry::PebsMesh>(std::move(built)), std::move(parameters));
}

} // namespace ballonet::studies
