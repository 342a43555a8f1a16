// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_pairing.h"
#include "solver/contact_pair_patches.h"
#include "solver/contact_shift.h"
#include <algorithm>

namespace ballonet::solver::contact
{

namespace
{

/// For each parameter the side beyond which the point would be nearer, or -1.
std::array<int, 2> sides_reached(const ClosestPoint &c)
{
  std::array<int, 2> sides = {-1, -1};
  for (int a = 0; a < 2; ++a)
    if (!c.free[a])
      sides[a] = 2 * a + (c.normal * c.tangent[a] > 0);
  return sides;
}

} // namespace

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
  const std::vector<Patch> &patches_;
  CurrentPosition position_;
  std::vector<PatchNodes> nodes_;
  std::vector<bool> known_;
};

/// All patches in one state, and the primary ones in a tree.
struct ContactPairing::Surroundings {
  std::vector<PatchNodes> nodes;
  std::vector<Box> boxes;
  BoxTree primary;

  Surroundings(const ContactPairing &pairing, const CurrentPosition &position)
      : nodes(all_nodes(pairing, position)), boxes(all_boxes(pairing, nodes)),
        primary({boxes.begin() + pairing.n_secondary_, boxes.end()})
  {
  }

  static std::vector<PatchNodes> all_nodes(const ContactPairing &pairing, const CurrentPosition &position)
  {
    std::vector<PatchNodes> nodes;
    for (const Patch &patch : pairing.patches_)
      nodes.push_back(at_depth(patch, position));
    return nodes;
  }

  static std::vector<Box> all_boxes(const ContactPairing &pairing, const std::vector<PatchNodes> &nodes)
  {
    std::vector<Box> boxes;
    for (std::size_t p = 0; p < nodes.size(); ++p)
      boxes.push_back(enclosing_box(within_range(nodes[p], pairing.patches_[p].range)));
    return boxes;
  }
};

ContactPairing::ContactPairing(const Mesh &mesh, const ContactPair &pair,
                               const std::function<bool(std::uint32_t cell)> &owned, double margin)
    : mesh_(mesh), margin_(margin)
{
  patches_ = patches_of_pair(mesh, pair);
  if (pair.enforcement != Enforcement::penalty)
    n_shifts_ = number_shift_nodes(patches_);
  n_secondary_ = 0;
  for (std::uint32_t p = 0; p < patches_.size(); ++p) {
    Patch &patch = patches_[p];
    n_secondary_ += patch.depth == 0;
    largest_radius_ = std::max(largest_radius_, patch.depth);
    patch.first_point = n_points_of_all_ranks_;
    n_points_of_all_ranks_ += patch.points.size();
    if (!owned(patch.face.cell))
      patch.points.clear();
    for (std::uint32_t q = 0; q < patch.points.size(); ++q)
      points_.push_back({p, q});
  }
  pairings_.resize(points_.size());
  if (touches_itself(mesh, patches_, n_secondary_))
    find_neighbours(2 * pair.thickness);
}

/// Pairs of the same body that are closer than `bound` at rest, or than twice that and do not face each other.
void ContactPairing::find_neighbours(double bound)
{
  const std::vector<double> rest(3 * mesh_.nodes.size());
  const Surroundings now(*this, {mesh_, rest});
  for (std::uint32_t s = 0; s < n_secondary_; ++s)
    now.primary.overlapping(now.boxes[s].enlarged(2 * bound), [&](std::uint32_t index) {
      const std::uint32_t p = n_secondary_ + index;
      if (!same_body(s, p))
        return;
      const Face face = patches_[s].face, other = patches_[p].face;
      const double distance = distance_of(now.nodes[s], now.nodes[p], patches_[p].range);
      if (distance < bound || (distance < 2 * bound && !face_each_other(now.nodes[s], face, now.nodes[p], other)))
        neighbours_.insert(pair_key(s, p));
    });
}

