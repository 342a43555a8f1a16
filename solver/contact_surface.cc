// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_surface.h"
#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

namespace ballonet::solver::contact
{

namespace
{

constexpr std::array<std::array<int, 2>, 3> in_plane = {{{1, 2}, {0, 2}, {0, 1}}};

std::array<std::uint8_t, 27> make_columns(std::uint32_t local_face)
{
  constexpr std::array<int, 3> stride = {1, 3, 9};
  const int normal = static_cast<int>(local_face / 2);
  std::array<std::uint8_t, 27> nodes;
  for (int c = 0; c < 9; ++c)
    for (int k = 0; k < 3; ++k) {
      const int depth = local_face % 2 == 0 ? k : 2 - k;
      nodes[3 * c + k] = static_cast<std::uint8_t>(c % 3 * stride[in_plane[normal][0]] +
                                                   c / 3 * stride[in_plane[normal][1]] + depth * stride[normal]);
    }
  return nodes;
}

/// Mean distance between a face and its opposite one in the reference configuration.
double thickness_behind(const Mesh &mesh, const Face &face)
{
  const auto &column = columns_behind(face.local);
  const auto &nodes = mesh.cells[face.cell];
  const ReferencePosition position = {mesh};
  double sum = 0;
  for (int c = 0; c < 9; ++c)
    sum += (position(nodes[column[3 * c + 2]]) - position(nodes[column[3 * c]])).norm();
  return sum / 9;
}

/// Faces of the surface of each cell, as bits.
std::map<std::uint32_t, unsigned> sides_by_cell(const std::vector<NamedFace> &faces)
{
  std::map<std::uint32_t, unsigned> sides;
  for (const NamedFace &f : faces)
    sides[f.face.cell] |= 1u << f.face.local;
  return sides;
}

/// The depth that fits into a cell: half its thickness along every direction that has a face of the surface.
double fitting_depth(const Mesh &mesh, std::uint32_t cell, unsigned sides, double depth)
{
  for (std::uint32_t direction = 0; direction < 3; ++direction)
    if (sides & (3u << 2 * direction))
      depth = std::min(depth, 0.5 * thickness_behind(mesh, {cell, 2 * direction}));
  return depth;
}

PatchRange trimmed_range(const Mesh &mesh, const Face &face, unsigned sides, double depth)
{
  PatchRange range;
  for (int a = 0; a < 2; ++a) {
    const std::uint32_t side = 2 * in_plane[face.local / 2][a];
    const double fraction = depth / thickness_behind(mesh, {face.cell, side});
    if (sides & (1u << side))
      range.low[a] = std::min(fraction, 0.5);
    if (sides & (2u << side))
      range.high[a] = std::max(1 - fraction, 0.5);
  }
  return range;
}

/// The nodes whose motion moves the surface at a depth behind a face.
std::vector<Node> carriers(const Mesh &mesh, const Face &face, double depth)
{
  const auto &cell = mesh.cells[face.cell];
  if (depth > 0)
    return {cell.begin(), cell.end()};
  std::vector<Node> nodes;
  for (int a = 0; a < 9; ++a)
    nodes.push_back(cell[columns_behind(face.local)[3 * a]]);
  return nodes;
}

/// Two faces are neighbours when they share the middle node of a side.
void find_neighbours(std::vector<Patch> &patches)
{
  constexpr std::array<int, 4> begin_of_side = {0, 2, 0, 6};
  struct Side {
    std::uint32_t patch;
    int side;
    Node begin;
  };
  std::map<Node, Side> first_at; // by the middle node
  for (std::uint32_t p = 0; p < patches.size(); ++p)
    for (int side = 0; side < 4; ++side) {
      auto node = [&](int column) { return patches[p].nodes[patches[p].place(column, 0)]; };
      const Side here = {p, side, node(begin_of_side[side])};
      const auto [other, is_new] = first_at.insert({node(middle_of_side[side]), here});
      if (is_new)
        continue;
      const Side &there = other->second;
      const bool reversed = here.begin != there.begin;
      patches[p].neighbour[side] = {there.patch, there.side, reversed};
      patches[there.patch].neighbour[there.side] = {p, side, reversed};
    }
}

} // namespace

const std::array<std::uint8_t, 27> &columns_behind(std::uint32_t local_face)
{
  static const std::array<std::array<std::uint8_t, 27>, 6> columns = {
      make_columns(0), make_columns(1), make_columns(2), make_columns(3), make_columns(4), make_columns(5)};
  return columns[local_face];
}

double outward_sign(std::uint32_t local_face)
{
  constexpr std::array<double, 6> sign = {-1, 1, 1, -1, -1, 1};
  return sign[local_face];
}

std::vector<NamedFace> faces_of(const Mesh &mesh, const std::vector<std::string> &names)
{
  std::vector<NamedFace> faces;
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  for (std::uint32_t n = 0; n < names.size(); ++n) {
    const auto surface =
        std::find_if(mesh.surfaces.begin(), mesh.surfaces.end(), [&](const Surface &s) { return s.name == names[n]; });
    if (surface == mesh.surfaces.end())
      throw std::invalid_argument("contact: the mesh has no surface \"" + names[n] + "\"");
    for (const Face &face : surface->faces)
      if (seen.insert({face.cell, face.local}).second)
        faces.push_back({face, n});
  }
  return faces;
}

Parameters2 across(const Parameters2 &xi, int side, const Neighbour &link, const Patch &neighbour)
{
  const int normal = link.side / 2;
  const double along = xi[1 - side / 2];
  Parameters2 there;
  there[normal] = link.side % 2 == 0 ? neighbour.range.low[normal] : neighbour.range.high[normal];
  there[1 - normal] = link.reversed ? 1 - along : along;
  return there;
}

PatchNodes within_range(const PatchNodes &nodes, const PatchRange &range)
{
  auto between = [](double low, double high, int i) { return low + 0.5 * i * (high - low); };
  PatchNodes part;
  for (int a = 0; a < 9; ++a) {
    const Parameters2 xi = {between(range.low[0], range.high[0], a % 3), between(range.low[1], range.high[1], a / 3)};
    part[a] = patch_point(nodes, xi).position;
  }
  return part;
}

std::vector<Patch> patches_of(const Mesh &mesh, const std::vector<std::string> &names, double depth)
{
  const std::vector<NamedFace> faces = faces_of(mesh, names);
  const auto sides = sides_by_cell(faces);
  std::vector<Patch> patches;
  for (const NamedFace &f : faces) {
    const double fitting = fitting_depth(mesh, f.face.cell, sides.at(f.face.cell), depth);
    const double fraction = fitting / thickness_behind(mesh, f.face);
    const PatchRange range = trimmed_range(mesh, f.face, sides.at(f.face.cell), fitting);
    patches.push_back(
        {f.face, f.surface, carriers(mesh, f.face, fitting), quadratic(fraction), fraction, range, fitting});
  }
  find_neighbours(patches);
  return patches;
}

NodeWeights node_weights(const Patch &patch, const std::array<double, 9> &shapes)
{
  NodeWeights weights{};
  for (std::size_t c = 0; c < 9; ++c)
    for (std::size_t k = 0; k < patch.n_layers(); ++k)
      weights[patch.place(c, k)] = shapes[c] * patch.layer_weight[k];
  return weights;
}

PatchNodes face_at_rest(const Mesh &mesh, const Face &face)
{
  PatchNodes nodes;
  for (int a = 0; a < 9; ++a)
    nodes[a] = ReferencePosition{mesh}(mesh.cells[face.cell][columns_behind(face.local)[3 * a]]);
  return nodes;
}

} // namespace ballonet::solver::contact
