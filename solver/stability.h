// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace ballonet::solver
{

/// Of an equilibrium: what its tangent K (of the elastic body, its contacts sticking as far as friction has not given
/// way) and the force F of a unit of the load parameter (pressure of the cavity, else load factor) say.
struct Stability {
  int negative_pivots = 0; ///< of K: unstable motions at held load parameter
  double compliance = 0;   ///< F . K^-1 F, of a cavity dV/dp in mm^3/MPa; zero without a load

  /// Unstable motions that keep the volume (without a cavity: the way of the load). By Sylvester's law of inertia for K
  /// bordered by F there is one less where the volume falls with growing pressure.
  int at_held_volume() const { return negative_pivots - (compliance < 0); }

  bool same_counts(const Stability &other) const
  {
    return negative_pivots == other.negative_pivots && at_held_volume() == other.at_held_volume();
  }
};

} // namespace ballonet::solver
