// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/snap_through.h"
#include <cmath>

namespace ballonet::studies
{
namespace
{

SnapSide side(const PathState &state) { return {state.pressure, state.angle, state.volume, state.bulge}; }

/// The state between `a` and `b`, a.pressure < pressure <= b.pressure, on the line through them.
SnapSide at_pressure(double pressure, const PathState &a, const PathState &b)
{
  const double t = (pressure - a.pressure) / (b.pressure - a.pressure);
  return {pressure, std::lerp(a.angle, b.angle, t), std::lerp(a.volume, b.volume, t), std::lerp(a.bulge, b.bulge, t)};
}

} // namespace

std::vector<SnapThrough> snap_throughs(const std::vector<PathState> &path, double drop)
{
  std::vector<SnapThrough> snaps;
  std::size_t peak = 0;
  bool fallen = false;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double top = path[peak].pressure;
    if (path[i].pressure >= top) {
      if (fallen)
        snaps.push_back({side(path[peak]), at_pressure(top, path[i - 1], path[i]), true});
      peak = i;
      fallen = false;
    } else if (top > 0 && top - path[i].pressure > drop * top) {
      fallen = true;
    }
  }
  if (fallen)
    snaps.push_back({side(path[peak]), side(path.back()), false});
  return snaps;
}

} // namespace ballonet::studies
