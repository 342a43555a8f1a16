// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <array>
#include <cstdint>
#include <vector>

namespace ballonet::studies
{

using Point = std::array<double, 3>;
using Rotation = std::array<std::array<double, 3>, 3>; ///< rows

/// The rigid motion x = centre + rotation (X - reference_centre) that comes nearest to a deformation of some nodes.
struct RigidFrame {
  Point reference_centre = {0, 0, 0}, centre = {0, 0, 0};
  Rotation rotation = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

  /// Where a point of the undeformed space goes.
  Point map(const Point &reference) const;
  /// Which point of the undeformed space goes there.
  Point pull_back(const Point &present) const;
  /// Where a direction of the undeformed space goes.
  Point turn(const Point &direction) const;
  /// Where the direction of the axis (z) goes.
  Point normal() const { return turn({0, 0, 1}); }
};

/// Least-squares rigid motion of `nodes`. `symmetric`: the nodes are those at y >= 0 of a body that is mirrored in
/// y = 0; the frame is the one of the whole. Rotation: orthogonal polar factor of the covariance, by the scaled Newton
/// iteration of N. J. Higham, SIAM J. Sci. Stat. Comput. 7 (1986) 1160-1174.
/// Throws std::invalid_argument if the nodes do not span the space.
RigidFrame best_fit(const std::vector<Point> &reference, const std::vector<Point> &deformed,
                    const std::vector<std::uint32_t> &nodes, bool symmetric);

/// Angles of a rotation R = R_y(-bending) R_x(-out_of_plane) R_z(twist), deg. Bending is positive towards -x, out of
/// plane towards +y, twist is right-handed about the turned axis. Bending in (-180, 180].
struct FrameAngles {
  double bending, out_of_plane, twist;
};
FrameAngles angles(const Rotation &rotation);

/// transpose(a) b: the rotation b seen from a.
Rotation relative_rotation(const Rotation &a, const Rotation &b);

/// `angle` plus whole turns of 360 deg, as near to `previous` as possible.
double unwrapped(double angle, double previous);

} // namespace ballonet::studies
