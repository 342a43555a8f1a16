// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/mesh.h"
#include "solver/parameters.h"

/// Cook's membrane, nearly incompressible at finite strain (de Souza Neto et al. 1996): a tapered panel, clamped at
/// x = 0, sheared by a dead load at x = 48 mm, in plane strain.
namespace ballonet::tests
{

/// Vertical displacement of the tip on 128 x 128 cells (Elguedj et al. 2008, as quoted by FinEALE), mm.
constexpr double cook_deflection = 6.9083;

/// Corners (0, 0), (48, 44), (48, 60), (0, 44), n x n cells and one of 1 mm in z.
solver::Mesh cook_panel(int n);

/// Material, supports and load of 100 N per mm of thickness, in two steps.
solver::Parameters cook_parameters();

/// Node at the corner (48, 60, 0).
std::uint32_t cook_tip(const solver::Mesh &);

} // namespace ballonet::tests
