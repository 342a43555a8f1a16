// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/mesh.h"
#include <string>

namespace ballonet::tests
{

/// A quarter (x, y >= 0) of a tube along z with radii `inner` and `outer`, mm; surfaces x0, y0 (symmetry planes),
/// z0, z1, inner, outer, each with `prefix` in front.
solver::Mesh quarter_tube(double inner, double outer, double length, int through, int around, int along,
                          const std::string &body = "body", const std::string &prefix = "");

/// A whole tube along z, with its mesh lines along helices that turn by `pitch` rad/mm; surfaces z0, z1, inner, outer.
solver::Mesh whole_tube(double inner, double outer, double length, int through, int around, int along,
                        double pitch = 0);

/// An eighth (x, y, z >= 0) of a hollow sphere: three blocks of around x around x through cells; surfaces x0, y0, z0
/// (symmetry planes), inner, outer.
solver::Mesh eighth_sphere(double inner, double outer, int through, int around);

/// Puts nodes within 1e-7 mm together, and surfaces and bodies of the same name.
solver::Mesh merged(const solver::Mesh &);

} // namespace ballonet::tests
