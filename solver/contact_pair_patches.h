// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_surface.h"
#include "solver/parameters.h"

namespace ballonet::solver::contact
{

/// The secondary patches of a contact pair (depth zero), then the primary ones (at the thickness), with their points
/// and neighbours. The area is shared by two passes, and by both roles of a face that touches itself. Throws
/// std::invalid_argument for impossible parameters and unknown surfaces.
std::vector<Patch> patches_of_pair(const Mesh &, const ContactPair &);

/// Whether bodies of the secondary patches (the first ones) have primary ones too.
bool touches_itself(const Mesh &, const std::vector<Patch> &, std::uint32_t n_secondary);

/// The distance of two patches, mm, found from the 3 x 3 nodes of the first.
double distance_of(const PatchNodes &from, const PatchNodes &to, const PatchRange &range);

/// Whether two faces look at each other: a point of each lies in front of one of the other, by more than a curved
/// surface rises over its own neighbourhood.
bool face_each_other(const PatchNodes &a, const Face &face_a, const PatchNodes &b, const Face &face_b);

} // namespace ballonet::solver::contact
