// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/penetration_check.h"
#include "solver/cell_inversion.h"
#include "solver/free_surface.h"
#include <cmath>

namespace ballonet::solver
{

using namespace contact;

namespace
{

/// Nearest faces of a surface to a point so far; several at a common edge or corner.
struct Nearest {
  double distance = infinity;
  bool beside_open_side = false; ///< the surface ends there: neither side of it can be told
  double height = 0;             ///< of the point above the faces, summed: negative on the inner side
  std::uint32_t cell = 0;
};

/// True when the closest point is on an open side and the point does not stand upright on it.
bool beside(const ClosestPoint &c, const std::array<bool, 4> &open)
{
  for (int a = 0; a < 2; ++a)
    if (!c.free[a] && open[2 * a + (c.xi[a] > 0.5)] && std::abs(c.normal * c.tangent[a]) > 0.1 * c.tangent[a].norm())
      return true;
  return false;
}

} // namespace

std::vector<PenetrationCheck::Shell> PenetrationCheck::shells(const Mesh &mesh, const std::vector<std::string> &names)
{
  std::vector<Shell> shells;
  std::vector<std::uint8_t> faces_at(mesh.nodes.size(), 0);
  for (const NamedFace &f : faces_of(mesh, names)) {
    Shell shell = {f.face, {}, {}};
    for (int a = 0; a < 9; ++a)
      shell.nodes[a] = mesh.cells[f.face.cell][columns_behind(f.face.local)[3 * a]];
    for (const int middle : middle_of_side)
      ++faces_at[shell.nodes[middle]];
    shells.push_back(shell);
  }
  for (Shell &shell : shells)
    for (int side = 0; side < 4; ++side)
      shell.open[side] = faces_at[shell.nodes[middle_of_side[side]]] == 1;
  return shells;
}

PenetrationCheck::PenetrationCheck(const Mesh &mesh, const ContactPair &pair, double tolerance)
    : mesh_(mesh), tolerance_(tolerance), secondary_(shells(mesh, pair.secondary)),
      primary_(shells(mesh, pair.primary)), rounded_(patches_of(mesh, pair.primary, pair.thickness))
{
  const auto secondary_bodies = bodies_of(mesh, pair.secondary), primary_bodies = bodies_of(mesh, pair.primary);
  primary_nodes_ = difference(free_surface_nodes(mesh, primary_bodies), nodes_of(mesh, secondary_bodies));
  secondary_nodes_ = difference(nodes_on(mesh, pair.secondary), nodes_of(mesh, primary_bodies));
  primary_cells_ = cells_of(mesh, primary_bodies);
  // what closes an open surface at rest (the base under a clamped ring) is not beyond it
  overhang_.assign(primary_nodes_.size(), 0);
  State rest;
  rest.displacement.resize(3 * mesh.nodes.size());
  for (const Violation &v : find(rest)) {
    std::erase(primary_nodes_, v.node);
    std::erase(secondary_nodes_, v.node);
  }
  overhang_ = overhangs(pair.thickness);
}

std::vector<double> PenetrationCheck::overhangs(double thickness) const
{
  const std::vector<double> rest(3 * mesh_.nodes.size());
  const CurrentPosition position = {mesh_, rest};
  std::vector<PatchNodes> nodes;
  std::vector<Box> boxes;
  for (const Patch &patch : rounded_) {
    nodes.push_back(at_depth(patch, position));
    boxes.push_back(enclosing_box(nodes.back()));
  }
  const BoxTree tree(std::move(boxes));
  const double most = (std::sqrt(3.) - 1) * thickness; // of a right-angled corner
  std::vector<double> overhang;
  for (const Node n : primary_nodes_) {
    double outside = most, nearest = infinity;
    tree.nearest(position(n), infinity, [&](std::uint32_t index, double) {
      const double distance = closest_point(nodes[index], rounded_[index].range, position(n)).distance;
      outside = std::min(outside, distance - rounded_[index].depth);
      return nearest = std::min(nearest, distance);
    });
    overhang.push_back(std::max(outside, 0.));
  }
  return overhang;
}

Violation PenetrationCheck::violation(Node node, const Point3 &x, double depth, std::uint32_t cell) const
{
  return {node, {x[0], x[1], x[2]}, depth, mesh_.bodies[mesh_.cell_body[cell]]};
}

std::vector<Violation> PenetrationCheck::find(const State &state) const
{
  const CurrentPosition position = {mesh_, state.displacement};
  std::vector<Violation> violations;
  find_through_wall(position, violations);
  find_in_cells(position, violations);
  return violations;
}

void PenetrationCheck::find_through_wall(const CurrentPosition &position, std::vector<Violation> &violations) const
{
  std::vector<PatchNodes> nodes;
  std::vector<Box> boxes;
  for (const Shell &shell : secondary_) {
    nodes.push_back(at_nodes(shell.nodes, position));
    boxes.push_back(enclosing_box(nodes.back()));
  }
  const BoxTree tree(std::move(boxes));
  for (std::size_t i = 0; i < primary_nodes_.size(); ++i) {
    const Node n = primary_nodes_[i];
    const Point3 x = position(n);
    Nearest nearest;
    tree.nearest(x, infinity, [&](std::uint32_t index, double) {
      const Shell &shell = secondary_[index];
      const ClosestPoint c = closest_point(nodes[index], {}, x);
      const double tie = 1e-6 * nearest.distance + 1e-9;
      if (c.distance < nearest.distance - tie || nearest.distance == infinity)
        nearest = {c.distance, false, 0, shell.face.cell};
      if (c.distance < nearest.distance + tie || nearest.distance == c.distance) {
        const Point3 normal = outward_sign(shell.face.local) * cross_product_3d(c.tangent[0], c.tangent[1]);
        nearest.height += c.normal * normal / normal.norm();
        nearest.beside_open_side = nearest.beside_open_side || beside(c, shell.open);
      }
      return nearest.distance * (1 + 1e-6) + 1e-9;
    });
    if (nearest.distance > tolerance_ + overhang_[i] && nearest.height < 0 && !nearest.beside_open_side)
      violations.push_back(violation(n, x, nearest.distance, nearest.cell));
  }
}

/// Depth of a point that lies `depth` behind the sharp surface. Rarely asked, so all patches are tried.
double PenetrationCheck::depth_in_rounded(const CurrentPosition &position, const Point3 &x, double depth) const
{
  double deepest = 0;
  for (const Patch &patch : rounded_) {
    if (depth >= patch.depth)
      return depth; // behind the core
    deepest = std::max(deepest, patch.depth - closest_point(at_depth(patch, position), patch.range, x).distance);
  }
  return deepest;
}

void PenetrationCheck::find_in_cells(const CurrentPosition &position, std::vector<Violation> &violations) const
{
  std::vector<CellNodes> cells;
  std::vector<Box> cell_boxes, shell_boxes;
  for (const std::uint32_t c : primary_cells_) {
    CellNodes &cell = cells.emplace_back();
    for (int a = 0; a < 27; ++a)
      cell[a] = position(mesh_.cells[c][a]);
    cell_boxes.push_back(enclosing_box(cell));
  }
  for (const Shell &shell : primary_)
    shell_boxes.push_back(enclosing_box(at_nodes(shell.nodes, position)));
  const BoxTree cell_tree(std::move(cell_boxes)), shell_tree(std::move(shell_boxes));
  for (const Node n : secondary_nodes_) {
    const Point3 x = position(n);
    bool found = false;
    cell_tree.overlapping({x, x}, [&](std::uint32_t index) {
      if (found || !local_coordinates(cells[index], x))
        return;
      found = true;
      double depth = infinity;
      shell_tree.nearest(x, infinity, [&](std::uint32_t shell, double) {
        return depth = std::min(depth, closest_point(at_nodes(primary_[shell].nodes, position), {}, x).distance);
      });
      if (depth > tolerance_ && depth_in_rounded(position, x, depth) > tolerance_)
        violations.push_back(violation(n, x, depth, primary_cells_[index]));
    });
  }
}

} // namespace ballonet::solver
