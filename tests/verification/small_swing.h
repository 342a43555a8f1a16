// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/equilibrium.h"

namespace ballonet::tests
{

/// What a small free motion in one mode looks like.
struct Swing {
  double frequency;     ///< Hz
  double damping_ratio; ///< of critical, from the decrease of the peaks
};

/// Lets a body go that is displaced from `state`, where it is in equilibrium, by `amplitude` (mm) of a mode, and
/// follows it through `periods` periods in steps of the `steps`-th part of one. Times and heights of peaks are
/// interpolated with parabolas.
Swing small_swing(solver::Equilibrium &equilibrium, const solver::State &state, const solver::Mode &mode,
                  double amplitude, int periods, int steps);

} // namespace ballonet::tests
