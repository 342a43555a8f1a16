// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/mesh.h"
#include "geometry/mesh_failure.h"
#include <filesystem>
#include <optional>

namespace ballonet::geometry
{

/// Corners of a flat triangle, counter-clockwise seen from outside, mm.
using Triangle = std::array<Point, 3>;

/// The closed surface of a body: eight triangles per curved face. A half model (one with a surface "symmetry") is
/// completed by its mirror image. Throws std::invalid_argument if the mesh has no such body.
std::vector<Triangle> triangulate_surface(const Mesh &mesh, const std::string &body);

/// Volume inside a closed surface, mm^3.
double enclosed_volume(const std::vector<Triangle> &triangles);

/// Writes the part to print as binary STL (mm). Nothing on success.
std::optional<MeshFailure> write_stl(const Mesh &mesh, const std::string &body, const std::filesystem::path &path);

/// Not available: always a failure that says so.
std::optional<MeshFailure> write_step(const Mesh &mesh, const std::string &body, const std::filesystem::path &path);

} // namespace ballonet::geometry
