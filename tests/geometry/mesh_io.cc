// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/mesh_io.h"
#include "geometry/content_hash.h"
#include "geometry/gmsh_session.h"
#include "geometry/measures.h"
#include "geometry/node_order.h"
#include "tests/geometry/built_mesh.h"
#include "tests/geometry/scratch_file.h"
#include <fstream>
#include <gmsh.h>
#include <numbers>

using namespace ballonet::geometry;

namespace
{

/// What a user's file shall contain.
struct Sector {
  int order = 1;
  bool incomplete = false; // 20 nodes instead of 27
  bool hexahedra = true, named_volume = true, named_surface = true;
};

/// A quarter of a ring, radii 1 and 2, height 1, as a user would mesh it with gmsh.
void write_sector(const std::filesystem::path &path, const Sector &sector)
{
  const auto reason = in_gmsh([&] {
    const int point = gmsh::model::geo::addPoint(1, 0, 0);
    gmsh::vectorpair line, face, volume;
    gmsh::model::geo::extrude({{0, point}}, 1, 0, 0, line, {2}, {}, true);
    gmsh::model::geo::extrude({line[1]}, 0, 0, 1, face, {2}, {}, sector.hexahedra);
    gmsh::model::geo::revolve({face[1]}, 0, 0, 0, 0, 0, 1, std::numbers::pi / 2, volume, {4}, {}, sector.hexahedra);
    gmsh::model::geo::synchronize();
    const int body = gmsh::model::addPhysicalGroup(3, {volume[1].second});
    const int start = gmsh::model::addPhysicalGroup(2, {face[1].second});
    gmsh::model::setPhysicalName(1, gmsh::model::addPhysicalGroup(1, {line[1].second}), "radius");
    gmsh::model::setPhysicalName(0, gmsh::model::addPhysicalGroup(0, {point}), "corner");
    if (sector.named_volume)
      gmsh::model::setPhysicalName(3, body, "sector");
    if (sector.named_surface)
      gmsh::model::setPhysicalName(2, start, "start");
    gmsh::option::setNumber("Mesh.SecondOrderIncomplete", sector.incomplete ? 1 : 0);
    gmsh::model::mesh::generate(3);
    gmsh::model::mesh::setOrder(sector.order);
    gmsh::write(path.string());
  });
  REQUIRE(reason.value_or("") == "");
}

std::string reason_of(const std::variant<Mesh, MeshFailure> &result)
{
  const auto *failure = std::get_if<MeshFailure>(&result);
  return failure == nullptr ? "" : failure->reason;
}

} // namespace

TEST_CASE("a mesh survives the round trip through a gmsh file unchanged")
{
  const ScratchFile file("round_trip.msh");
  Mesh mesh = built(short_pebs(), {}).mesh;
  mesh.node_sets = {{"point", {7}}, {"line", {3, 20, 100}}};
  REQUIRE_FALSE(write_msh(mesh, file.path));
  const auto result = read_msh(file.path);
  REQUIRE(reason_of(result) == "");
  const Mesh &back = std::get<Mesh>(result);
  CHECK(back.nodes == mesh.nodes);
  CHECK(back.cells == mesh.cells);
  CHECK(content_hash(back) == content_hash(mesh));
}

TEST_CASE("gmsh finds positive Jacobians and the same volume in our file")
{
  const ScratchFile file("jacobians.msh");
  const Mesh mesh = built(short_pebs(), {}).mesh;
  REQUIRE_FALSE(write_msh(mesh, file.path));
  double smallest = 1e30, sum = 0;
  const auto reason = in_gmsh([&] {
    gmsh::open(file.path.string());
    std::vector<double> points, weights, jacobians, determinants, coordinates;
    gmsh::model::mesh::getIntegrationPoints(gmsh_type::hex27, "Gauss16", points, weights);
    gmsh::model::mesh::getJacobians(gmsh_type::hex27, points, jacobians, determinants, coordinates);
    for (std::size_t i = 0; i < determinants.size(); ++i) {
      smallest = std::min(smallest, determinants[i]);
      sum += weights[i % weights.size()] * determinants[i];
    }
  });
  REQUIRE(reason.value_or("") == "");
  CHECK(smallest > 0);
  CHECK(sum == Approx(volume(mesh, "balloon") + volume(mesh, "backbone")).epsilon(1e-9));
}

TEST_CASE("hexahedra of 8, 20 and 27 nodes are read and completed")
{
  const ScratchFile file("sector.msh");
  const double curved = std::numbers::pi / 4 * 3, straight = 4 * 1.5 * std::sin(std::numbers::pi / 8);
  const auto [order, incomplete, expected] =
      GENERATE_COPY(std::tuple(1, false, straight), std::tuple(2, true, curved), std::tuple(2, false, curved));
  write_sector(file.path, {order, incomplete});
  const auto result = read_msh(file.path);
  REQUIRE(reason_of(result) == "");
  const Mesh &mesh = std::get<Mesh>(result);
  CHECK(mesh.cells.size() == 16);
  CHECK(mesh.nodes.size() == 5 * 5 * 9);
  CHECK(mesh.bodies.at(0).name == "sector");
  CHECK(volume(mesh, "sector") == Approx(expected).epsilon(1e-3));
  CHECK(area(mesh, "start") == Approx(1));
  REQUIRE(mesh.node_sets.size() == 2);
  CHECK(mesh.node_sets[0].name == "radius");
  REQUIRE(mesh.node_sets[0].nodes.size() == 5); // two edges with their middle nodes, whatever the file had
  for (const auto node : mesh.node_sets[0].nodes)
    CHECK(std::hypot(mesh.nodes[node][1], mesh.nodes[node][2]) < 1e-12);
  CHECK(mesh.node_sets[1].name == "corner");
  REQUIRE(mesh.node_sets[1].nodes.size() == 1);
  CHECK(mesh.nodes[mesh.node_sets[1].nodes[0]] == Point{1, 0, 0});
}

TEST_CASE("files that cannot be used are refused with the reason")
{
  const ScratchFile file("refused.msh");
  CHECK(reason_of(read_msh(file.path)).find("there is no file") != std::string::npos);

  Sector tetrahedra, nameless, nameless_surface;
  tetrahedra.hexahedra = false;
  nameless.named_volume = false;
  nameless_surface.named_surface = false;
  write_sector(file.path, tetrahedra);
  CHECK(reason_of(read_msh(file.path)).find("volume elements of type \"Tetrahedron") != std::string::npos);
  write_sector(file.path, nameless);
  CHECK(reason_of(read_msh(file.path)).find("physical volume 1 has no name") != std::string::npos);
  write_sector(file.path, nameless_surface);
  CHECK(reason_of(read_msh(file.path)).find("physical surface 2 has no name") != std::string::npos);

  std::ofstream(file.path) << "this is not a mesh\n";
  CHECK_FALSE(reason_of(read_msh(file.path)).empty());
}

TEST_CASE("a path that cannot be written is a failure, not an exception")
{
  const auto failure = write_msh(built(short_pebs(), {}).mesh, "/nonexistent_folder/mesh.msh");
  REQUIRE(failure);
  CHECK(failure->reason.find("cannot write") != std::string::npos);
}
