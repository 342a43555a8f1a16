// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

namespace ballonet::solver
{

/// Whether a path goes in static steps, from equilibrium to equilibrium, or in motion: in steps that viscosity, mass
/// and the speed of sliding regularise. It is set in motion where a static step is not found. From then on it is
/// brought to rest every few steps, and goes on in static steps after a number of successful rests that doubles with
/// every static step that is not found.
struct Regularisation {
  bool moving = false;
  int steps_to_rest = 0; ///< in motion, before the next search for rest
  int rests_to_go = 0;   ///< to be found before the next static step
  int caution = 1;       ///< their number next time
  int pause = 1;         ///< how many times longer than usual the search for rest waits: doubled with each in vain

  bool seeks_rest() const { return moving && steps_to_rest <= 0; }

  /// A static step was taken.
  void stayed_at_rest();
  /// No static step was found; `rest_every` steps in motion lie between two searches for rest.
  void set_in_motion(int rest_every);
  /// A step in motion was taken.
  void moved() { --steps_to_rest; }
  /// The search for rest has ended.
  void sought_rest(bool found, int rest_every);
};

} // namespace ballonet::solver
