// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_pairing.h"

namespace ballonet::solver::contact
{

/// A material point: combination of the nodes that carry a patch.
struct MaterialPoint {
  std::uint32_t patch;
  NodeWeights weights;
};

/// Two material points that were in contact at the start of the step: x of the secondary face and z of the primary
/// cell, found by going from the core to x along the cell's own base vectors. So z = x at the start, and a rigid motion
/// of the whole is no sliding. It does not matter which surface felt the contact.
struct SlidingPoint {
  MaterialPoint secondary, primary;
  double limit; ///< Coulomb limit: friction coefficient times normal force at the start, N
  Point3 normal;
  Point3 offset; ///< x - z at the start; zero but for rounding
};

SlidingPoint sliding_point(const ContactPairing &, const PairedPoint &, std::span<const double> displacement,
                           double limit);

/// x - z projected on the plane of contact, mm.
Point3 slip(const SlidingPoint &, const ContactPairing &, std::span<const double> displacement);

/// Incremental potential of Coulomb friction, smooth at rest: limit * (sqrt(|g|^2 + s^2) - s), s the slip below which
/// a point sticks (mm).
struct FrictionLaw {
  double sticking_slip;

  double energy(double limit, const Point3 &slip) const;
  Point3 force(double limit, const Point3 &slip) const;
  /// d force / d (x - z), for slip = (I - n n) (x - z).
  dealii::Tensor<2, 3> tangent(double limit, const Point3 &slip, const Point3 &normal) const;
};

} // namespace ballonet::solver::contact
