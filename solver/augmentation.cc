// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/augmentation.h"
#include <algorithm>
#include <cmath>

namespace ballonet::solver
{

using contact::MeanGaps;

void Augmentation::add(Contact &contact, const ContactPair &pair)
{
  const std::size_t first = n_shifts_;
  n_shifts_ = contact.number_shifts_from(first);
  if (n_shifts_ > first)
    pairs_.push_back({&contact, &pair, first, n_shifts_});
}

/// Around the nodes of all pairs, summed over the ranks.
MeanGaps Augmentation::mean_gaps(const State &state) const
{
  MeanGaps gaps(n_shifts_);
  for (const Shifts &shifts : pairs_)
    shifts.contact->add_gaps(state, gaps);
  for (auto *sums : {&gaps.force, &gaps.moment})
    MPI_Allreduce(MPI_IN_PLACE, sums->data(), static_cast<int>(sums->size()), MPI_DOUBLE, MPI_SUM, comm_);
  return gaps;
}

/// How far a pair is from 0 <= shift, penetration <= 0, one of them zero, at the worst node, mm: |min(shift,
/// -penetration)|.
double Augmentation::error(const Shifts &shifts, const MeanGaps &gaps, const State &state)
{
  double largest = 0;
  for (std::size_t n = shifts.first; n < shifts.end; ++n)
    if (gaps.force[n] > 0)
      largest = std::max(largest, std::abs(std::min(state.contact_shift[n], -gaps.penetration(n))));
  return largest;
}

void Augmentation::update(const Shifts &shifts, const MeanGaps &gaps, State &state)
{
  for (std::size_t n = shifts.first; n < shifts.end; ++n) {
    double &shift = state.contact_shift[n];
    shift = gaps.force[n] > 0 ? std::clamp(shift + gaps.penetration(n), 0., shifts.pair->thickness) : 0;
  }
  shifts.contact->take_shifts(state);
}

void Augmentation::predict(State &state) const
{
  if (n_shifts_ == 0)
    return;
  const MeanGaps gaps = mean_gaps(state);
  for (const Shifts &shifts : pairs_)
    update(shifts, gaps, state);
}

bool Augmentation::augment(State &state, int augmentations) const
{
  if (n_shifts_ == 0)
    return false;
  const MeanGaps gaps = mean_gaps(state);
  bool changed = false;
  for (const Shifts &shifts : pairs_)
    if (augmentations < shifts.pair->max_augmentations &&
        error(shifts, gaps, state) > shifts.pair->augmentation_tolerance) {
      update(shifts, gaps, state);
      changed = true;
    }
  return changed;
}

std::pair<double, std::string> Augmentation::remaining(const State &state) const
{
  if (n_shifts_ == 0)
    return {};
  double largest = 0;
  std::string shortfall;
  const MeanGaps gaps = mean_gaps(state);
  for (const Shifts &shifts : pairs_) {
    const ContactPair &pair = *shifts.pair;
    const double left = error(shifts, gaps, state);
    largest = std::max(largest, left);
    if (left > pair.augmentation_tolerance)
      shortfall = "contact pair \"" + pair.name + "\": " + std::to_string(left) +
                  " mm of penetration are left in the mean, asked for were " +
                  std::to_string(pair.augmentation_tolerance);
  }
  return {largest, shortfall};
}

} // namespace ballonet::solver
