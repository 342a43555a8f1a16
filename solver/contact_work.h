// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact.h"
#include "solver/contact_friction.h"
#include "solver/contact_law.h"
#include "solver/contact_pairing.h"

namespace ballonet::solver
{

struct ContactOptions {
  double margin = 0.2;         ///< mm beyond the contact distance within which points and patches are paired
  int search_iterations = 6;   ///< from this iteration of a step on only motion by half the margin calls for a search
  int crossing_iterations = 8; ///< from this one on points stay on their patch
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
class ContactWork : public Contact
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

  std::size_t number_points_from(std::size_t first) override;
  std::size_t number_shifts_from(std::size_t first) override;
  void take_shifts(const State &) override;
  void add_gaps(const State &, contact::MeanGaps &) const override;
  void end_step(State &end) const override;
  ContactSummary summary(const State &) const override;
  std::vector<ContactPoint> contact_points(const State &) const override;
  double missed_force(const State &) const override;

private:
  contact::ContactPairing pairing_;
  ContactLaw law_;
  ContactOptions options_;
  double friction_, viscous_velocity_;
  std::size_t first_point_ = 0, first_shift_ = 0;
  std::size_t n_primary_surfaces_;
  bool couplings_changed_ = false, convex_ = false;
  contact::FrictionLaw friction_law_;
  std::vector<contact::SlidingPoint> sliding_;
  std::vector<double> stored_pressure_; ///< MPa, one per point
  std::vector<double> searched_;        ///< displacement at the last search, mm

  double moved(const State &) const;
  void search(const State &);
  const std::vector<contact::PairedPoint> &touching(const State &state) const
  {
    return pairing_.touching(state.displacement);
  }
  contact::Point3 friction_force(const contact::SlidingPoint &, const State &) const;
};

} // namespace ballonet::solver
