// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/linear_system.h"
#include "solver/parameters.h"

namespace ballonet::solver
{

/// A small motion exp(i omega t) about an equilibrium, without damping: K shape = omega^2 M shape.
struct Mode {
  double omega_squared = 0;  ///< 1/s^2; negative: the motion grows
  std::vector<double> shape; ///< three per node in mesh order, scaled so that the node that moves most moves by 1

  /// Hz; zero for a motion that grows.
  double frequency() const;
  /// 1/s, of a motion that grows like exp(growth_rate t); zero for an oscillation.
  double growth_rate() const;
};

/// Which modes are wanted.
struct ModeRequest {
  int count = 6;
  bool volume_held = false; ///< of the cavity: the shapes keep it; else its pressure is held
  bool by_volume = false;   ///< the mass is the volume at rest, as if every density were 1; omega^2 is in MPa/mm^2 then
  /// s; length of the time step whose viscosity stiffens the tangent. At infinity there is none: the modes of the
  /// elastic body, its contacts sticking as far as friction has not given way. With a step's dt the modes are those
  /// whose negative ones the step's negative pivots count.
  double dt = infinity;
};

/// The modes of the factorised tangent K of `system` with the lowest omega^2, ascending; fewer where the body has not
/// as many. `mass`: t, of every node, summed over the ranks. `volume_gradient`: G = dV/du without held entries, where
/// shapes shall keep the volume (G . shape = 0), else null. Krylov-Schur iteration (SLEPc) on the inverse, which has
/// the lowest modes at its two ends: the negative ones, whose number the negative pivots tell, and the others.
/// Collective. Throws std::runtime_error when it does not converge.
std::vector<Mode> lowest_modes(LinearSystem &system, const std::vector<double> &mass, Vec volume_gradient, int count);

} // namespace ballonet::solver
