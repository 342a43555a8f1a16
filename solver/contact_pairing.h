// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_search.h"
#include "solver/contact_surface.h"
#include "solver/parameters.h"
#include <algorithm>
#include <functional>
#include <limits>
#include <unordered_set>

namespace ballonet::solver::contact
{

/// A quadrature point of a patch with the patch of the other surface it looks at, in one state.
struct PairedPoint {
  std::uint32_t index; ///< among the points of this rank
  std::uint32_t own;   ///< the patch that the point is on
  Parameters2 own_xi;  ///< where
  double area;         ///< mm^2 at rest that it stands for
  std::size_t number;  ///< among the points of all ranks
  std::uint32_t patch; ///< of the other surface
  Point3 position;
  ClosestPoint closest;
  double penetration; ///< radius - distance; negative without contact
  double shift = 0;   ///< mm, of augmented contact: what is added to the penetration in the law

  double shifted_penetration() const { return penetration + shift; }
};

/// Both surfaces of a contact pair, and which patch of the other one each quadrature point looks at. The secondary
/// surface is taken as it is, the primary one at the depth `thickness` in its body. Contact begins where a point and a
/// patch come closer than the sum of their depths, whichever of them has the point. With one pass the points are on the
/// secondary surface, with two on both.
///
/// A surface may touch itself, or parts of its own body: where a face and a patch are closer than twice the thickness
/// at rest they are neighbours and never touch. Faces that are on both sides feel every contact twice, so they have
/// half the area.
///
/// search() decides; in between the choice is frozen and only the closest point is found anew. It may leave the patch
/// across a side into a neighbouring one: so sliding along a surface or around an edge is smooth, but a point never
/// jumps to another part of the surface.
class ContactPairing
{
public:
  ContactPairing(const Mesh &, const ContactPair &, const std::function<bool(std::uint32_t cell)> &owned,
                 double margin);

  /// Forgets pairs and couplings of the steps before: what follows depends on the state at hand alone, and the matrix
  /// does not keep room for places where contact has been.
  void begin_step();

  /// Pairs every point closer than the contact distance plus the margin with its nearest patch. A point keeps its patch
  /// when another one is equally near.
  void search(std::span<const double> displacement);

  /// The shifts of augmented contact for all points, by node; none: zero. Points are paired within the contact distance
  /// plus the largest shift plus the margin.
  void take_shifts(std::span<const double> shifts);

  /// Whether points may cross into neighbouring patches between two searches. In a concave corner two patches are
  /// equally near and a point could change sides for ever.
  void allow_crossing(bool allowed);

  /// The paired points that touch (positive shifted penetration) in ascending order, found once for all who ask at the
  /// same displacement. Valid until the next call.
  const std::vector<PairedPoint> &touching(std::span<const double> displacement) const;

  /// The (secondary patch, primary cell) pairs that have come within reach in this step: only these are ever paired.
  const std::vector<std::array<std::uint32_t, 2>> &couplings() const { return couplings_; }

  const Mesh &mesh() const { return mesh_; }
  /// The secondary patches, then the primary ones.
  const std::vector<Patch> &patches() const { return patches_; }
  bool is_secondary(std::uint32_t patch) const { return patch < n_secondary_; }
  std::uint32_t n_secondary() const { return n_secondary_; }
  std::size_t n_points() const { return points_.size(); }
  std::size_t n_points_of_all_ranks() const { return n_points_of_all_ranks_; }
  /// Nodes of the shifts of augmented contact; zero if the pair has none.
  std::size_t n_shifts() const { return n_shifts_; }
  /// The distance at which contact between two patches begins, mm.
  double radius(std::uint32_t a, std::uint32_t b) const { return patches_[a].depth + patches_[b].depth; }
  double largest_radius() const { return largest_radius_; }
  /// False for neighbours in the same body.
  bool may_touch(std::uint32_t a, std::uint32_t b) const
  {
    return neighbours_.empty() || neighbours_.count(pair_key(a, b)) == 0;
  }

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  struct PointOnPatch {
    std::uint32_t patch, point;
  };
  struct Pairing {
    std::uint32_t patch = none;
    Parameters2 xi = {0.5, 0.5}; ///< where the closest point was at the last search
  };
  class CurrentPatches;
  struct Surroundings;

  const Mesh &mesh_;
  double margin_, largest_radius_ = 0, largest_shift_ = 0;
  bool crossing_ = true;
  std::vector<Patch> patches_;
  std::uint32_t n_secondary_;
  std::vector<PointOnPatch> points_;
  std::size_t n_points_of_all_ranks_ = 0, n_shifts_ = 0;
  std::vector<double> shifts_;        ///< mm, one per point; empty: zero
  std::vector<Pairing> pairings_;     ///< one per point
  std::vector<std::uint32_t> paired_; ///< indices of the points that have a patch
  std::vector<std::array<std::uint32_t, 2>> couplings_;
  std::unordered_set<std::uint64_t> coupled_, neighbours_;
  struct Found {
    std::vector<double> displacement;
    std::vector<PairedPoint> points;
  };
  mutable Found found_; ///< what touching() has found last

  /// How far beyond the contact distance points are paired.
  double reach() const { return margin_ + largest_shift_; }
  void find_neighbours(double bound);
  static std::uint64_t pair_key(std::uint32_t a, std::uint32_t b)
  {
    return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
  }
  bool same_body(std::uint32_t a, std::uint32_t b) const
  {
    return mesh_.cell_body[patches_[a].face.cell] == mesh_.cell_body[patches_[b].face.cell];
  }
  bool reaches(std::uint32_t own, std::uint32_t patch, const Surroundings &, double margin) const;
  template <class Visit>
  void for_each_near(const Surroundings &, double margin, Visit visit) const;
  std::uint64_t coupling_key(std::uint32_t a, std::uint32_t b) const;
  void couple(std::uint32_t secondary, std::uint32_t primary);
  bool coupled(std::uint32_t a, std::uint32_t b) const { return coupled_.count(coupling_key(a, b)) > 0; }
  PairedPoint paired_point(std::uint32_t index, CurrentPatches &) const;
  bool cross(PairedPoint &, CurrentPatches &) const;
  Pairing nearest(std::uint32_t index, const std::vector<std::uint32_t> &candidates, const Surroundings &) const;
};

} // namespace ballonet::solver::contact
