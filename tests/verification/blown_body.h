// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/simulation.h"
#include <functional>

namespace ballonet::tests
{

struct BlownState {
  double volume_ratio, pressure; ///< V / V0, MPa
  int negative_pivots;           ///< of the tangent at held pressure
};

/// A nearly incompressible (bulk modulus 1e6 wall_mu) neo-Hookean body blown up by volume, quasi-static and without
/// viscosity; all steps of its path, at most `step` of V / V0 apart.
std::vector<BlownState> blow(const solver::Mesh &, const std::vector<solver::Support> &, const solver::Cavity &,
                             double volume_ratio, double step = 0.6);

/// int of f from a to b by Gauss' rule on many intervals.
double integral(const std::function<double(double)> &f, double a, double b);

} // namespace ballonet::tests
