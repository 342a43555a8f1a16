// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/response_names.h"
#include "studies/obstacle_gauge.h"
#include "studies/pebs_judgement.h"
#include <cstdio>

namespace ballonet::studies
{
namespace
{

std::vector<std::string> pebs_columns(int n_gaps)
{
  std::vector<std::string> names = {"bending_angle_deg",
                                    "twist_deg",
                                    "out_of_plane_deg",
                                    "tip_x_mm",
                                    "tip_y_mm",
                                    "tip_z_mm",
                                    "tip_force_N",
                                    "head_force_N",
                                    "axial_ratio",
                                    "radial_ratio",
                                    "balloon_stress_max_MPa",
                                    "backbone_stress_max_MPa",
                                    "max_bulge_mm",
                                    "localisation_index",
                                    "rib_contact_fraction",
                                    "rib_opening_mm"};
  for (int gap = 1; gap <= n_gaps; ++gap) {
    char name[32];
    std::snprintf(name, sizeof name, "gap_%02d_deg", gap);
    names.emplace_back(name);
  }
  return names;
}

/// What the reduced model knows nothing of.
bool is_stress(const std::string &column) { return column.ends_with("_stress_max_MPa"); }

std::vector<std::string> names_of_both(Study study)
{
  study.method.model = ModelKind::fem;
  std::vector<std::string> names = response_names(study);
  study.method.model = ModelKind::reduced;
  for (const std::string &name : response_names(study))
    names.push_back(reduced_prefix + name);
  return names;
}

} // namespace

std::vector<std::string> history_columns(const Study &study)
{
  std::vector<std::string> names;
  if (study.actuator.kind != ActuatorKind::mesh || !study.cavities.empty())
    names = {"pressure_kPa", "volume_mm3", "volume_ratio"};
  for (const solver::Response &response : study.responses)
    names.push_back(response.name);
  if (study.actuator.kind == ActuatorKind::balloon)
    names.insert(names.end(), {"axial_ratio", "radial_ratio", "balloon_stress_max_MPa"});
  if (study.actuator.kind == ActuatorKind::pebs)
    for (const std::string &name : pebs_columns(study.actuator.pebs.ribs.count))
      names.push_back(name);
  if (study.actuator.kind == ActuatorKind::pebs)
    for (const solver::RigidBody &body : study.rigid_bodies)
      names.push_back(force_column(body));
  if (study.method.model == ModelKind::reduced)
    std::erase_if(names, is_stress);
  return names;
}

std::vector<std::string> response_names(const Study &study)
{
  if (study.method.model == ModelKind::both)
    return names_of_both(study);
  std::vector<std::string> names;
  for (const std::string &column : history_columns(study))
    for (const char *suffix : {"", "_max", "_min"})
      names.push_back(column + suffix);
  if (study.actuator.kind == ActuatorKind::pebs && study.actuator.pebs.with_balloon)
    names.emplace_back("window_angle_deg");
  for (const std::string &name : margin_names(study))
    names.push_back(name);
  return names;
}

} // namespace ballonet::studies
