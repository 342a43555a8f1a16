// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/parameters.h"
#include "tests/support/box_mesh.h"
#include <cmath>

namespace ballonet::tests
{

/// The half of a clamped shallow arch (span 20, rise 2, thickness 0.5 mm, plane strain) with gas above it, whose rising
/// pressure snaps it through. Viscous.
struct ShallowArch {
  solver::Mesh mesh = box_mesh(8, 1, 1, [](Point3 p) {
    const double height = 1 - std::cos(M_PI * p[0]); // 0 at the clamp, 2 at the middle
    return Point3{10 * p[0], height + 0.5 * p[1], p[2]};
  });
  solver::Parameters parameters;

  ShallowArch()
  {
    parameters.materials.resize(1);
    auto &m = parameters.materials[0];
    m.name = "plastic", m.law = solver::Law::saint_venant;
    m.youngs_modulus = 100, m.poisson_ratio = 0.3, m.relaxation_time = 5e-3;
    parameters.bodies = {{"body", "plastic"}};
    parameters.supports = {{"x0", {"x", "y", "z"}}, {"x1", {"x"}}, {"z0", {"z"}}, {"z1", {"z"}}};
    parameters.cavity = solver::Cavity{"y1", {0, 10, 0}, {"y"}};
    parameters.newton = {.tolerance = 1e-11, .force_floor = 1e-3};
    auto &path = parameters.path;
    path.control = solver::Control::pressure;
    path.preload_steps = 1;
    path.pressure_rate = 1, path.step_initial = 2e-3, path.step_max = 5e-3; // MPa/s, s
    path.pressure_max = 0.12;
  }
};

} // namespace ballonet::tests
