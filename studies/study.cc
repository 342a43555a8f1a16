// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/study.h"
#include <algorithm>
#include <stdexcept>

namespace ballonet::studies
{
namespace
{

constexpr double relaxation_time = 5e-3; // s; passes the localisation of the bulge without adding visible pressure

/// Latex of strip balloons: C10 = 160 kPa, D1 = 5.2e-4 / MPa, 1080 kg/m^3.
solver::Material latex()
{
  solver::Material m;
  m.name = "latex";
  m.c10 = 0.16;
  m.d1 = 5.2e-4;
  m.density = 1.08e-9;
  m.relaxation_time = relaxation_time;
  return m;
}

/// Printed TPU of Shore 94 A: E = 180 MPa, nu = 0.45, 1400 kg/m^3.
solver::Material tpu()
{
  solver::Material m;
  m.name = "tpu";
  m.law = solver::Law::saint_venant;
  m.youngs_modulus = 180;
  m.poisson_ratio = 0.45;
  m.density = 1.4e-9;
  m.relaxation_time = relaxation_time;
  return m;
}

} // namespace

Study default_study(ActuatorKind kind)
{
  Study study;
  study.actuator.kind = kind;
  if (kind == ActuatorKind::mesh)
    return study;
  study.gravity = {0, 0, -9810};
  study.materials = {latex()};
  study.path.pressure_max = study.judge.window_max;
  study.path.volume_max = 15;
  study.path.initial_pressure = 0.005; // keeps the empty balloon off a drooping cage
  if (kind == ActuatorKind::pebs)
    study.materials.push_back(tpu());
  return study;
}

const solver::Material &material_named(const Study &study, const std::string &name)
{
  const auto found = std::find_if(study.materials.begin(), study.materials.end(),
                                  [&](const solver::Material &material) { return material.name == name; });
  if (found == study.materials.end())
    throw std::invalid_argument("there is no material \"" + name + "\"");
  return *found;
}

} // namespace ballonet::studies
