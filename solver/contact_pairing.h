// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_search.h"
#include "solver/contact_surface.h"
#include "solver/parameters.h"
#include <algorithm>
#include <limits>
#include <unordered_set>

namespace ballonet::solver::contact
{

/// A quadrature point of a secondary face with the patch it looks at, in one state.
struct PairedPoint {
  std::uint32_t face, point; ///< index of the secondary face, quadrature point on it
  std::uint32_t patch;
  Point3 position;
  ClosestPoint closest;
  double penetration; ///< radius of the patch - distance; negative without contact
};

/// Which patch each secondary point looks at. search() decides; in between the choice is frozen and only the closest
/// point is found anew. It may leave the patch across a side into a neighbouring one: so sliding along a surface or
/// around an edge is smooth, but a point never jumps to another part of the surface.
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

  /// Whether points may cross into neighbouring patches between two searches. In a concave corner two patches are
  /// equally near and a point could change sides for ever.
  void allow_crossing(bool allowed) { crossing_ = allowed; }

  /// Calls visit(index, PairedPoint) for all paired points in ascending order; index = face * points of a face + point.
  template <class Visit>
  void for_each(std::span<const double> displacement, Visit visit) const;

  /// The (face, cell) pairs that have come within reach in this step: only these are ever paired.
  const std::vector<std::array<std::uint32_t, 2>> &couplings() const { return couplings_; }

  const Mesh &mesh() const { return mesh_; }
  const FaceQuadrature &quadrature() const { return quadrature_; }
  const std::vector<SecondaryFace> &faces() const { return faces_; }
  const std::vector<PrimaryPatch> &patches() const { return patches_; }
  double largest_radius() const { return largest_radius_; }

private:
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  struct Pairing {
    std::uint32_t patch = none;
    Parameters2 xi = {0.5, 0.5}; ///< where the closest point was at the last search
  };
  struct Candidates;

  const Mesh &mesh_;
  double margin_, largest_radius_ = 0;
  bool crossing_ = true;
  FaceQuadrature quadrature_;
  std::vector<SecondaryFace> faces_;
  std::vector<PrimaryPatch> patches_;
  std::vector<Pairing> pairings_;     ///< one per point
  std::vector<std::uint32_t> paired_; ///< indices of the points that have a patch
  std::vector<std::array<std::uint32_t, 2>> couplings_;
  std::unordered_set<std::uint64_t> coupled_;

  class CurrentPatches;

  void couple(std::uint32_t face, std::uint32_t cell);
  void look_ahead(const CurrentPosition &, const BoxTree &);
  bool coupled(std::uint32_t face, std::uint32_t patch) const;
  PairedPoint paired_point(std::uint32_t index, const Point3 &x, CurrentPatches &) const;
  bool cross(PairedPoint &, CurrentPatches &) const;
  Pairing nearest(const Point3 &x, const Pairing &previous, Candidates &) const;
};

/// Nodes of the patches in one state, found when first asked for.
class ContactPairing::CurrentPatches
{
public:
  CurrentPatches(const ContactPairing &pairing, const CurrentPosition &position)
      : patches_(pairing.patches_), position_(position), nodes_(patches_.size()), known_(patches_.size(), false)
  {
  }

  const PatchNodes &operator[](std::uint32_t patch)
  {
    if (!known_[patch]) {
      nodes_[patch] = at_depth(patches_[patch], position_);
      known_[patch] = true;
    }
    return nodes_[patch];
  }

private:
  const std::vector<PrimaryPatch> &patches_;
  CurrentPosition position_;
  std::vector<PatchNodes> nodes_;
  std::vector<bool> known_;
};

template <class Visit>
void ContactPairing::for_each(std::span<const double> displacement, Visit visit) const
{
  const CurrentPosition position = {mesh_, displacement};
  CurrentPatches patches(*this, position);
  PatchNodes face_nodes;
  std::uint32_t present = none;
  for (const std::uint32_t index : paired_) {
    const std::uint32_t face = index / quadrature_.size();
    if (face != present)
      face_nodes = at_nodes(faces_[present = face].nodes, position);
    const Point3 x = interpolate(face_nodes, quadrature_.shapes[index % quadrature_.size()].value);
    visit(index, paired_point(index, x, patches));
  }
}

} // namespace ballonet::solver::contact
