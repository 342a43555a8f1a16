// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_search.h"
#include "solver/contact_surface.h"
#include "solver/violation.h"

namespace ballonet::solver
{

/// Looks for tunnelling: the contact energy vanishes when a body has passed between the contact points, and the
/// equations still converge. Independent of the contact's pairing and quadrature points.
///
/// Nodes on the free surface of the primary bodies are tested against the secondary surface, which must enclose its
/// body and may be open at symmetry planes and clamped rings: whatever lies on its inner side has gone through, however
/// far. Nodes of the secondary surface are tested against the cells of the primary bodies. Nodes that belong to both
/// bodies, and nodes that lie on the inner side already at rest (what closes an open surface), are left out. A body
/// that touches itself is SelfPenetration's, a rigid one RigidPenetration's.
class PenetrationCheck
{
public:
  /// `mesh` must outlive this. `tolerance`: depth in mm that soft contact is allowed. Convex edges and corners count as
  /// the contact sees them, rounded (radius = thickness of the pair): their nodes stand out, and others may lie in what
  /// the rounding has taken away.
  PenetrationCheck(const Mesh &mesh, const ContactPair &pair, double tolerance);

  std::vector<Violation> find(const State &) const;

private:
  /// How far a node of a sharp edge stands out of the rounded edges that the contact works with, mm at rest.
  std::vector<double> overhangs(double thickness) const;

  struct Shell { ///< one face of a surface
    Face face;
    std::array<Node, 9> nodes;
    std::array<bool, 4> open; ///< sides (low 0, high 0, low 1, high 1) with no further face of the surface
  };

  const Mesh &mesh_;
  double tolerance_;
  std::vector<Shell> secondary_, primary_;
  std::vector<contact::Patch> rounded_; ///< the primary surface as the contact sees it
  std::vector<Node> secondary_nodes_, primary_nodes_;
  std::vector<double> overhang_; ///< one per primary node: it may lie deeper by that
  std::vector<std::uint32_t> primary_cells_;

  static std::vector<Shell> shells(const Mesh &, const std::vector<std::string> &names);
  void find_through_wall(const contact::CurrentPosition &, std::vector<Violation> &) const;
  void find_in_cells(const contact::CurrentPosition &, std::vector<Violation> &) const;
  double depth_in_rounded(const contact::CurrentPosition &, const contact::Point3 &, double depth) const;
  Violation violation(Node, const contact::Point3 &, double depth, std::uint32_t cell) const;
};

} // namespace ballonet::solver
