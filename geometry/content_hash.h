// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/mesh.h"

namespace ballonet::geometry
{

/// FNV-1a hash (64 bit) of nodes, cells, bodies and surfaces: equal for equal meshes.
/// Source: Fowler, Noll, Vo, "The FNV Non-Cryptographic Hash Algorithm", IETF draft.
std::uint64_t content_hash(const Mesh &mesh);

} // namespace ballonet::geometry
