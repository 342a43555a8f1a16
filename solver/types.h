// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <cstdint>
#include <limits>
#include <vector>

namespace ballonet::solver
{

using Node = std::uint32_t;

/// Where the system is. Every rank holds all of it: a mesh has 1e4 to 1e5 nodes, and contact needs them all.
struct State {
  std::vector<double> displacement; ///< mm, three per node in mesh order
  std::vector<double> velocity;     ///< mm/s, likewise; of the last converged step
  std::vector<double> acceleration; ///< mm/s^2, likewise; zero where the step had no inertia
  std::vector<double> friction;     ///< MPa, traction at every contact point, likewise; pair after pair
  double pressure = 0;              ///< MPa, of the cavity
  double load_factor = 0;           ///< of gravity and loads
  double time = 0;                  ///< s of pseudo-time
  /// mm, of augmented contact, pair after pair: see contact_shift.h
  std::vector<double> contact_shift = {};
};

/// What one step is asked to reach.
struct Step {
  double dt = 0;          ///< s
  double load_factor = 1; ///< of gravity, loads and moved supports at the end of the step
  bool inertia = false;   ///< with mass
  bool rates = true;      ///< with viscosity and friction that feels the speed; without: a static step

  /// s; over which rates of strain and sliding are measured.
  double rate_time() const { return rates ? dt : std::numeric_limits<double>::infinity(); }
};

} // namespace ballonet::solver
