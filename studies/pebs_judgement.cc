// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/pebs_judgement.h"
#include "solver/material.h"
#include "studies/stages.h"
#include <cmath>

namespace ballonet::studies
{
namespace
{

using enum PathClass;

constexpr auto classes_with_margin = {interaction_failure, losing_control, overload, weak};
constexpr const char *smallest = "margin";

std::string margin_name(PathClass path_class) { return std::string(smallest) + "_" + word_of(path_class); }

JudgedActuator judged_actuator(const Study &study)
{
  const geometry::Pebs &pebs = study.actuator.pebs;
  const auto balloon = solver::make_material(material_named(study, study.actuator.balloon_material));
  JudgedActuator actuator;
  actuator.cage_radius = pebs.ribs.inner_radius;
  actuator.rib_thickness = pebs.ribs.thickness;
  actuator.rib_width = pebs.ribs.width;
  actuator.balloon_radius = pebs.balloon.diameter / 2;
  actuator.limit_pressure = tube_limit_pressure(balloon->shear_modulus(), pebs.balloon.wall, actuator.balloon_radius);
  return actuator;
}

std::string last_stage(const std::vector<Row> &rows)
{
  const double stage = rows.empty() ? std::nan("") : value_of(rows.back(), stage_column);
  return std::isnan(stage) ? "" : word_of(static_cast<Stage>(static_cast<int>(stage)));
}

} // namespace

bool is_judged(const Study &study)
{
  const Actuator &actuator = study.actuator;
  return actuator.kind == ActuatorKind::pebs && actuator.pebs.with_balloon && !actuator.head_held &&
         solver::drives_cavity(study.path.control);
}

std::optional<Judgement> judgement_of(const Study &study, const std::vector<Row> &rows, optimize::Status status,
                                      const std::string &reason)
{
  if (!is_judged(study))
    return {};
  const PathEnd end = {status != optimize::Status::ok, reason};
  Judgement judgement = judge_path(rows, study.judge, judged_actuator(study), end);
  judgement.stage = last_stage(rows);
  return judgement;
}

std::map<std::string, double> margins_of(const Judgement &judgement)
{
  std::map<std::string, double> margins = {{smallest, judgement.margin()}};
  for (const PathClass path_class : classes_with_margin)
    margins[margin_name(path_class)] = judgement.margin(path_class);
  return margins;
}

std::vector<std::string> margin_names(const Study &study)
{
  if (!is_judged(study))
    return {};
  std::vector<std::string> names = {smallest};
  for (const PathClass path_class : classes_with_margin)
    names.push_back(margin_name(path_class));
  return names;
}

} // namespace ballonet::studies
