// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/elastica.h"
#include <cmath>

namespace ballonet::tests
{

namespace
{

/// End of a cantilever along the arc s in [0, 1] with theta'' = -alpha cos theta, by Runge-Kutta from a clamp with the
/// curvature `bend`; returns theta' at the tip, which must vanish.
double shoot(double alpha, double bend, Tip &tip)
{
  constexpr int steps = 2000;
  const double h = 1. / steps;
  double y[4] = {0, bend, 0, 0}; // theta, theta', x, y
  const auto rate = [alpha](const double *v, double *r) {
    r[0] = v[1], r[1] = -alpha * std::cos(v[0]), r[2] = std::cos(v[0]), r[3] = std::sin(v[0]);
  };
  for (int i = 0; i < steps; ++i) {
    double k[4][4], at[4];
    rate(y, k[0]);
    for (int stage = 1; stage < 4; ++stage) {
      for (int j = 0; j < 4; ++j)
        at[j] = y[j] + (stage == 3 ? h : h / 2) * k[stage - 1][j];
      rate(at, k[stage]);
    }
    for (int j = 0; j < 4; ++j)
      y[j] += h / 6 * (k[0][j] + 2 * k[1][j] + 2 * k[2][j] + k[3][j]);
  }
  tip = {y[2], y[3]};
  return y[1];
}

} // namespace

Tip elastica(double alpha)
{
  Tip tip;
  double low = 0, high = alpha;
  while (high - low > 1e-13) {
    const double middle = (low + high) / 2;
    (shoot(alpha, middle, tip) > 0 ? high : low) = middle;
  }
  return tip;
}

} // namespace ballonet::tests
