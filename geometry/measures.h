// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/mesh.h"

namespace ballonet::geometry
{

/// Volume of one cell, mm^3 (27 Gauss points).
double cell_volume(const Mesh &mesh, std::size_t cell);

/// Volume of a body, mm^3. Throws std::invalid_argument if the mesh has no such body.
double volume(const Mesh &mesh, const std::string &body);

/// Area of a surface, mm^2 (9 Gauss points a face). Throws std::invalid_argument if the mesh has no such surface.
double area(const Mesh &mesh, const std::string &surface);

} // namespace ballonet::geometry
