// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/augmentation.h"
#include "solver/contact.h"
#include "solver/discretization.h"
#include "solver/parameters.h"
#include "solver/violation.h"
#include <functional>
#include <memory>

namespace ballonet::solver
{

/// All contact pairs of a problem: their contributions to the virtual work, and what must be true of a state before it
/// is accepted. Everything but points() is collective.
class ContactPairs
{
public:
  /// Both must outlive this. Throws std::invalid_argument for surfaces the mesh does not have.
  ContactPairs(const Parameters &parameters, const Discretization &discretization);
  ~ContactPairs();

  std::vector<VirtualWork *> works() const;
  /// Contact points of all pairs and ranks: entries of State::friction.
  std::size_t n_points() const { return n_points_; }

  const Augmentation &augmentation() const { return augmentation_; }

  /// Leaves the friction at the end of a converged step in its state.
  void end_step(State &end) const;

  /// Why a converged state must not be accepted (contact missed by the pairs of its last search, penetration, a node of
  /// one body inside another), or an empty string.
  std::string objection(const State &) const;

  /// What each pair transmits, summed over the ranks.
  std::vector<ContactSummary> summaries(const State &) const;
  /// Points in contact of each pair, this rank's part.
  std::vector<std::vector<ContactPoint>> points(const State &) const;

private:
  void build(const ContactPair &);
  void build_checks(const ContactPair &);
  template <class Check, class... Arguments>
  void add_check(const Arguments &...arguments);
  std::string missed(const State &, const std::vector<ContactSummary> &found) const;
  std::string intrusion(const State &) const;

  const Parameters &parameters_;
  const Discretization &discretization_;
  std::vector<std::unique_ptr<Contact>> contacts_;
  Augmentation augmentation_;
  /// Each finds the nodes that must not be where they are.
  std::vector<std::function<std::vector<Violation>(const State &)>> checks_;
  std::size_t n_points_ = 0;
};

} // namespace ballonet::solver
