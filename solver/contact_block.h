// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_surface.h"

namespace ballonet::solver::contact
{

/// The symmetric tangent of all contact between one secondary face (9 nodes) and one primary cell (27 nodes, after
/// those), whichever of them has the points. Normal contact of two patches is collected for their 9 + 9 nodes first and
/// spread to the cell once: a quarter of the work.
class ContactBlock
{
public:
  static constexpr std::size_t n_values = 3 * (9 + 27);

  /// Second variation of one point's energy as a quadratic form of five rows: the three components of
  /// delta x - delta y, and the products of the normal with delta y_,0 and delta y_,1. The point is x, y the closest
  /// one.
  using NormalForm = std::array<std::array<double, 5>, 5>;

  void clear();
  void add_normal(bool x_is_secondary, const std::array<double, 9> &x_shapes, const PatchShapes &y_shapes,
                  const Point3 &normal, const NormalForm &);
  /// Spreads the normal contact collected since the last call to the cell behind the primary patch.
  void spread(const Patch &primary);
  /// Adds the form of (sum of secondary values - sum of cell values), with the given weights of the nodes.
  void add_sliding(const NodeWeights &face_weights, const NodeWeights &cell_weights, const dealii::Tensor<2, 3> &form);

  std::span<const double> values() const { return values_; }

private:
  static constexpr std::size_t n_patch_values = 3 * (9 + 9);
  alignas(64) std::array<double, n_patch_values * n_patch_values> patch_values_{};
  alignas(64) std::array<double, n_values * n_values> values_{};
};

} // namespace ballonet::solver::contact
