// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/cell_inversion.h"
#include "solver/contact_search.h"
#include "solver/contact_surface.h"
#include "solver/violation.h"

namespace ballonet::solver
{

/// Looks for parts of a body that lie in other parts of it, independent of the contact's pairing and quadrature points:
/// nodes of the surfaces of a pair that touches itself are tested against the cells of their bodies. What is closer
/// than twice the thickness at rest is a neighbour, as in the contact, and not looked at.
///
/// A node is reported when it lies deeper than `tolerance` behind the surface, its convex edges rounded as the contact
/// sees them, or beyond the middle of a cell whose wall has become thinner than that. What has passed right through a
/// wall within one step is not seen: the step limit of the contact prevents it.
class SelfPenetration
{
public:
  /// `mesh` must outlive this. `tolerance`: depth in mm that soft contact is allowed.
  SelfPenetration(const Mesh &mesh, const ContactPair &pair, double tolerance);

  std::vector<Violation> find(const State &) const;

private:
  struct Cells; ///< all of them in one state

  const Mesh &mesh_;
  double tolerance_, neighbourhood_;
  std::vector<contact::Patch> sharp_, rounded_; ///< the surface as it is, and as the contact sees it
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> cells_;

  bool neighbours(Node, std::uint32_t cell) const;
  bool neighbours(Node, const Face &) const;
  double depth(const contact::CurrentPosition &, Node) const;
  bool beyond_middle(const contact::Point3 &local, std::uint32_t cell) const;
};

} // namespace ballonet::solver
