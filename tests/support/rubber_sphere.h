// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/parameters.h"
#include "tests/support/round_mesh.h"

namespace ballonet::tests
{

/// An eighth of a thick neo-Hookean sphere (bulk modulus 1e6 mu; mm, MPa), free of loads.
struct RubberSphere {
  solver::Mesh mesh;
  solver::Parameters parameters;

  RubberSphere(double inner_radius, double outer_radius, double mu)
      : mesh(eighth_sphere(inner_radius, outer_radius, 2, 2))
  {
    parameters.materials.resize(1);
    auto &rubber = parameters.materials[0];
    rubber.name = "rubber", rubber.c10 = mu / 2, rubber.d1 = 2e-6 / mu;
    parameters.bodies = {{"body", "rubber", true}};
    parameters.supports = {{"x0", {"x"}}, {"y0", {"y"}}, {"z0", {"z"}}};
    parameters.newton.force_floor = 1e-3;
  }
};

} // namespace ballonet::tests
