// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/parameters.h"
#include "tests/support/round_mesh.h"

namespace ballonet::tests
{

/// A small case with all there is: a quarter of a soft mixed tube, blown up by volume against a stiff ring around its
/// lower half, with friction, viscosity and mass.
struct SealedTube {
  solver::Mesh mesh;
  solver::Parameters parameters;
  SealedTube();
};

} // namespace ballonet::tests
