// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/surface_export.h"
#include "geometry/measures.h"
#include "tests/geometry/built_mesh.h"
#include "tests/geometry/scratch_file.h"
#include <fstream>
#include <map>
#include <set>

using namespace ballonet::geometry;

namespace
{

using Corner = std::array<float, 3>;

/// What an STL file says, read independently of the writer.
std::vector<std::array<Corner, 3>> read_stl(const std::filesystem::path &path)
{
  std::ifstream in(path, std::ios::binary);
  std::array<char, 80> header{};
  std::uint32_t count = 0;
  in.read(header.data(), header.size()).read(reinterpret_cast<char *>(&count), 4);
  std::vector<std::array<Corner, 3>> triangles(count);
  for (auto &triangle : triangles) {
    Corner normal{};
    std::uint16_t attribute = 1;
    in.read(reinterpret_cast<char *>(&normal), 12);
    in.read(reinterpret_cast<char *>(&triangle), 36);
    in.read(reinterpret_cast<char *>(&attribute), 2);
    REQUIRE(attribute == 0);
  }
  REQUIRE(in.good());
  in.get();
  REQUIRE(in.eof());
  return triangles;
}

/// Every edge is used once in each direction.
void check_manifold(const std::vector<std::array<Corner, 3>> &triangles)
{
  std::map<std::pair<Corner, Corner>, int> edges;
  for (const auto &t : triangles)
    for (unsigned i = 0; i < 3; ++i)
      ++edges[{t[i], t[(i + 1) % 3]}];
  for (const auto &[edge, uses] : edges) {
    REQUIRE(uses == 1);
    REQUIRE(edges.contains({edge.second, edge.first}));
  }
}

} // namespace

TEST_CASE("the exported part is closed, manifold and has the mesh's volume")
{
  MeshSizes sizes;
  sizes.symmetry = GENERATE(true, false);
  const Mesh mesh = built(Pebs{}, sizes).mesh;
  const double expected = volume(mesh, "backbone") * (sizes.symmetry ? 2 : 1);
  CHECK(enclosed_volume(triangulate_surface(mesh, "backbone")) == Approx(expected).epsilon(5e-3));
  const ScratchFile file("part.stl");
  REQUIRE_FALSE(write_stl(mesh, "backbone", file.path));
  check_manifold(read_stl(file.path));
}

TEST_CASE("patterns of ribs stay printable")
{
  Pebs pebs = short_pebs();
  SECTION("open") { pebs.ribs.arc = {200}; }
  SECTION("twisted") { pebs.ribs.orientation = {0, 8, 16}; }
  SECTION("turned") { pebs.ribs.orientation = {0, 90, 90}; }
  SECTION("thick lands") { pebs.wall.thick_land = true; }
  const Mesh mesh = built(pebs, full_model()).mesh;
  const ScratchFile file("pattern.stl");
  REQUIRE_FALSE(write_stl(mesh, "backbone", file.path));
  check_manifold(read_stl(file.path));
}

TEST_CASE("half and full model export the same number of triangles")
{
  const auto half = triangulate_surface(built(short_pebs(), {}).mesh, "backbone");
  const auto full = triangulate_surface(built(short_pebs(), full_model()).mesh, "backbone");
  CHECK(half.size() == full.size());
  CHECK(enclosed_volume(half) == Approx(enclosed_volume(full)));
}

TEST_CASE("exports that are not possible say so")
{
  const Mesh mesh = built(short_pebs(), {}).mesh;
  CHECK(write_step(mesh, "backbone", "part.step")->reason == "STEP export is not available yet");
  CHECK(write_stl(mesh, "backbone", "/nonexistent_folder/part.stl")->reason ==
        "cannot write /nonexistent_folder/part.stl");
  CHECK_THROWS_AS(triangulate_surface(mesh, "hull"), std::invalid_argument);
}
