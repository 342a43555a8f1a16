// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/mesh.h"
#include "geometry/mesh_failure.h"
#include <filesystem>
#include <optional>
#include <variant>

namespace ballonet::geometry
{

/// Writes a gmsh file (MSH 4.1, binary, 27-node hexahedra and 9-node quadrilaterals). Bodies are physical volumes,
/// surfaces physical surfaces, sets of nodes physical points. Nothing on success.
std::optional<MeshFailure> write_msh(const Mesh &mesh, const std::filesystem::path &path);

/// Reads a mesh of hexahedra with 8, 20 or 27 nodes; missing middle nodes are put where the element's own interpolation
/// has them. Every hexahedron must be in one named physical volume; named physical surfaces must lie on the boundary.
/// Named physical curves and points become sets of nodes. Failures: no such file, unreadable, no hexahedra, other
/// volume elements, unnamed groups, folded cells.
std::variant<Mesh, MeshFailure> read_msh(const std::filesystem::path &path);

} // namespace ballonet::geometry
