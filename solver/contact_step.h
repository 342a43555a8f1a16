// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_pairing.h"

namespace ballonet::solver::contact
{

/// A point stays this share of the radius away from the patches of the other surface: inside, the direction of the
/// contact force would become uncertain, and beyond lies the other side.
constexpr double core_share = 0.3;

/// The largest fraction (0, 1] of the increment such that no point enters the core of any patch on its way
/// there, also if it would come out on the other side; a point already in the core must not go deeper. All patches are
/// looked at, whatever the pairing. Increments that move point and patch together cost nothing.
double largest_fraction(const ContactPairing &, std::span<const double> displacement,
                        std::span<const double> increment);

} // namespace ballonet::solver::contact
