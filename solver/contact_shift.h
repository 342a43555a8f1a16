// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_surface.h"

namespace ballonet::solver::contact
{

// The multiplier of the augmented Lagrangian method, kept as a length: the pressure at a point is law(g + s) with its
// penetration g and the shift s >= 0, a bilinear field over the corners of the faces that have contact points. There
// are far fewer corners than displacements of the surface, so the shifts remain bounded where points, one by one, could
// not all be brought to g = 0 (at an edge that presses into a coarse face).

/// Numbers the corners of the patches that have points, each side of the pair for itself; returns their number.
std::size_t number_shift_nodes(std::span<Patch> patches);

/// Those of a pair in a state: `n` from `first` on; none if the state has none.
std::span<const double> shifts_of_pair(const State &, std::size_t first, std::size_t n);

/// The shift at a place of a patch, mm; zero if there are no shifts.
double shift_at(const Patch &, const Parameters2 &xi, std::span<const double> shifts);

/// Sums over the contact points around the nodes of the shifts, for the gaps there in the mean. The weight is the
/// pressure: a node's pressure does no work on a gap whose mean is zero, and points that begin to touch come in
/// smoothly.
struct MeanGaps {
  std::vector<double> force;  ///< N
  std::vector<double> moment; ///< force times penetration, N mm

  explicit MeanGaps(std::size_t n_nodes) : force(n_nodes), moment(n_nodes) {}
  /// Shares the force (N) of a point and its penetration (mm) among the corners of its patch; those of the pair begin
  /// at `first`.
  void add(const Patch &, const Parameters2 &xi, std::size_t first, double normal_force, double penetration);
  /// mm; zero where nothing touches.
  double penetration(std::size_t node) const { return force[node] > 0 ? moment[node] / force[node] : 0; }
};

} // namespace ballonet::solver::contact
