// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/mesh_failure.h"
#include "geometry/rib_pattern.h"

namespace ballonet::geometry
{

/// The key that says where the ribs are: "ribs.position" if it is given, else "ribs.gap".
const char *place_key(const Ribs &ribs);

/// What cannot be built about ribs and wall: ribs that meet, folds too sharp for the wall, lands that do not fit. The
/// first rib or gap of each kind is reported.
std::vector<Problem> check_cage(const Pebs &pebs, const RibPattern &pattern);

} // namespace ballonet::geometry
