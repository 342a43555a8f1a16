// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/actuator_pebs.h"
#include <algorithm>

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

using Names = std::vector<std::string>;

solver::ContactPair contact_pair(const std::string &name, const Names &secondary, const Names &primary,
                                 const ContactDefaults &contact)
{
  solver::ContactPair pair;
  pair.name = name;
  pair.secondary = secondary;
  pair.primary = primary;
  pair.friction = contact.friction;
  pair.stiffness = contact.stiffness;
  pair.thickness = contact.thickness;
  pair.onset = contact.onset;
  pair.points_per_side = contact.points_per_side;
  pair.passes = contact.passes;
  pair.point_spacing = contact.point_spacing;
  pair.elastic_slip = contact.elastic_slip;
  pair.viscous_velocity = contact.viscous_velocity;
  pair.penetration_limit = contact.penetration_limit;
  pair.enforcement = contact.enforcement;
  pair.augmentation_tolerance = contact.augmentation_tolerance;
  pair.max_augmentations = contact.max_augmentations;
  return pair;
}

/// A surface against itself. Every contact is felt from both sides with one pass; `points_per_side` where the surface
/// does not stretch may be few.
solver::ContactPair self_contact(const std::string &part, const Names &surface, int points_per_side,
                                 const ContactDefaults &contact)
{
  solver::ContactPair pair = contact_pair(part, surface, surface, contact);
  pair.passes = 1;
  pair.points_per_side = points_per_side;
  return pair;
}

solver::ContactPair balloon_self_contact(const ContactDefaults &contact)
{
  return self_contact("balloon", {"balloon_outer"}, contact.points_per_side, contact);
}

/// All of the backbone that is free.
const Names backbone_surface = {"backbone_contact", "backbone_outside"};

bool touches_itself(const Study &study, const std::string &part)
{
  const Names &parts = study.contact.self;
  return std::find(parts.begin(), parts.end(), part) != parts.end();
}

void add_contact(solver::Parameters &parameters, const Study &study)
{
  constexpr int points_of_stiff_face = 4;
  const ContactDefaults &contact = study.contact;
  const bool with_balloon = study.actuator.pebs.with_balloon;
  auto &pairs = parameters.contact_pairs;
  if (with_balloon)
    pairs.push_back(contact_pair(cage_pair, {"balloon_outer"}, {"backbone_contact"}, contact));
  if (with_balloon && touches_itself(study, "balloon"))
    pairs.push_back(balloon_self_contact(contact));
  if (touches_itself(study, "backbone"))
    pairs.push_back(self_contact("backbone", backbone_surface, points_of_stiff_face, contact));
  Names everything = backbone_surface;
  if (with_balloon)
    everything.emplace_back("balloon_outer");
  for (const solver::RigidBody &body : parameters.rigid_bodies)
    pairs.push_back(contact_pair(body.name, everything, {body.name}, contact));
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
  if (study.actuator.pebs.with_balloon)
    add_balloon(parameters, study);
  parameters.rigid_bodies = study.rigid_bodies;
  add_contact(parameters, study);
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
  if (touches_itself(study, "balloon"))
    parameters.contact_pairs.push_back(balloon_self_contact(study.contact));
  add_symmetry(parameters, study);
  return model_of(std::get<geometry::PebsMesh>(std::move(built)), std::move(parameters));
}

} // namespace ballonet::studies
