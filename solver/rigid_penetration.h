// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/mesh.h"
#include "solver/rigid_shape.h"
#include "solver/violation.h"

namespace ballonet::solver
{

/// Looks for nodes that lie deeper in a rigid body than soft contact is allowed. All of the free surface of the bodies
/// on the pair's secondary side is tested, not only what the pair names: where the contact does not look, a body would
/// go in without a force. Nodes that lie as deep at rest (a part that is built in) are left out.
class RigidPenetration
{
public:
  /// `mesh` must outlive this. `tolerance`: allowed depth, mm.
  RigidPenetration(const Mesh &mesh, const ContactPair &pair, const RigidBody &body, double tolerance);

  std::vector<Violation> find(const State &) const;

private:
  const Mesh &mesh_;
  std::string name_;
  double tolerance_;
  std::unique_ptr<contact::RigidShape> shape_;
  std::vector<Node> nodes_;
};

} // namespace ballonet::solver
