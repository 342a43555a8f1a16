// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/surface_export.h"
#include "geometry/boundary.h"
#include "geometry/hexahedron.h"
#include <algorithm>
#include <bit>
#include <cmath>
#include <fstream>
#include <set>
#include <stdexcept>

namespace ballonet::geometry
{

namespace
{

static_assert(std::endian::native == std::endian::little, "binary STL is written as the numbers lie in memory");

std::uint32_t body_number(const Mesh &mesh, const std::string &name)
{
  for (std::uint32_t i = 0; i < mesh.bodies.size(); ++i)
    if (mesh.bodies[i].name == name)
      return i;
  throw std::invalid_argument("the mesh has no body \"" + name + "\"");
}

/// Two triangles for each quarter of the face's 3 x 3 nodes.
void add_face(std::vector<Triangle> &triangles, const Mesh &mesh, const Face &face)
{
  const auto nodes = nodes_of(mesh, face);
  const auto at = [&](unsigned i) { return mesh.nodes[nodes[i]]; };
  for (const unsigned corner : {0U, 1U, 3U, 4U}) {
    triangles.push_back({at(corner), at(corner + 1), at(corner + 4)});
    triangles.push_back({at(corner), at(corner + 4), at(corner + 3)});
  }
}

Point mirrored(const Point &p) { return {p[0], p[1] == 0 ? 0 : -p[1], p[2]}; }

void add_mirror_image(std::vector<Triangle> &triangles)
{
  const std::size_t count = triangles.size();
  for (std::size_t i = 0; i < count; ++i) {
    const auto [a, b, c] = triangles[i];
    triangles.push_back({mirrored(a), mirrored(c), mirrored(b)});
  }
}

std::array<float, 12> stl_record(const Triangle &triangle)
{
  Point normal = cross(difference(triangle[1], triangle[0]), difference(triangle[2], triangle[0]));
  const double length = std::sqrt(dot(normal, normal));
  std::array<float, 12> record{};
  for (unsigned d = 0; d < 3; ++d) {
    record[d] = static_cast<float>(length > 0 ? normal[d] / length : 0);
    for (unsigned corner = 0; corner < 3; ++corner)
      record[3 + 3 * corner + d] = static_cast<float>(triangle[corner][d]);
  }
  return record;
}

template <class T>
void write_bytes(std::ofstream &out, const T &value)
{
  out.write(reinterpret_cast<const char *>(&value), sizeof(T));
}

} // namespace

std::vector<Triangle> triangulate_surface(const Mesh &mesh, const std::string &body)
{
  const std::uint32_t number = body_number(mesh, body);
  const Surface *symmetry = find_surface(mesh, "symmetry");
  std::set<std::pair<std::uint32_t, std::uint32_t>> cut;
  if (symmetry != nullptr)
    for (const Face &face : symmetry->faces)
      cut.emplace(face.cell, face.local);
  std::vector<Triangle> triangles;
  for (const Face &face : free_faces(mesh))
    if (mesh.cell_body[face.cell] == number && !cut.contains({face.cell, face.local}))
      add_face(triangles, mesh, face);
  if (symmetry != nullptr)
    add_mirror_image(triangles);
  return triangles;
}

double enclosed_volume(const std::vector<Triangle> &triangles)
{
  double sum = 0;
  for (const Triangle &triangle : triangles)
    sum += dot(triangle[0], cross(triangle[1], triangle[2])) / 6;
  return sum;
}

std::optional<MeshFailure> write_stl(const Mesh &mesh, const std::string &body, const std::filesystem::path &path)
{
  const std::vector<Triangle> triangles = triangulate_surface(mesh, body);
  std::ofstream out(path, std::ios::binary);
  std::array<char, 80> header{};
  const std::string title = "Ballonet " + body + ", mm";
  std::copy_n(title.begin(), std::min(title.size(), header.size()), header.begin());
  write_bytes(out, header);
  write_bytes(out, static_cast<std::uint32_t>(triangles.size()));
  for (const Triangle &triangle : triangles) {
    write_bytes(out, stl_record(triangle));
    write_bytes(out, std::uint16_t{0});
  }
  if (!out.flush())
    return MeshFailure{"cannot write " + path.string(), {}};
  return std::nullopt;
}

std::optional<MeshFailure> write_step(const Mesh &, const std::string &, const std::filesystem::path &)
{
  return MeshFailure{"STEP export is not available yet", {}};
}

} // namespace ballonet::geometry
