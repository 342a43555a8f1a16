// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_patch.h"
#include "solver/parameters.h"
#include <memory>

namespace ballonet::solver::contact
{

/// Signed distance to a surface with its derivatives by the point: positive outside.
struct SignedDistance {
  double value;                 ///< mm
  Point3 gradient;              ///< the outward normal at the closest point
  dealii::Tensor<2, 3> hessian; ///< 1/mm
};

/// A rigid body with a smooth surface in closed form, fixed in space.
class RigidShape
{
public:
  virtual ~RigidShape() = default;
  virtual SignedDistance distance(const Point3 &x) const = 0;
};

/// Throws std::invalid_argument for lengths that are not positive or an axis of no length.
std::unique_ptr<RigidShape> make_rigid_shape(const RigidBody &);

} // namespace ballonet::solver::contact
