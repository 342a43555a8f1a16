// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/mesh.h"
#include <functional>

namespace ballonet::tests
{

using Point3 = std::array<double, 3>;

/// nx x ny x nz cells on the unit cube, mapped by `map`; one body and the surfaces x0, x1, y0, y1, z0, z1 (each with
/// `prefix` in front).
solver::Mesh box_mesh(int nx, int ny, int nz, const std::function<Point3(Point3)> &map = {},
                      const std::string &body = "body", const std::string &prefix = "");

/// Puts b's bodies, surfaces and sets of nodes beside a's (no node is shared).
solver::Mesh beside(solver::Mesh a, const solver::Mesh &b);

/// Positions moved by an internal distortion that leaves the unit cube's faces plane.
Point3 distorted(Point3 x, double size);

} // namespace ballonet::tests
