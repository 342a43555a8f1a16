// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_friction.h"
#include "solver/contact_law.h"
#include "solver/contact_pairing.h"
#include "solver/virtual_work.h"

namespace ballonet::solver
{

struct ContactOptions {
  double margin = 0.2;         ///< mm beyond the contact distance within which points and patches are paired
  int search_iterations = 6;   ///< the pairing is frozen from this iteration of a step on
  int crossing_iterations = 8; ///< from this one on points stay on their patch
};

/// What a contact pair transmits. Ranks' parts are summed with +=.
struct ContactSummary {
  std::vector<Vector3> primary_force; ///< N, on each primary surface in the order of the pair's names
  Vector3 secondary_force = {};       ///< N, on the secondary surface
  double area = 0;                    ///< mm^2 of reference area in contact; of two passes the mean
  double penetration = 0;             ///< mm, the largest
  std::size_t points = 0;             ///< quadrature points in contact

  ContactSummary &operator+=(const ContactSummary &);
};

/// One quadrature point in contact.
struct ContactPoint {
  Face secondary, primary;
  Vector3 position;   ///< mm, present, on the secondary surface
  double area;        ///< mm^2 of reference area the point stands for, half of it with two passes
  double pressure;    ///< MPa per reference area
  double penetration; ///< mm
};

/// Contact of the secondary surface with the primary surface moved back into its body by the pair's thickness: energy =
/// sum of area * law(thickness - distance) over quadrature points, distance unsigned. With one pass the points are on
/// the secondary surface and look for the closest point of the primary one; with two passes points of the primary
/// surface look for the secondary one too, and each pass has half the area. Derivatives by the implicit function
/// theorem, exact and symmetric. Coulomb friction with the normal force and the contact point of the step's start, as
/// an incremental potential; its tractions are part of the state.
///
/// The tangent's geometric part uses a stored contact pressure that follows the linear prediction of each increment
/// (advance) instead of the one of the state, as in Magisano et al. (2017) for stresses: residual and energy are exact.
class ContactWork : public VirtualWork
{
public:
  /// `mesh` must outlive this. `owned`: cells whose points are this rank's.
  ContactWork(const Mesh &mesh, const ContactPair &pair, const std::function<bool(std::uint32_t cell)> &owned,
              const ContactOptions &options = {});

  void begin_step(const State &start, const Step &) override;
  void begin_iteration(const State &, int iteration) override;
  void add_couplings(std::vector<std::vector<Node>> &) const override;
  /// True when the last begin_step or begin_iteration has changed which pairs are within reach.
  bool couplings_changed() const override { return couplings_changed_; }

  double energy(const State &) const override;
  void residual(const State &, Assembly &) const override;
  void tangent(const State &, Assembly &) const override;
  void convexify(bool on) override { convex_ = on; }
  void advance(const State &from, std::span<const double> increment, double fraction) override;
  double largest_step(const State &, std::span<const double> increment) const override;

  /// Numbers the contact points of all ranks from here on in State::friction; returns where the next pair begins.
  std::size_t number_points_from(std::size_t first);
  /// Writes the tractions of friction at the end of a step, this rank's part, MPa.
  void end_step(State &end) const;

  /// Forces and extent of the contact in a state, this rank's part. Friction is the one of the present step: ask before
  /// the next begin_step.
  ContactSummary summary(const State &) const;
  /// All points in contact, this rank's part.
  std::vector<ContactPoint> contact_points(const State &) const;

private:
  contact::ContactPairing pairing_;
  ContactLaw law_;
  ContactOptions options_;
  double friction_, viscous_velocity_;
  std::size_t first_point_ = 0;
  std::size_t n_primary_surfaces_;
  bool couplings_changed_ = false, convex_ = false;
  contact::FrictionLaw friction_law_;
  std::vector<contact::SlidingPoint> sliding_;
  std::vector<double> stored_pressure_; ///< MPa, one per point

  void search(const State &);
  template <class Visit>
  void for_each_touching(const State &, Visit visit) const;
  contact::SlidingPoint sliding_point_at(const contact::PairedPoint &, const State &start) const;
  contact::Point3 friction_force(const contact::SlidingPoint &, const State &) const;
};

} // namespace ballonet::solver
