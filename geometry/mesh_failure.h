// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

namespace ballonet::geometry
{

/// Two parameters that do not go together. Keys are those of the actuator's (or the mesh sizes') fields, with dots:
/// "ribs.width", "mesh.symmetry". key_b is empty when one value is wrong by itself.
struct Problem {
  std::string key_a, key_b, message;
};

/// Why there is no mesh: a reason for the reader and, when the input is to blame, the parameters.
struct MeshFailure {
  std::string reason;
  std::vector<Problem> problems;
};

} // namespace ballonet::geometry
