// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_pairing.h"
#include <stdexcept>
#include <tuple>

namespace ballonet::solver::contact
{

namespace
{

void check(const ContactPair &pair)
{
  if (pair.thickness <= 0 || pair.stiffness <= 0 || pair.onset < 0 || pair.friction < 0)
    throw std::invalid_argument("contact pair \"" + pair.name +
                                "\": thickness and stiffness must be positive, onset and friction not negative");
}

/// A body's contact with itself would see its own patch at exactly the contact distance.
void check_apart(const ContactPair &pair, const std::vector<SecondaryFace> &faces,
                 const std::vector<PrimaryPatch> &patches)
{
  std::unordered_set<std::uint32_t> primary_cells;
  for (const PrimaryPatch &patch : patches)
    primary_cells.insert(patch.face.cell);
  for (const SecondaryFace &face : faces)
    if (primary_cells.count(face.face.cell))
      throw std::invalid_argument("contact pair \"" + pair.name + "\": a cell is both secondary and primary");
}

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

/// The patches near one face, and their distances as seen from one of its points.
struct ContactPairing::Candidates {
  const std::vector<PatchNodes> &nodes;
  const std::vector<Box> &boxes;
  std::vector<std::uint32_t> patches;
  std::vector<std::pair<double, std::uint32_t>> by_bound; ///< lower bound of the gap, patch
};

ContactPairing::ContactPairing(const Mesh &mesh, const ContactPair &pair,
                               const std::function<bool(std::uint32_t cell)> &owned, double margin)
    : mesh_(mesh), margin_(margin), quadrature_(pair.points_per_side)
{
  check(pair);
  faces_ = secondary_faces(mesh, pair.secondary, quadrature_, owned);
  patches_ = primary_patches(mesh, pair.primary, pair.thickness);
  check_apart(pair, faces_, patches_);
  for (const PrimaryPatch &patch : patches_)
    largest_radius_ = std::max(largest_radius_, patch.radius);
  pairings_.resize(faces_.size() * quadrature_.size());
}

/// The closest point, from patch to neighbouring patch as long as the gap shrinks.
PairedPoint ContactPairing::paired_point(std::uint32_t index, const Point3 &x, CurrentPatches &nodes) const
{
  constexpr int most_crossings = 3;
  const auto &[patch, xi] = pairings_[index];
  PairedPoint p = {index / quadrature_.size(), index % quadrature_.size(), patch, x, {}, 0};
  p.closest = closest_point(nodes[patch], patches_[patch].range, x, xi);
  p.penetration = patches_[patch].radius - p.closest.distance;
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
    if (!link || !coupled(p.face, link->patch))
      continue;
    const PrimaryPatch &next = patches_[link->patch];
    const ClosestPoint closest =
        closest_point(nodes[link->patch], next.range, p.position, across(here.closest.xi, side, *link, next));
    if (next.radius - closest.distance > p.penetration + 1e-12) {
      p.patch = link->patch;
      p.closest = closest;
      p.penetration = next.radius - closest.distance;
    }
  }
  return p.patch != here.patch;
}

void ContactPairing::begin_step()
{
  std::fill(pairings_.begin(), pairings_.end(), Pairing());
  couplings_.clear();
  coupled_.clear();
  crossing_ = true;
}

void ContactPairing::search(std::span<const double> displacement)
{
  const CurrentPosition position = {mesh_, displacement};
  std::vector<PatchNodes> nodes;
  std::vector<Box> boxes;
  for (const PrimaryPatch &patch : patches_) {
    nodes.push_back(at_depth(patch, position));
    boxes.push_back(enclosing_box(within_range(nodes.back(), patch.range)));
  }
  const BoxTree tree(boxes);
  Candidates candidates = {nodes, boxes, {}, {}};
  const std::size_t before = couplings_.size();
  paired_.clear();
  for (std::uint32_t f = 0; f < faces_.size(); ++f) {
    const PatchNodes face_nodes = at_nodes(faces_[f].nodes, position);
    candidates.patches.clear();
    tree.overlapping(enclosing_box(face_nodes).enlarged(largest_radius_ + margin_),
                     [&](std::uint32_t patch) { candidates.patches.push_back(patch); });
    std::sort(candidates.patches.begin(), candidates.patches.end());
    for (const std::uint32_t patch : candidates.patches)
      couple(f, patches_[patch].face.cell);
    for (std::uint32_t q = 0; q < quadrature_.size(); ++q) {
      const std::uint32_t index = f * quadrature_.size() + q;
      const Point3 x = interpolate(face_nodes, quadrature_.shapes[q].value);
      pairings_[index] = nearest(x, pairings_[index], candidates);
      if (pairings_[index].patch != none)
        paired_.push_back(index);
    }
  }
  if (couplings_.size() > before)
    look_ahead(position, tree);
}

/// Couples what may come within reach later, so that the couplings change seldom: each change costs a new matrix.
void ContactPairing::look_ahead(const CurrentPosition &position, const BoxTree &tree)
{
  for (std::uint32_t f = 0; f < faces_.size(); ++f)
    tree.overlapping(enclosing_box(at_nodes(faces_[f].nodes, position)).enlarged(largest_radius_ + 1.5 * margin_),
                     [&](std::uint32_t patch) { couple(f, patches_[patch].face.cell); });
}

/// The nearest patch. Of several that are equally near, as on a plane of symmetry, the previous one or else the first:
/// so rounding does not decide.
ContactPairing::Pairing ContactPairing::nearest(const Point3 &x, const Pairing &previous, Candidates &candidates) const
{
  constexpr double tie = 1e-9; // mm
  Pairing best;
  double smallest_gap = margin_;
  const auto rank = [&](std::uint32_t patch) { return patch == previous.patch ? -1 : std::int64_t(patch); };
  candidates.by_bound.clear();
  for (const std::uint32_t patch : candidates.patches) {
    const double bound = std::sqrt(candidates.boxes[patch].distance_square(x)) - patches_[patch].radius;
    if (bound < margin_)
      candidates.by_bound.push_back({patch == previous.patch ? -infinity : bound, patch});
  }
  std::sort(candidates.by_bound.begin(), candidates.by_bound.end());
  for (const auto &[bound, patch] : candidates.by_bound) {
    if (bound > smallest_gap + tie)
      break;
    const auto &[nodes, range] = std::tie(candidates.nodes[patch], patches_[patch].range);
    const ClosestPoint closest =
        patch == previous.patch ? closest_point(nodes, range, x, previous.xi) : closest_point(nodes, range, x);
    const double gap = closest.distance - patches_[patch].radius;
    const bool nearer = gap < smallest_gap - tie;
    const bool as_near = gap < smallest_gap + tie && best.patch != none;
    if (nearer || (as_near && rank(patch) < rank(best.patch)))
      best = {patch, closest.xi};
    if (nearer)
      smallest_gap = gap;
  }
  return best;
}

bool ContactPairing::coupled(std::uint32_t face, std::uint32_t patch) const
{
  return coupled_.count(std::uint64_t(face) << 32 | patches_[patch].face.cell) > 0;
}

void ContactPairing::couple(std::uint32_t face, std::uint32_t cell)
{
  if (coupled_.insert(std::uint64_t(face) << 32 | cell).second)
    couplings_.push_back({face, cell});
}

} // namespace ballonet::solver::contact
