// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_surface.h"

namespace ballonet::solver::contact
{

/// Where a patch feels the contact. Each point carries the area of the real face around it, times `share`; so a patch
/// that is trimmed to a line or a point at a convex edge weighs as much as the face it stands for.

/// `per_side` x `per_side` Gauss points.
std::vector<QuadraturePoint> gauss_points(const Mesh &, const Patch &, int per_side, double share);

/// Points `spacing` (mm at rest) or less apart that include the sides and corners at which the patch is trimmed: what
/// lies between the Gauss points of the other surface, an edge or a corner, is felt here.
std::vector<QuadraturePoint> points_with_edges(const Mesh &, const Patch &, double spacing, double share);

} // namespace ballonet::solver::contact
