// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/mesh.h"

namespace ballonet::geometry
{

/// Node numbers of a face of the mesh, in the order of face_nodes().
std::array<std::uint32_t, 9> nodes_of(const Mesh &mesh, const Face &face);

/// The faces that belong to one cell only, by cell and local number. Cells of different bodies share no nodes.
std::vector<Face> free_faces(const Mesh &mesh);

/// The surface of that name, nullptr if there is none.
const Surface *find_surface(const Mesh &mesh, const std::string &name);

} // namespace ballonet::geometry
