// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/path_states.h"

namespace ballonet::studies
{

/// A state at one side of a snap-through.
struct SnapSide {
  double pressure = 0; ///< kPa
  double angle = 0;    ///< bending angle, deg
  double volume = 0;   ///< mm^3
  double bulge = 0;    ///< mm

  bool operator==(const SnapSide &) const = default;
};

/// What happens at a limit point of the pressure to someone who raises it slowly: the states up to the next one at the
/// same pressure are skipped by a jump.
struct SnapThrough {
  SnapSide before; ///< at the limit point
  SnapSide after;  ///< back at its pressure, between two states of the path; the last state if it never gets there
  bool recovered = false; ///< whether the path gets there

  bool operator==(const SnapThrough &) const = default;
};

/// The snap-throughs of a path in its order. `drop`: smallest fall of the pressure, as a share, that is one.
std::vector<SnapThrough> snap_throughs(const std::vector<PathState> &path, double drop);

} // namespace ballonet::studies
