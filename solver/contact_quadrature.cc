// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_quadrature.h"
#include <cmath>
#include <deal.II/base/quadrature_lib.h>

namespace ballonet::solver::contact
{

namespace
{

using Rule = dealii::Quadrature<1>;

double area_density(const PatchNodes &nodes, const Parameters2 &xi)
{
  const PatchPoint p = patch_point(nodes, xi);
  return cross_product_3d(p.tangent[0], p.tangent[1]).norm();
}

/// Spreads a product rule over the patch's range; the areas are those of the whole face.
std::vector<QuadraturePoint> spread(const Mesh &mesh, const Patch &patch, const std::array<Rule, 2> &rules,
                                    double share)
{
  const PatchNodes nodes = face_at_rest(mesh, patch.face);
  const auto &[low, high] = patch.range;
  std::vector<QuadraturePoint> points;
  for (unsigned int j = 0; j < rules[1].size(); ++j)
    for (unsigned int i = 0; i < rules[0].size(); ++i) {
      const Parameters2 t = {rules[0].point(i)[0], rules[1].point(j)[0]};
      const double weight = share * rules[0].weight(i) * rules[1].weight(j);
      points.push_back(
          {{low[0] + t[0] * (high[0] - low[0]), low[1] + t[1] * (high[1] - low[1])}, weight * area_density(nodes, t)});
    }
  return points;
}

/// Equal intervals with a point in the middle of each, shifted so that a point lies on each trimmed end, where it has
/// half the weight. Where the surface goes on there is none: two patches would have it both, and matching meshes would
/// put it on the line between two others. Equal weights make sliding smooth.
Rule equidistant(double length, double spacing, bool low_end, bool high_end)
{
  if (length == 0)
    return dealii::QMidpoint<1>();
  const double beyond = low_end != high_end ? 0.5 : 0; // half of the last interval
  const double whole = std::max(2., std::ceil(length / spacing + beyond - 1e-9)), n = whole - beyond;
  const auto size = static_cast<std::size_t>(whole) + (low_end && high_end);
  std::vector<dealii::Point<1>> points;
  std::vector<double> weights(size, 1 / n);
  for (std::size_t k = 0; k < size; ++k)
    points.emplace_back((static_cast<double>(k) + (low_end ? 0 : 0.5)) / n);
  if (low_end)
    weights.front() /= 2;
  if (high_end)
    weights.back() /= 2;
  return {points, weights};
}

/// Length of the patch along a parameter through its middle, mm at rest.
double length_along(const Mesh &mesh, const Patch &patch, int parameter)
{
  const auto &[low, high] = patch.range;
  const Parameters2 middle = {(low[0] + high[0]) / 2, (low[1] + high[1]) / 2};
  const PatchPoint p = patch_point(at_depth(patch, ReferencePosition{mesh}), middle);
  return (high[parameter] - low[parameter]) * p.tangent[parameter].norm();
}

} // namespace

std::vector<QuadraturePoint> gauss_points(const Mesh &mesh, const Patch &patch, int per_side, double share)
{
  const dealii::QGauss<1> rule(per_side);
  return spread(mesh, patch, {rule, rule}, share);
}

std::vector<QuadraturePoint> points_with_edges(const Mesh &mesh, const Patch &patch, double spacing, double share)
{
  auto along = [&](int a) {
    return equidistant(length_along(mesh, patch, a), spacing, patch.range.low[a] > 0, patch.range.high[a] < 1);
  };
  return spread(mesh, patch, {along(0), along(1)}, share);
}

} // namespace ballonet::solver::contact
