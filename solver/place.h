// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/mesh.h"
#include "solver/parameters.h"
#include "solver/types.h"

namespace ballonet::solver
{

/// A node in words: where it is (mm), in which body and element, on which surfaces of contact pairs.
std::string place_of(const Mesh &, Node, const State &, const std::vector<ContactPair> &);

} // namespace ballonet::solver
