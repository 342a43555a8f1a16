// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace ballonet::tests
{

/// Where the tip of a cantilever along x goes, relative to its length.
struct Tip {
  double x, y;
};

/// Euler's elastica under a dead end force P in y, alpha = P L^2 / (E I), by Runge-Kutta and shooting.
Tip elastica(double alpha);

} // namespace ballonet::tests
