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

/// Orthonormal axes as columns: along the first parameter of the point's patch, in the patch, normal to it.
dealii::Tensor<2, 3> axes_at(const PairedPoint &p, const ContactPairing &pairing, const CurrentPosition &position)
{
  const auto tangent = patch_point(at_depth(pairing.patches()[p.own], position), p.own_xi).tangent;
  const Point3 first = tangent[0] / tangent[0].norm(), normal = cross_product_3d(tangent[0], tangent[1]);
  const Point3 third = normal / normal.norm(), second = cross_product_3d(third, first);
  dealii::Tensor<2, 3> axes;
  for (int i = 0; i < 3; ++i)
    axes[i] = Point3({first[i], second[i], third[i]});
  return axes;
}

} // namespace

SlidingPoint sliding_point(const ContactPairing &pairing, const PairedPoint &paired,
                           std::span<const double> displacement, const FrictionPoint &friction)
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
  SlidingPoint p = {paired,
                    friction,
                    {face, node_weights(pairing.patches()[face], patch_shapes(on_face).value)},
                    {core, touched_material(pairing.patches()[core], on_core, from_core, position)},
                    {},
                    axes_at(paired, pairing, position)};
  p.offset = separation(p, pairing, position);
  return p;
}

dealii::Tensor<2, 3> turn(const SlidingPoint &p, const ContactPairing &pairing, std::span<const double> displacement)
{
  return axes_at(p.contact, pairing, {pairing.mesh(), displacement}) * transpose(p.axes);
}

Point3 slip(const SlidingPoint &p, const ContactPairing &pairing, std::span<const double> displacement)
{
  return in_plane(separation(p, pairing, {pairing.mesh(), displacement}) - p.offset, p.friction.normal);
}

} // namespace ballonet::solver::contact
