// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/self_penetration.h"
#include "solver/free_surface.h"
#include <algorithm>

namespace ballonet::solver
{

using namespace contact;

namespace
{

std::vector<std::string> joined(std::vector<std::string> names, const std::vector<std::string> &more)
{
  names.insert(names.end(), more.begin(), more.end());
  return names;
}

} // namespace

/// In a tree.
struct SelfPenetration::Cells {
  std::vector<CellNodes> nodes;
  BoxTree tree;

  Cells(const SelfPenetration &check, const CurrentPosition &position)
      : nodes(all_nodes(check, position)), tree(all_boxes(nodes))
  {
  }

  static std::vector<CellNodes> all_nodes(const SelfPenetration &check, const CurrentPosition &position)
  {
    std::vector<CellNodes> nodes(check.cells_.size());
    for (std::size_t c = 0; c < nodes.size(); ++c)
      for (int a = 0; a < 27; ++a)
        nodes[c][a] = position(check.mesh_.cells[check.cells_[c]][a]);
    return nodes;
  }

  static std::vector<Box> all_boxes(const std::vector<CellNodes> &nodes)
  {
    std::vector<Box> boxes;
    for (const CellNodes &cell : nodes)
      boxes.push_back(enclosing_box(cell));
    return boxes;
  }
};

SelfPenetration::SelfPenetration(const Mesh &mesh, const ContactPair &pair, double tolerance)
    : mesh_(mesh), tolerance_(tolerance), neighbourhood_(2 * pair.thickness)
{
  const auto names = joined(pair.secondary, pair.primary);
  const Flags bodies = both(bodies_of(mesh, pair.secondary), bodies_of(mesh, pair.primary));
  sharp_ = patches_of(mesh, names, 0);
  rounded_ = patches_of(mesh, names, pair.thickness);
  cells_ = cells_of(mesh, bodies);
  nodes_ = difference(both(nodes_on(mesh, names), nodes_of(mesh, bodies)), Flags(mesh.nodes.size(), false));
  State rest;
  rest.displacement.resize(3 * mesh.nodes.size());
  for (const Violation &v : find(rest)) // parts that overlap as they are drawn
    std::erase(nodes_, v.node);
}

bool SelfPenetration::neighbours(Node node, const Face &face) const
{
  return closest_point(face_at_rest(mesh_, face), {}, ReferencePosition{mesh_}(node)).distance < neighbourhood_;
}

bool SelfPenetration::neighbours(Node node, std::uint32_t cell) const
{
  for (std::uint32_t local = 0; local < 6; ++local)
    if (neighbours(node, Face{cell, local}))
      return true;
  return false;
}

/// Of a node that lies in a cell which is no neighbour of it. Rarely asked.
double SelfPenetration::depth(const CurrentPosition &position, Node node) const
{
  double to_sharp = infinity, in_rounded = 0;
  for (std::size_t p = 0; p < sharp_.size(); ++p) {
    if (neighbours(node, sharp_[p].face))
      continue;
    const Patch &rounded = rounded_[p];
    to_sharp = std::min(to_sharp, closest_point(at_depth(sharp_[p], position), {}, position(node)).distance);
    const double to_core = closest_point(at_depth(rounded, position), rounded.range, position(node)).distance;
    in_rounded = std::max(in_rounded, rounded.depth - to_core);
  }
  const bool behind_core = to_sharp >= neighbourhood_ / 2;
  return behind_core ? to_sharp : std::min(to_sharp, in_rounded);
}

/// Whether a point of a cell is nearer to the back of its wall than to the surface of the pair.
bool SelfPenetration::beyond_middle(const Point3 &local, std::uint32_t cell) const
{
  bool beyond = false;
  for (const Patch &patch : sharp_)
    if (patch.face.cell == cell) {
      const double along = local[patch.face.local / 2];
      if (patch.face.local % 2 == 0 ? along < 0.5 : along > 0.5)
        return false;
      beyond = true;
    }
  return beyond;
}

std::vector<Violation> SelfPenetration::find(const State &state) const
{
  const CurrentPosition position = {mesh_, state.displacement};
  const Cells cells(*this, position);
  std::vector<Violation> violations;
  for (const Node n : nodes_) {
    const Point3 x = position(n);
    bool found = false;
    cells.tree.overlapping({x, x}, [&](std::uint32_t index) {
      const std::uint32_t cell = cells_[index];
      const auto &own = mesh_.cells[cell];
      if (found || std::find(own.begin(), own.end(), n) != own.end())
        return;
      const auto local = local_coordinates(cells.nodes[index], x);
      if (!local || neighbours(n, cell))
        return;
      const double deep = depth(position, n);
      found = deep > tolerance_ || beyond_middle(*local, cell);
      if (found)
        violations.push_back({n, {x[0], x[1], x[2]}, deep, mesh_.bodies[mesh_.cell_body[cell]]});
    });
  }
  return violations;
}

} // namespace ballonet::solver
