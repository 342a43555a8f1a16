// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/friction_law.h"
#include <algorithm>
#include <cmath>
#include <deal.II/base/symmetric_tensor.h>

namespace ballonet::solver::contact
{

FrictionPoint FrictionLaw::begin(double strength, double area, const Point3 &normal, const Point3 &traction) const
{
  constexpr double most = 0.995;
  FrictionPoint point = {strength * area, normal, {}};
  const Point3 tangential = in_plane(traction, normal);
  if (const double size = tangential.norm(); strength > 0 && size > 0) {
    const double share = std::min(traction.norm() / strength, most);
    point.elastic_slip = elastic_slip * share / std::sqrt(1 - share * share) / size * tangential;
  }
  return point;
}

double FrictionLaw::energy(const FrictionPoint &p, const Point3 &slip) const
{
  const double s = elastic_slip * elastic_slip;
  return p.limit * (std::sqrt((p.elastic_slip + slip).norm_square() + s) - std::sqrt(p.elastic_slip.norm_square() + s) +
                    slip.norm_square() / (2 * viscous_slip));
}

Point3 FrictionLaw::remembered_force(const FrictionPoint &p, const Point3 &slip) const
{
  const Point3 e = p.elastic_slip + slip;
  return p.limit / std::sqrt(e.norm_square() + elastic_slip * elastic_slip) * e;
}

Point3 FrictionLaw::force(const FrictionPoint &p, const Point3 &slip) const
{
  return remembered_force(p, slip) + p.limit / viscous_slip * slip;
}

dealii::Tensor<2, 3> FrictionLaw::tangent(const FrictionPoint &p, const Point3 &slip) const
{
  const Point3 e = p.elastic_slip + slip;
  const double square = e.norm_square() + elastic_slip * elastic_slip;
  dealii::Tensor<2, 3> plane = dealii::Tensor<2, 3>(dealii::unit_symmetric_tensor<3>());
  plane -= outer_product(p.normal, p.normal);
  return p.limit / std::sqrt(square) * (plane - outer_product(e, e) / square) + p.limit / viscous_slip * plane;
}

Point3 remembered_traction(const State &state, std::size_t point)
{
  if (state.friction.empty())
    return {};
  const double *t = &state.friction.at(3 * point);
  return Point3({t[0], t[1], t[2]});
}

void remember_traction(State &state, std::size_t point, const Point3 &traction)
{
  for (int i = 0; i < 3; ++i)
    state.friction.at(3 * point + i) = traction[i];
}

} // namespace ballonet::solver::contact
