// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/mesh.h"
#include <optional>

namespace ballonet::geometry
{

struct QualityLimits {
  double smallest_jacobian = 0.1;
  double largest_aspect = 15;
};

/// Scaled Jacobian at the 27 Gauss points and aspect ratio, worst over all cells. A cell with a Jacobian <= 0 anywhere
/// counts with a value <= 0.
Quality measure_quality(const Mesh &mesh);

/// The reason why a mesh of this quality is not accepted (names body and position of the cell), nothing if it is.
std::optional<std::string> rejection(const Mesh &mesh, const Quality &quality, const QualityLimits &limits);

} // namespace ballonet::geometry
