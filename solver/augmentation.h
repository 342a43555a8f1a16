// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact.h"
#include "solver/contact_shift.h"
#include <mpi.h>
#include <string>
#include <utility>

namespace ballonet::solver
{

/// Uzawa's method for augmented contact: the shifts of all pairs, entries of State::contact_shift. The mean gap that is
/// left around a node in a converged state is added to its shift, which stays between zero and the pair's thickness (a
/// safeguarded multiplier: Birgin and Martinez 2014); a node around which nothing touches loses it. Collective.
class Augmentation
{
public:
  explicit Augmentation(MPI_Comm comm) : comm_(comm) {}

  /// Both must outlive this. Pairs without augmentation are passed over.
  void add(Contact &contact, const ContactPair &pair);
  /// Of all pairs.
  std::size_t n_shifts() const { return n_shifts_; }

  /// At the start of a step: takes back what the one before has left. The contacts have begun the step, the state is
  /// out of balance afterwards.
  void predict(State &) const;
  /// In a converged state, where more is left than the tolerance of a pair, unless it has been augmented as often as
  /// allowed: takes it back, so that the step must be solved again, and returns true.
  bool augment(State &, int augmentations) const;

  /// What is left in a converged state: the largest mean penetration, or separation caused by a shift, mm; and in words
  /// of a pair whose tolerance is not met.
  std::pair<double, std::string> remaining(const State &) const;

private:
  struct Shifts {
    Contact *contact;
    const ContactPair *pair;
    std::size_t first, end; ///< in State::contact_shift
  };

  MPI_Comm comm_;
  std::vector<Shifts> pairs_;
  std::size_t n_shifts_ = 0;

  contact::MeanGaps mean_gaps(const State &) const;
  static double error(const Shifts &, const contact::MeanGaps &, const State &);
  static void update(const Shifts &, const contact::MeanGaps &, State &);
};

} // namespace ballonet::solver
