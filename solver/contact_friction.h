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
  std::size_t number; ///< of the contact point
  double area;        ///< mm^2
  MaterialPoint secondary, primary;
  double limit; ///< Coulomb limit: friction coefficient times normal force at the start, N
  Point3 normal;
  Point3 offset;            ///< x - z at the start; zero but for rounding
  Point3 elastic_slip = {}; ///< at the start, mm
};

SlidingPoint sliding_point(const ContactPairing &, const PairedPoint &, std::span<const double> displacement,
                           double limit);

/// x - z projected on the plane of contact, mm.
Point3 slip(const SlidingPoint &, const ContactPairing &, std::span<const double> displacement);

/// Coulomb friction that remembers how it sticks, as an incremental potential: of the slip g in the step with the
/// elastic slip e at its start,
///   limit * [sqrt(|e + g|^2 + s^2) + |g|^2 / (2 v dt)],
/// s the elastic slip over which friction builds up. The last term, linear in the speed, doubles friction at the speed
/// v: without it a surface that begins to slide is free to jump.
struct FrictionLaw {
  double elastic_slip = 1;        ///< s, mm
  double viscous_slip = infinity; ///< v dt, mm

  /// The elastic slip that carries this share of the limit, at most 0.995 of it.
  Point3 slip_of(const Point3 &share) const;

  double energy(const SlidingPoint &, const Point3 &slip) const;
  Point3 force(const SlidingPoint &, const Point3 &slip) const;
  /// The part of the force that stays when the slip comes to rest.
  Point3 remembered_force(const SlidingPoint &, const Point3 &slip) const;
  /// d force / d (x - z), for slip = (I - n n) (x - z).
  dealii::Tensor<2, 3> tangent(const SlidingPoint &, const Point3 &slip) const;
};

/// A traction of the step before, turned into the plane of contact of this one with its size kept.
Point3 into_plane(const Point3 &traction, const Point3 &normal);

} // namespace ballonet::solver::contact
