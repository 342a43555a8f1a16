// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/pebs_mesh.h"
#include <catch2/catch.hpp>

namespace ballonet::geometry
{

/// The mesh of a design that must be meshable.
template <class Actuator>
PebsMesh built(const Actuator &actuator, const MeshSizes &sizes)
{
  auto result = build_mesh(actuator, sizes);
  if (const auto *failure = std::get_if<MeshFailure>(&result))
    FAIL(failure->reason);
  return std::get<PebsMesh>(std::move(result));
}

inline MeshSizes full_model()
{
  MeshSizes sizes;
  sizes.symmetry = false;
  return sizes;
}

/// Three ribs and a short balloon.
inline Pebs short_pebs()
{
  Pebs pebs;
  pebs.ribs.count = 3;
  pebs.balloon.length = 10;
  return pebs;
}

} // namespace ballonet::geometry
