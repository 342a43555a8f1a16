// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_pairing.h"
#include <algorithm>
#include <cmath>

namespace ballonet::solver::contact
{

/// A point stays this share of the radius away from the patches of the other surface: inside, the direction of the
/// contact force would become uncertain, and beyond lies the other side.
constexpr double core_share = 0.3;

/// The largest part of `fraction` on the way to which distance(f) stays above `lowest`, or above its start if that is
/// lower, to 1/256. distance changes by at most `speed` per unit of f. Goes along the way by what is free at each stop,
/// and at least by `stride` (mm): nothing is jumped over that takes twice that to cross.
template <class Distance>
double fraction_above(const Distance &distance, double speed, double lowest, double stride, double fraction)
{
  double present = distance(0.), good = 0;
  lowest = std::min(lowest, present - 1e-9 * std::abs(present));
  while (good < fraction && present <= lowest + (fraction - good) * speed) {
    double bad = std::min(good + std::max(present - lowest, stride) / speed, fraction);
    present = distance(bad);
    if (present >= lowest) {
      good = bad;
      continue;
    }
    for (int k = 0; k < 8; ++k) {
      const double middle = (good + bad) / 2;
      (distance(middle) < lowest ? bad : good) = middle;
    }
    return good > 0 ? good : bad;
  }
  return fraction;
}

/// The largest fraction (0, 1] of the increment such that no point enters the core of any patch on its way
/// there, also if it would come out on the other side; a point already in the core must not go deeper. All patches are
/// looked at, whatever the pairing. Increments that move point and patch together cost nothing.
double largest_fraction(const ContactPairing &, std::span<const double> displacement,
                        std::span<const double> increment);

} // namespace ballonet::solver::contact
