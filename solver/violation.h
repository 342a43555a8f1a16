// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/parameters.h"
#include "solver/types.h"

namespace ballonet::solver
{

/// A node that lies where a converged state must not have it: inside another body, beyond its wall, in a rigid body, or
/// inside another part of its own body.
struct Violation {
  Node node;
  Vector3 position; ///< mm
  double depth;     ///< mm, distance to the surface it went through
  std::string body; ///< the body it got into
};

} // namespace ballonet::solver
