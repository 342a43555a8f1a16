// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/mesh.h"
#include "solver/parameters.h"
#include <iosfwd>

namespace ballonet::tests
{

/// Writes a problem under load control as input of CalculiX: the same hexahedra without their face and cell centres,
/// the same material, supports and loads, and the same first step with automatic ones after it.
/// `element`: C3D20 or C3D20R. `bulk_ratio`: bulk over shear modulus of rubber in place of the problem's own, if
/// positive. The displacements of all nodes at the end go to the .dat file. Faces with a dead traction must be
/// parallelograms.
void write_calculix_input(std::ostream &, const solver::Mesh &, const solver::Parameters &, const std::string &element,
                          double bulk_ratio = 0);

} // namespace ballonet::tests
