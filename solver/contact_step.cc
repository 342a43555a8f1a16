// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_step.h"
#include <cmath>

namespace ballonet::solver::contact
{

namespace
{

/// A biquadratic patch or face on its way: nodes + fraction * increment.
struct MovingPatch {
  PatchNodes nodes, increment;
  Box start, swept;

  MovingPatch(const PatchNodes &from, const PatchNodes &by) : nodes(from), increment(by), start(enclosing_box(from))
  {
    swept = start;
    swept.include(enclosing_box(at(1)));
  }

  PatchNodes at(double fraction) const
  {
    PatchNodes moved;
    for (int a = 0; a < 9; ++a)
      moved[a] = nodes[a] + fraction * increment[a];
    return moved;
  }
};

/// A point of one surface, and the patch of the other one that it might run into.
struct Approach {
  Point3 x, increment;
  const MovingPatch &moving;
  const PatchRange &range;
  double core; ///< mm, how near it may come

  /// Upper bound of the relative displacement; 1.25^2 is the Lebesgue constant of biquadratic interpolation.
  double relative_displacement() const
  {
    double square = 0;
    for (const Point3 &node : moving.increment)
      square = std::max(square, (increment - node).norm_square());
    return 1.5625 * std::sqrt(square);
  }

  double distance(double fraction) const
  {
    return closest_point(moving.at(fraction), range, x + fraction * increment).distance;
  }
};

double limited(const Approach &approach, double fraction)
{
  const double core = approach.core;
  const double speed = approach.relative_displacement(); // mm per fraction
  const double box_distance = std::sqrt(approach.moving.start.distance_square(approach.x));
  if (speed == 0 || box_distance > core + fraction * speed)
    return fraction;
  return fraction_above([&](double f) { return approach.distance(f); }, speed, core, core, fraction);
}

std::vector<MovingPatch> moving_patches(const ContactPairing &pairing, const CurrentPosition &position,
                                        const NodalField &increment)
{
  std::vector<MovingPatch> moving;
  for (const Patch &patch : pairing.patches())
    moving.emplace_back(at_depth(patch, position), at_depth(patch, increment));
  return moving;
}

BoxTree tree_of(std::span<const MovingPatch> moving)
{
  std::vector<Box> boxes;
  for (const MovingPatch &patch : moving)
    boxes.push_back(patch.swept);
  return BoxTree(std::move(boxes));
}

} // namespace

double largest_fraction(const ContactPairing &pairing, std::span<const double> displacement,
                        std::span<const double> increment)
{
  const std::vector<MovingPatch> moving = moving_patches(pairing, {pairing.mesh(), displacement}, {increment});
  const BoxTree primary = tree_of(std::span(moving).subspan(pairing.n_secondary()));
  double fraction = 1;
  auto approach = [&](std::uint32_t own, std::uint32_t other) {
    const double core = core_share * pairing.radius(own, other);
    for (const QuadraturePoint &point : pairing.patches()[own].points) {
      const auto shapes = patch_shapes(point.xi).value;
      const Point3 x = interpolate(moving[own].nodes, shapes), dx = interpolate(moving[own].increment, shapes);
      fraction = limited({x, dx, moving[other], pairing.patches()[other].range, core}, fraction);
    }
  };
  for (std::uint32_t s = 0; s < pairing.n_secondary(); ++s)
    primary.overlapping(moving[s].swept.enlarged(core_share * pairing.largest_radius()), [&](std::uint32_t index) {
      const std::uint32_t p = pairing.n_secondary() + index;
      if (!pairing.may_touch(s, p))
        return;
      approach(s, p);
      approach(p, s);
    });
  return fraction;
}

} // namespace ballonet::solver::contact
