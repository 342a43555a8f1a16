// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/content_hash.h"
#include "tests/geometry/built_mesh.h"

using namespace ballonet::geometry;

TEST_CASE("an empty mesh has the FNV-1a hash of three empty lists")
{
  std::uint64_t expected = 14695981039346656037ULL;
  for (int byte = 0; byte < 24; ++byte)
    expected *= 1099511628211ULL;
  CHECK(content_hash(Mesh{}) == expected);
}

TEST_CASE("the same design has the same hash, any change another one")
{
  const Mesh mesh = built(short_pebs(), {}).mesh;
  const std::uint64_t hash = content_hash(mesh);
  CHECK(content_hash(built(short_pebs(), {}).mesh) == hash);
  Mesh moved = mesh, renamed = mesh, smaller = mesh, marked = mesh;
  moved.nodes[7][1] += 1e-12;
  renamed.surfaces[0].name += "x";
  smaller.surfaces[0].faces.pop_back();
  marked.node_sets = {{"point", {7}}};
  CHECK(content_hash(marked) != hash);
  CHECK(content_hash(moved) != hash);
  CHECK(content_hash(renamed) != hash);
  CHECK(content_hash(smaller) != hash);
}
