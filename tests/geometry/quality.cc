// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/quality.h"
#include "geometry/measures.h"
#include "tests/geometry/built_mesh.h"

using namespace ballonet::geometry;

namespace
{

/// One brick of the given edges.
Mesh brick(double a, double b, double c)
{
  Mesh mesh;
  mesh.bodies = {{"brick"}};
  mesh.cell_body = {0};
  mesh.cells.resize(1);
  for (std::uint32_t i = 0; i < 27; ++i) {
    mesh.nodes.push_back({a * (i % 3) / 2, b * (i / 3 % 3) / 2, c * (i / 9) / 2});
    mesh.cells[0][i] = i;
  }
  return mesh;
}

} // namespace

TEST_CASE("a brick has scaled Jacobian 1 and the aspect ratio of its edges")
{
  const Mesh mesh = brick(1, 2, 5);
  const Quality quality = measure_quality(mesh);
  CHECK(quality.smallest_scaled_jacobian == Approx(1));
  CHECK(quality.largest_aspect_ratio == Approx(5));
  CHECK(volume(mesh, "brick") == Approx(10));
  CHECK_FALSE(rejection(mesh, quality, {0.5, 6}));
  const auto reason = rejection(mesh, quality, {0.5, 4});
  REQUIRE(reason);
  CHECK(*reason == "aspect ratio 5 above 4 in body \"brick\" at (0.5, 1, 2.5) mm");
}

TEST_CASE("a pulled and a folded cell are rejected")
{
  Mesh mesh = brick(1, 1, 1);
  mesh.nodes[26] = {0.85, 0.85, 0.85};
  const Quality pulled = measure_quality(mesh);
  CHECK(pulled.smallest_scaled_jacobian < 0.5);
  CHECK(rejection(mesh, pulled, {0.5, 10})->find("scaled Jacobian") == 0);
  mesh = brick(1, 1, 1);
  for (Point &node : mesh.nodes)
    node[0] = -node[0];
  CHECK(rejection(mesh, measure_quality(mesh), {0, 10})->find("a cell is folded") == 0);
}

TEST_CASE("a mesh below the limits is a reason, not a mesh")
{
  MeshSizes strict;
  strict.smallest_jacobian = 0.9;
  const auto result = build_mesh(short_pebs(), strict);
  const auto *failure = std::get_if<MeshFailure>(&result);
  REQUIRE(failure != nullptr);
  CHECK(failure->problems.empty());
  CHECK(failure->reason.find("below 0.9 in body \"") != std::string::npos);
}

TEST_CASE("the default mesh is good")
{
  Pebs thin;
  thin.wall.thickness = 0.8; // the reference wall
  const Quality quality = built(thin, {}).mesh.quality;
  CHECK(quality.smallest_scaled_jacobian > 0.25);
  CHECK(quality.largest_aspect_ratio < 6);
  const Quality trimmed = built(Pebs{}, {}).mesh.quality; // a thicker wall bends its folds more sharply
  CHECK(trimmed.smallest_scaled_jacobian > 0.22);
  CHECK(trimmed.largest_aspect_ratio < 7);
}
