// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_pairing.h"
#include "solver/friction_law.h"

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
  PairedPoint contact;
  FrictionPoint friction;
  MaterialPoint secondary, primary;
  Point3 offset;             ///< x - z at the start; zero but for rounding
  dealii::Tensor<2, 3> axes; ///< carried by the surface that has the contact point, at the start; columns
};

SlidingPoint sliding_point(const ContactPairing &, const PairedPoint &, std::span<const double> displacement,
                           const FrictionPoint &);

/// How the surface that has the contact point has turned there since the start of the step.
dealii::Tensor<2, 3> turn(const SlidingPoint &, const ContactPairing &, std::span<const double> displacement);

/// x - z projected on the plane of contact, mm.
Point3 slip(const SlidingPoint &, const ContactPairing &, std::span<const double> displacement);

} // namespace ballonet::solver::contact
