// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact.h"
#include "solver/contact_law.h"
#include "solver/contact_surface.h"
#include "solver/friction_law.h"
#include "solver/rigid_shape.h"

namespace ballonet::solver
{

/// Contact of the secondary surface's Gauss points with a rigid body: energy = area * law(-signed distance). No pairs
/// and no search, since the distance is known in closed form. Coulomb friction as between two bodies: normal force and
/// contact point are those of the step's start; the point slides against the place where it was then.
///
/// Only the points and nodes of the secondary surface feel the body: an edge of a box that is sharper than their
/// distance sinks in between them.
class RigidContactWork : public Contact
{
public:
  /// `mesh` must outlive this. `owned`: cells whose points are this rank's.
  RigidContactWork(const Mesh &mesh, const ContactPair &pair, const RigidBody &body,
                   const std::function<bool(std::uint32_t cell)> &owned);

  void begin_step(const State &start, const Step &) override;
  double energy(const State &) const override;
  void residual(const State &, Assembly &) const override;
  void tangent(const State &, Assembly &) const override;
  void convexify(bool on) override { convex_ = on; }
  void advance(const State &from, std::span<const double> increment, double fraction) override;
  /// No point sinks in deeper than the pair's thickness less the core.
  double largest_step(const State &, std::span<const double> increment) const override;

  std::size_t number_points_from(std::size_t first) override;
  std::size_t number_shifts_from(std::size_t first) override;
  void take_shifts(const State &) override;
  void add_gaps(const State &, contact::MeanGaps &) const override;
  void end_step(State &end) const override;
  ContactSummary summary(const State &) const override;
  std::vector<ContactPoint> contact_points(const State &) const override;

private:
  struct PointAt; ///< a quadrature point in one state
  struct Sliding {
    contact::FrictionPoint friction;
    contact::Point3 start;
  };

  const Mesh &mesh_;
  std::unique_ptr<contact::RigidShape> shape_;
  std::vector<contact::Patch> faces_;
  ContactLaw law_;
  double friction_, viscous_velocity_, thickness_;
  std::size_t first_point_ = 0, n_points_of_all_ranks_ = 0, first_shift_ = 0, n_shifts_ = 0;
  bool convex_ = false;
  contact::FrictionLaw friction_law_;
  std::vector<Sliding> sliding_;        ///< one per point
  std::vector<double> stored_pressure_; ///< MPa, one per point
  std::vector<double> shifts_;          ///< mm, of augmented contact, by node; none: zero

  template <class Visit>
  void for_each(const State &, Visit visit) const;
  contact::Point3 slip(const PointAt &) const;
  contact::Point3 force(const PointAt &) const;
};

} // namespace ballonet::solver
