// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_pair_patches.h"
#include "solver/contact_quadrature.h"
#include <algorithm>
#include <set>
#include <stdexcept>

namespace ballonet::solver::contact
{

namespace
{

void check(const ContactPair &pair)
{
  if (pair.thickness <= 0 || pair.stiffness <= 0 || pair.onset < 0 || pair.friction < 0)
    throw std::invalid_argument("contact pair \"" + pair.name +
                                "\": thickness and stiffness must be positive, onset and friction not negative");
  if (pair.passes != 1 && pair.passes != 2)
    throw std::invalid_argument("contact pair \"" + pair.name + "\": " + std::to_string(pair.passes) +
                                " passes, allowed are 1 and 2");
}

using FaceKey = std::pair<std::uint32_t, std::uint32_t>;

FaceKey key(const Face &face) { return {face.cell, face.local}; }

std::set<FaceKey> keys(const std::vector<Patch> &patches)
{
  std::set<FaceKey> keys;
  for (const Patch &patch : patches)
    keys.insert(key(patch.face));
  return keys;
}

/// Outward unit normals at the nine nodes of a patch.
std::array<Point3, 9> normals(const PatchNodes &nodes, const Face &face)
{
  std::array<Point3, 9> normals;
  for (int a = 0; a < 9; ++a) {
    const PatchPoint p = patch_point(nodes, {a % 3 / 2., a / 3 / 2.});
    const Point3 normal = cross_product_3d(p.tangent[0], p.tangent[1]);
    normals[a] = outward_sign(face.local) / normal.norm() * normal;
  }
  return normals;
}

} // namespace

std::vector<Patch> patches_of_pair(const Mesh &mesh, const ContactPair &pair)
{
  check(pair);
  std::vector<Patch> patches = patches_of(mesh, pair.secondary, 0),
                     primary = patches_of(mesh, pair.primary, pair.thickness);
  const auto secondary_faces = keys(patches), primary_faces = keys(primary);
  auto share = [&](const Patch &patch) {
    const bool both = secondary_faces.count(key(patch.face)) && primary_faces.count(key(patch.face));
    return 1. / pair.passes / (both ? 2 : 1);
  };
  for (Patch &patch : patches)
    patch.points = gauss_points(mesh, patch, pair.points_per_side, share(patch));
  const auto n_secondary = static_cast<std::uint32_t>(patches.size());
  const double spacing = pair.point_spacing > 0 ? pair.point_spacing : pair.thickness / 2;
  for (Patch &patch : primary) {
    if (pair.passes == 2)
      patch.points = points_with_edges(mesh, patch, spacing, share(patch));
    for (auto &neighbour : patch.neighbour)
      if (neighbour)
        neighbour->patch += n_secondary;
    patches.push_back(std::move(patch));
  }
  return patches;
}

double distance_of(const PatchNodes &from, const PatchNodes &to, const PatchRange &range)
{
  double smallest = infinity;
  for (const Point3 &x : from)
    smallest = std::min(smallest, closest_point(to, range, x).distance);
  return smallest;
}

bool face_each_other(const PatchNodes &a, const Face &face_a, const PatchNodes &b, const Face &face_b)
{
  constexpr double rise = 0.5; // sine of the angle with the surface
  const auto normals_a = normals(a, face_a), normals_b = normals(b, face_b);
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j) {
      const Point3 way = b[j] - a[i];
      const double needed = rise * way.norm();
      if (way * normals_a[i] > needed && -(way * normals_b[j]) > needed)
        return true;
    }
  return false;
}

bool touches_itself(const Mesh &mesh, const std::vector<Patch> &patches, std::uint32_t n_secondary)
{
  std::set<std::uint32_t> bodies;
  for (std::uint32_t p = 0; p < n_secondary; ++p)
    bodies.insert(mesh.cell_body[patches[p].face.cell]);
  return std::any_of(patches.begin() + n_secondary, patches.end(),
                     [&](const Patch &patch) { return bodies.count(mesh.cell_body[patch.face.cell]) > 0; });
}

} // namespace ballonet::solver::contact
