// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/block_mesh.h"

namespace ballonet::geometry
{

/// "rib_01" from "rib_" and 0: parts are counted from 1 in names.
std::string numbered(const std::string &stem, int index);

/// The named surfaces of a tagged mesh, from the part and the side of every free face. Free faces in the plane y = 0
/// of a half model are "symmetry" and nothing else. What can touch the balloon of the backbone is "backbone_contact",
/// the rest of it but for the clamped bottom "backbone_outside".
std::vector<Surface> name_surfaces(const TaggedMesh &tagged, bool half);

} // namespace ballonet::geometry
