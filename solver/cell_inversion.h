// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_patch.h"
#include <optional>

namespace ballonet::solver::contact
{

using CellNodes = std::array<Point3, 27>;

/// Reference coordinates in [0, 1]^3 of the point x of a 27-node cell by Newton's method, or nothing when x is outside.
std::optional<Point3> local_coordinates(const CellNodes &, const Point3 &x);

} // namespace ballonet::solver::contact
