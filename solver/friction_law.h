// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_patch.h"
#include "solver/types.h"
#include <limits>

namespace ballonet::solver::contact
{

/// Friction at one contact point during a step.
struct FrictionPoint {
  double limit = 0; ///< friction coefficient times normal force at the start, N; zero: none
  Point3 normal;
  Point3 elastic_slip; ///< at the start, mm
};

/// Coulomb friction that remembers how it sticks, as an incremental potential: of the slip g in the step with the
/// elastic slip e at its start,
///   limit * [sqrt(|e + g|^2 + s^2) + |g|^2 / (2 v dt)],
/// s the elastic slip over which friction builds up. The last term, linear in the speed, doubles friction at the speed
/// v: without it a surface that begins to slide is free to jump.
struct FrictionLaw {
  double elastic_slip = 1;                                       ///< s, mm
  double viscous_slip = std::numeric_limits<double>::infinity(); ///< v dt, mm

  /// A point of that area (mm^2) that comes into the step with a traction (MPa). It is turned into the plane of contact
  /// with its size kept, and is at most 0.995 of the strength (friction coefficient times pressure, MPa).
  FrictionPoint begin(double strength, double area, const Point3 &normal, const Point3 &traction) const;

  double energy(const FrictionPoint &, const Point3 &slip) const;
  Point3 force(const FrictionPoint &, const Point3 &slip) const;
  /// The part of the force that stays when the slip comes to rest.
  Point3 remembered_force(const FrictionPoint &, const Point3 &slip) const;
  /// d force / d way, for slip = (I - n n) way.
  dealii::Tensor<2, 3> tangent(const FrictionPoint &, const Point3 &slip) const;
};

/// The part of a way in the plane of contact.
inline Point3 in_plane(const Point3 &way, const Point3 &normal) { return way - (way * normal) * normal; }

/// What a state remembers of a contact point, MPa; zero where it remembers nothing.
Point3 remembered_traction(const State &, std::size_t point);
void remember_traction(State &, std::size_t point, const Point3 &traction);

} // namespace ballonet::solver::contact
