// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/reduced_parameters.h"
#include "solver/material.h"
#include "studies/study_file.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ballonet::studies
{
namespace
{

constexpr double degree = std::numbers::pi / 180;
constexpr double angle_step = 2 * degree; // between two rows of a static path

/// The balloon's material with what counts: W = C10 (I1 - 3) and the density.
solver::Material balloon_view(const Study &study)
{
  const solver::Material &given = material_named(study, study.actuator.balloon_material);
  solver::Material seen;
  seen.name = given.name;
  seen.c10 = solver::make_material(given)->shear_modulus() / 2;
  seen.d1 = 0;
  seen.density = given.density;
  return seen;
}

/// The backbone's material: small-strain moduli and density.
solver::Material backbone_view(const Study &study)
{
  const solver::Material &given = material_named(study, study.actuator.backbone_material);
  const auto law = solver::make_material(given);
  const double mu = law->shear_modulus(), K = law->bulk_modulus();
  solver::Material seen;
  seen.name = given.name;
  seen.law = solver::Law::saint_venant;
  seen.youngs_modulus = 9 * K * mu / (3 * K + mu);
  seen.poisson_ratio = (3 * K - 2 * mu) / (6 * K + 2 * mu);
  seen.density = given.density;
  return seen;
}

bool all_are(const std::vector<double> &list, double value)
{
  return std::all_of(list.begin(), list.end(), [&](double other) { return other == value; });
}

/// The same actuator with lists that say nothing new left out.
geometry::Pebs shortened(geometry::Pebs pebs)
{
  for (std::vector<double> *list : {&pebs.ribs.slope, &pebs.ribs.v_angle, &pebs.ribs.orientation})
    if (all_are(*list, 0))
      list->clear();
  if (all_are(pebs.ribs.arc, 360))
    pebs.ribs.arc.clear();
  if (!pebs.wall.rise.empty() && all_are(pebs.wall.rise, pebs.wall.rise.front()))
    pebs.wall.rise.resize(1);
  return pebs;
}

geometry::Pebs pebs_view(const geometry::Pebs &given)
{
  geometry::Pebs seen;
  seen.balloon = given.balloon;
  seen.ribs.count = given.ribs.count;
  seen.ribs.width = given.ribs.width;
  seen.ribs.gap = given.ribs.gap;
  seen.ribs.thickness = given.ribs.thickness;
  seen.ribs.inner_radius = given.ribs.inner_radius;
  seen.wall.thickness = given.wall.thickness;
  seen.wall.width = given.wall.width;
  if (const auto rise = shortened(given).wall.rise; rise.size() == 1)
    seen.wall.rise = rise;
  seen.head = given.head;
  return seen;
}

solver::Path path_view(const solver::Path &given, const solver::Path &defaults)
{
  solver::Path seen = defaults;
  seen.control = given.control;
  seen.volume_max = given.volume_max;
  seen.pressure_max = given.pressure_max;
  if (given.control == solver::Control::ramp)
    seen.pressure_rate = given.pressure_rate;
  return seen;
}

std::string allowed_for(const KeyDescription &row)
{
  if (row.key == "contact.friction")
    return "0, or the key left out: the reduced model is frictionless";
  return row.default_value + ", which is all the reduced model knows, or method.model = \"fem\"";
}

/// The first key of the actuator and its surroundings whose values differ.
std::optional<UnknownToReduced> first_difference(const Study &given, const Study &seen)
{
  const auto rows = describe_keys(given), seen_rows = describe_keys(seen);
  for (const KeyDescription &row : rows) {
    const auto other =
        std::find_if(seen_rows.begin(), seen_rows.end(), [&](const auto &r) { return r.key == row.key; });
    if (other != seen_rows.end() && other->default_value != row.default_value)
      return UnknownToReduced{row.key, row.default_value, allowed_for(*other)};
  }
  return {};
}

std::optional<UnknownToReduced> unknown_material(const Study &study)
{
  constexpr double least_ratio = 50; // of bulk to shear modulus: 1 % and less of the pressures
  const std::string &name = study.actuator.balloon_material;
  const solver::Material &balloon = material_named(study, name);
  const auto law = solver::make_material(balloon);
  if (balloon.law != solver::Law::neo_hookean)
    return UnknownToReduced{"material." + name + ".law", "another law for the balloon", "neo_hookean"};
  if (law->bulk_modulus() < least_ratio * law->shear_modulus())
    return UnknownToReduced{"material." + name, "a compressible balloon",
                            "a bulk modulus of 50 shear moduli or more: the reduced model's balloon is incompressible"};
  return {};
}

std::optional<UnknownToReduced> unknown_motion(const Study &study)
{
  const auto control = study.path.control;
  if (control == solver::Control::load || control == solver::Control::release)
    return UnknownToReduced{"path.control", control == solver::Control::load ? "\"load\"" : "\"release\"",
                            "volume | pressure | arc_length | ramp"};
  if (control == solver::Control::ramp && !study.path.inertia)
    return UnknownToReduced{"path.inertia", "a ramp without mass", "true"};
  if (control == solver::Control::ramp && std::isinf(study.path.pressure_max))
    return UnknownToReduced{"path.pressure_max", "a ramp without end", "a pressure"};
  return {};
}

} // namespace

Study reduced_view(const Study &study)
{
  Study seen = default_study(ActuatorKind::pebs);
  seen.method.model = ModelKind::reduced;
  seen.actuator.pebs = pebs_view(study.actuator.pebs);
  seen.actuator.balloon_material = study.actuator.balloon_material;
  seen.actuator.backbone_material = study.actuator.backbone_material;
  seen.materials = {balloon_view(study), backbone_view(study)};
  seen.gravity = {0, 0, study.gravity[2]};
  seen.path = path_view(study.path, seen.path);
  seen.judge = study.judge;
  return seen;
}

std::optional<UnknownToReduced> unknown_to_reduced(const Study &study)
{
  if (const auto unknown = unknown_material(study))
    return unknown;
  if (!study.rigid_bodies.empty())
    return UnknownToReduced{"rigid", "a rigid body", "none, or method.model = \"fem\""};
  const Study seen = reduced_view(study);
  Study given = seen;
  given.actuator = study.actuator;
  given.actuator.pebs = shortened(study.actuator.pebs);
  given.gravity = study.gravity;
  if (study.contact.friction > 0)
    given.contact.friction = study.contact.friction;
  const auto difference = first_difference(given, seen);
  return difference ? difference : unknown_motion(study);
}

solver::reduced::Parameters reduced_parameters(const Study &study)
{
  const Study seen = reduced_view(study);
  const geometry::Pebs &pebs = seen.actuator.pebs;
  const solver::Material &latex = seen.materials.front(), &tpu = seen.materials.back();
  solver::reduced::Parameters parameters;
  parameters.balloon = {pebs.balloon.diameter, pebs.balloon.wall, pebs.balloon.length, *latex.c10, latex.density};
  parameters.ribs = {pebs.ribs.count, pebs.ribs.width, pebs.ribs.gap, pebs.ribs.thickness, pebs.ribs.inner_radius, {}};
  parameters.wall = {pebs.wall.thickness, pebs.wall.width, pebs.wall.rise.front(), true, *tpu.youngs_modulus,
                     *tpu.poisson_ratio,  tpu.density};
  parameters.head = {pebs.head.thickness, {}};
  parameters.gravity = -seen.gravity[2];
  parameters.static_path = {angle_step, seen.judge.end_angle * degree};
  parameters.ramp.pressure_rate = seen.path.pressure_rate;
  parameters.ramp.duration = seen.path.pressure_max / seen.path.pressure_rate;
  parameters.ramp.stop_angle = seen.judge.end_angle * degree;
  return parameters;
}

} // namespace ballonet::studies