/// The closest point, from patch to neighbouring patch as long as the gap shrinks.
PairedPoint ContactPairing::paired_point(std::uint32_t index, CurrentPatches &nodes) const
{
  constexpr int most_crossings = 3;
  const auto [own, point] = points_[index];
  const auto &[patch, xi] = pairings_[index];
  const auto &[own_xi, area] = patches_[own].points[point];
  const std::size_t number = patches_[own].first_point + point;
  PairedPoint p = {index, own, own_xi, area, number, patch, interpolate(nodes[own], patch_shapes(own_xi).value), {}, 0};
  p.closest = closest_point(nodes[patch], patches_[patch].range, p.position, xi);
  p.penetration = radius(own, patch) - p.closest.distance;
  p.shift = shifts_.empty() ? 0 : shifts_[index];
  for (int k = 0; crossing_ && k < most_crossings && cross(p, nodes); ++k) {
  }
  return p;
}

/// Moves to a neighbouring patch that is nearer, if there is one.
bool ContactPairing::cross(PairedPoint &p, CurrentPatches &nodes) const
{
  const PairedPoint here = p;
  for (const int side : sides_reached(here.closest)) {
    const auto link = side < 0 ? std::nullopt : patches_[here.patch].neighbour[side];
    if (!link || !coupled(p.own, link->patch) || !may_touch(p.own, link->patch))
      continue;
    const Patch &next = patches_[link->patch];
    const ClosestPoint closest =
        closest_point(nodes[link->patch], next.range, p.position, across(here.closest.xi, side, *link, next));
    const double penetration = radius(p.own, link->patch) - closest.distance;
    if (penetration > p.penetration + 1e-12) {
      p.patch = link->patch;
      p.closest = closest;
      p.penetration = penetration;
    }
  }
  return p.patch != here.patch;
}

const std::vector<PairedPoint> &ContactPairing::touching(std::span<const double> displacement) const
{
  if (std::ranges::equal(displacement, found_.displacement))
    return found_.points;
  found_.displacement.assign(displacement.begin(), displacement.end());
  found_.points.clear();
  CurrentPatches patches(*this, {mesh_, displacement});
  for (const std::uint32_t index : paired_)
    if (const PairedPoint p = paired_point(index, patches); p.shifted_penetration() > 0)
      found_.points.push_back(p);
  return found_.points;
}

void ContactPairing::allow_crossing(bool allowed)
{
  if (allowed != crossing_)
    found_.displacement.clear();
  crossing_ = allowed;
}

void ContactPairing::take_shifts(std::span<const double> shifts)
{
  found_.displacement.clear();
  largest_shift_ = shifts.empty() ? 0 : *std::ranges::max_element(shifts);
  shifts_.clear();
  if (largest_shift_ > 0)
    for (const auto [patch, point] : points_)
      shifts_.push_back(shift_at(patches_[patch], patches_[patch].points[point].xi, shifts));
}

void ContactPairing::begin_step()
{
  found_.displacement.clear();
  std::fill(pairings_.begin(), pairings_.end(), Pairing());
  couplings_.clear();
  coupled_.clear();
  crossing_ = true;
}

/// Whether a point of one patch is closer to another one than the contact distance plus the margin.
bool ContactPairing::reaches(std::uint32_t own, std::uint32_t patch, const Surroundings &now, double margin) const
{
  const double reach = radius(own, patch) + margin;
  const auto &points = patches_[own].points;
  return std::any_of(points.begin(), points.end(), [&](const QuadraturePoint &point) {
    const Point3 x = interpolate(now.nodes[own], patch_shapes(point.xi).value);
    return now.boxes[patch].distance_square(x) < reach * reach &&
           closest_point(now.nodes[patch], patches_[patch].range, x).distance < reach;
  });
}

/// Calls visit(secondary, primary) for the patches whose boxes are closer than the contact distance plus the margin, if
/// one of them has points. Within a body, where many boxes overlap that never touch and every coupling makes the matrix
/// denser, only if a point is that close.
template <class Visit>
void ContactPairing::for_each_near(const Surroundings &now, double margin, Visit visit) const
{
  for (std::uint32_t s = 0; s < n_secondary_; ++s)
    now.primary.overlapping(now.boxes[s].enlarged(largest_radius_ + margin), [&](std::uint32_t index) {
      const std::uint32_t p = n_secondary_ + index;
      if ((patches_[s].points.empty() && patches_[p].points.empty()) || !may_touch(s, p))
        return;
      if (!same_body(s, p) || coupled(s, p) || reaches(s, p, now, margin) || reaches(p, s, now, margin))
        visit(s, p);
    });
}

