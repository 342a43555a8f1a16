// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/parameters.h"
#include "tests/support/box_mesh.h"
#include <cmath>

namespace ballonet::tests
{

/// A slender cantilever along x, clamped at x0, with a rectangular section; N, mm, s, t.
struct CantileverBeam {
  double length, width = 1.5, height = 1; ///< width along y, height along z
  double modulus = 100, density = 1e-9;
  solver::Mesh mesh;
  solver::Parameters parameters; ///< gravity and loads: none

  explicit CantileverBeam(double length = 20, int along = 6)
      : length(length), mesh(box_mesh(along, 1, 1, [this](Point3 x) {
          return Point3{this->length * x[0], width * (x[1] - 0.5), height * (x[2] - 0.5)};
        }))
  {
    parameters.materials.resize(1);
    auto &m = parameters.materials[0];
    m.name = "plastic", m.law = solver::Law::saint_venant;
    m.youngs_modulus = modulus, m.poisson_ratio = 0, m.density = density;
    parameters.bodies = {{"body", "plastic"}};
    parameters.supports = {{"x0", {"x", "y", "z"}}};
    parameters.path.control = solver::Control::release;
    parameters.newton = {.tolerance = 1e-7, .force_floor = 1e-5};
  }

  /// Natural frequency of the n-th (0, 1) bending mode of Euler and Bernoulli's beam across a thickness, Hz.
  double bending_frequency(int n, double thickness) const
  {
    const double root[] = {1.8751040687119611, 4.6940911329741746}; // cos k cosh k = -1
    const double k = root[n] / length;
    return k * k * thickness * std::sqrt(modulus / (12 * density)) / (2 * M_PI);
  }
  /// The first longitudinal one, Hz.
  double axial_frequency() const { return std::sqrt(modulus / density) / (4 * length); }
};

} // namespace ballonet::tests
