// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "tests/support/contact_scene.h"

namespace ballonet::tests
{

/// Two arms of one body along x, at y > gap / 2 and y < -gap / 2, each of five cells; their inner sides in contact.
struct TwoArms : ContactScene {
  static constexpr double gap = 0.5, arm = 2, wall = 0.4; // mm

  explicit TwoArms(int passes = 2)
  {
    add_block(mesh, "upper", {5, 1, 1}, [](auto p) {
      return std::array<double, 3>{arm * p[0], gap / 2 + wall * p[1], p[2]};
    });
    add_block(mesh, "lower", {5, 1, 1}, [](auto p) {
      return std::array<double, 3>{arm * p[0], -gap / 2 - wall * (1 - p[1]), p[2]};
    });
    mesh.bodies = {"fold"};
    mesh.cell_body.assign(mesh.cells.size(), 0);
    pair = {"pair", {"upper.y0", "lower.y1"}, {"upper.y0", "lower.y1"}, 0.3, 0.15, 9, 0.06};
    pair.passes = passes;
    state.displacement.assign(3 * mesh.nodes.size(), 0.);
  }

  /// Both arms moved towards the middle until they overlap by `depth`, slid by `slip` along x against each other.
  State closed(double depth, double slip = 0) const
  {
    State result = state;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
      const double side = mesh.nodes[n][1] > 0 ? 1 : -1;
      result.displacement[3 * n] = side * slip / 2;
      result.displacement[3 * n + 1] = -side * (gap + depth) / 2;
    }
    return result;
  }
};

} // namespace ballonet::tests
