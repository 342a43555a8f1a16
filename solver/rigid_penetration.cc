// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/rigid_penetration.h"
#include "solver/contact_surface.h"
#include "solver/free_surface.h"

namespace ballonet::solver
{

using namespace contact;

RigidPenetration::RigidPenetration(const Mesh &mesh, const ContactPair &pair, const RigidBody &body, double tolerance)
    : mesh_(mesh), name_(body.name), tolerance_(tolerance), shape_(make_rigid_shape(body)),
      nodes_(difference(free_surface_nodes(mesh, bodies_of(mesh, pair.secondary)), Flags(mesh.nodes.size(), false)))
{
  State rest;
  rest.displacement.resize(3 * mesh.nodes.size());
  for (const Violation &v : find(rest))
    std::erase(nodes_, v.node);
}

std::vector<Violation> RigidPenetration::find(const State &state) const
{
  const CurrentPosition position = {mesh_, state.displacement};
  std::vector<Violation> violations;
  for (const Node n : nodes_) {
    const Point3 x = position(n);
    if (const double depth = -shape_->distance(x).value; depth > tolerance_)
      violations.push_back({n, {x[0], x[1], x[2]}, depth, name_});
  }
  return violations;
}

} // namespace ballonet::solver
