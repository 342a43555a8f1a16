// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_friction.h"
#include <cmath>
#include <deal.II/base/symmetric_tensor.h>

namespace ballonet::solver::contact
{

namespace
{

/// Values of the 27 shape functions (or a derivative) from those along the columns and into the depth.
NodeWeights product(const Patch &patch, const std::array<double, 9> &in_plane, const std::array<double, 3> &depth)
{
  NodeWeights weights;
  for (std::size_t c = 0; c < 9; ++c)
    for (std::size_t k = 0; k < 3; ++k)
      weights[patch.place(c, k)] = in_plane[c] * depth[k];
  return weights;
}

/// Weights of the material point that lies at y(xi) + r: y + sum c_k g_k with the base vectors g_k of the cell there.
NodeWeights touched_material(const Patch &patch, const Parameters2 &xi, const Point3 &r,
                             const CurrentPosition &position)
{
  const PatchShapes shapes = patch_shapes(xi);
  const auto slope = quadratic_slope(patch.depth_fraction);
  const std::array<NodeWeights, 3> derivative = {product(patch, shapes.derivative[0], patch.layer_weight),
                                                 product(patch, shapes.derivative[1], patch.layer_weight),
                                                 product(patch, shapes.value, slope)};
  dealii::Tensor<2, 3> base; // columns are the base vectors
  for (int k = 0; k < 3; ++k) {
    const Point3 g = weighted_sum(patch, derivative[k], position);
    for (int i = 0; i < 3; ++i)
      base[i][k] = g[i];
  }
  NodeWeights weights = product(patch, shapes.value, patch.layer_weight);
  if (std::abs(determinant(base)) < 1e-6 * std::pow(base.norm(), 3))
    return weights; // a collapsed cell: slide against y itself
  const Point3 c = invert(base) * r;
  for (int b = 0; b < 27; ++b)
    weights[b] += c[0] * derivative[0][b] + c[1] * derivative[1][b] + c[2] * derivative[2][b];
  return weights;
}

Point3 separation(const SlidingPoint &p, const ContactPairing &pairing, const CurrentPosition &position)
{
  auto at = [&](const MaterialPoint &point) {
    return weighted_sum(pairing.patches()[point.patch], point.weights, position);
  };
  return at(p.secondary) - at(p.primary);
}

} // namespace

SlidingPoint sliding_point(const ContactPairing &pairing, const PairedPoint &paired,
                           std::span<const double> displacement, double limit)
{
  const CurrentPosition position = {pairing.mesh(), displacement};
  const ClosestPoint &closest = paired.closest;
  const bool felt_by_secondary = pairing.is_secondary(paired.own);
  std::uint32_t face = paired.own, core = paired.patch;
  Parameters2 on_face = paired.own_xi, on_core = closest.xi;
  if (!felt_by_secondary) {
    std::swap(face, core);
    std::swap(on_face, on_core);
  }
  const Point3 from_core = (felt_by_secondary ? 1 : -1) * closest.distance * closest.normal;
  SlidingPoint p = {paired.number,
                    paired.area,
                    {face, node_weights(pairing.patches()[face], patch_shapes(on_face).value)},
                    {core, touched_material(pairing.patches()[core], on_core, from_core, position)},
                    limit,
                    closest.normal,
                    {}};
  p.offset = separation(p, pairing, position);
  return p;
}

Point3 slip(const SlidingPoint &p, const ContactPairing &pairing, std::span<const double> displacement)
{
  const Point3 moved = separation(p, pairing, {pairing.mesh(), displacement}) - p.offset;
  return moved - (moved * p.normal) * p.normal;
}

Point3 into_plane(const Point3 &traction, const Point3 &normal)
{
  const Point3 tangential = traction - (traction * normal) * normal;
  const double size = tangential.norm();
  return size > 0 ? traction.norm() / size * tangential : Point3();
}

Point3 FrictionLaw::slip_of(const Point3 &share) const
{
  constexpr double most = 0.995;
  const double size = share.norm(), r = std::min(size, most);
  return size > 0 ? elastic_slip * r / std::sqrt(1 - r * r) / size * share : Point3();
}

double FrictionLaw::energy(const SlidingPoint &p, const Point3 &slip) const
{
  const double s = elastic_slip * elastic_slip;
  return p.limit * (std::sqrt((p.elastic_slip + slip).norm_square() + s) - std::sqrt(p.elastic_slip.norm_square() + s) +
                    slip.norm_square() / (2 * viscous_slip));
}

Point3 FrictionLaw::remembered_force(const SlidingPoint &p, const Point3 &slip) const
{
  const Point3 e = p.elastic_slip + slip;
  return p.limit / std::sqrt(e.norm_square() + elastic_slip * elastic_slip) * e;
}

Point3 FrictionLaw::force(const SlidingPoint &p, const Point3 &slip) const
{
  return remembered_force(p, slip) + p.limit / viscous_slip * slip;
}

dealii::Tensor<2, 3> FrictionLaw::tangent(const SlidingPoint &p, const Point3 &slip) const
{
  const Point3 e = p.elastic_slip + slip;
  const double square = e.norm_square() + elastic_slip * elastic_slip;
  dealii::Tensor<2, 3> plane = dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>());
  plane -= outer_product(p.normal, p.normal);
  return p.limit / std::sqrt(square) * (plane - outer_product(e, e) / square) + p.limit / viscous_slip * plane;
}

} // namespace ballonet::solver::contact