void ContactPairing::search(std::span<const double> displacement)
{
  found_.displacement.clear();
  const Surroundings now(*this, {mesh_, displacement});
  std::vector<std::vector<std::uint32_t>> near(patches_.size());
  const std::size_t before = couplings_.size();
  for_each_near(now, reach(), [&](std::uint32_t secondary, std::uint32_t primary) {
    near[secondary].push_back(primary);
    near[primary].push_back(secondary);
    couple(secondary, primary);
  });
  paired_.clear();
  for (std::uint32_t index = 0; index < points_.size(); ++index) {
    pairings_[index] = nearest(index, near[points_[index].patch], now);
    if (pairings_[index].patch != none)
      paired_.push_back(index);
  }
  if (couplings_.size() > before) // couple what may come within reach later too: each change costs a new matrix
    for_each_near(now, reach() + 0.5 * margin_,
                  [&](std::uint32_t secondary, std::uint32_t primary) { couple(secondary, primary); });
}

/// The nearest patch. Of several that are equally near, as on a plane of symmetry, the previous one or else the first:
/// so rounding does not decide. In a concave corner or kink the point may come to rest where two patches are equally
/// near and would change sides in every iteration: it leaves the inside of a patch only for one that is clearly nearer.
ContactPairing::Pairing ContactPairing::nearest(std::uint32_t index, const std::vector<std::uint32_t> &candidates,
                                                const Surroundings &now) const
{
  if (candidates.empty())
    return {};
  constexpr double tie = 1e-9, hysteresis = 0.02; // mm; share of the radius
  const auto [own, point] = points_[index];
  const Point3 x = interpolate(now.nodes[own], patch_shapes(patches_[own].points[point].xi).value);
  const Pairing &previous = pairings_[index];
  Pairing best;
  double smallest_gap = reach();
  const auto rank = [&](std::uint32_t patch) { return patch == previous.patch ? -1 : std::int64_t(patch); };
  std::vector<std::pair<double, std::uint32_t>> by_bound; // lower bound of the gap, patch
  for (const std::uint32_t patch : candidates) {
    const double bound = std::sqrt(now.boxes[patch].distance_square(x)) - radius(own, patch);
    if (bound < reach())
      by_bound.push_back({patch == previous.patch ? -infinity : bound, patch});
  }
  std::sort(by_bound.begin(), by_bound.end());
  for (const auto &[bound, patch] : by_bound) {
    if (bound > smallest_gap + tie)
      break;
    const PatchNodes &nodes = now.nodes[patch];
    const PatchRange &range = patches_[patch].range;
    const ClosestPoint closest =
        patch == previous.patch ? closest_point(nodes, range, x, previous.xi) : closest_point(nodes, range, x);
    const bool stays_inside = patch == previous.patch && closest.free[0] && closest.free[1];
    const double gap = closest.distance - (stays_inside ? 1 + hysteresis : 1) * radius(own, patch);
    const bool nearer = gap < smallest_gap - tie;
    const bool as_near = gap < smallest_gap + tie && best.patch != none;
    if (nearer || (as_near && rank(patch) < rank(best.patch)))
      best = {patch, closest.xi};
    if (nearer)
      smallest_gap = gap;
  }
  return best;
}

/// Of the secondary patch (which comes first in the list) and the cell of the primary one.
std::uint64_t ContactPairing::coupling_key(std::uint32_t a, std::uint32_t b) const
{
  return std::uint64_t(std::min(a, b)) << 32 | patches_[std::max(a, b)].face.cell;
}

void ContactPairing::couple(std::uint32_t secondary, std::uint32_t primary)
{
  if (coupled_.insert(coupling_key(secondary, primary)).second)
    couplings_.push_back({secondary, patches_[primary].face.cell});
}

} // namespace ballonet::solver::contact
