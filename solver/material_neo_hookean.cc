// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/material_neo_hookean.h"

namespace ballonet::solver
{

MaterialLaw::Point NeoHookean::evaluate_isochoric(const Voigt &C) const
{
  const Voigt inv = inverse(C);
  const double factor = 2 * c10_ * std::pow(determinant(C), -1. / 3); // 2 C10 J^(-2/3)
  const double I1 = C[0] + C[1] + C[2];
  Point p{c10_ * (factor / (2 * c10_) * I1 - 3), {}, {}};
  for (int i = 0; i < 6; ++i)
    p.stress[i] = factor * (voigt_unit[i] - I1 / 3 * inv[i]);
  add_dyad(p.tangent, -2 * factor / 3, voigt_unit, inv);
  add_dyad(p.tangent, -2 * factor / 3, inv, voigt_unit);
  add_dyad(p.tangent, 2 * factor * I1 / 9, inv, inv);
  add_symmetric_product(p.tangent, 2 * factor * I1 / 3, inv);
  return p;
}

MaterialLaw::Point NeoHookean::evaluate(const Voigt &C) const
{
  Point p = evaluate_isochoric(C);
  const Voigt inv = inverse(C);
  const double J = std::sqrt(determinant(C)), pressure = kappa_ * (J - 1);
  p.energy += pressure * (J - 1) / 2;
  for (int i = 0; i < 6; ++i)
    p.stress[i] += pressure * J * inv[i];
  add_dyad(p.tangent, (kappa_ * J + pressure) * J, inv, inv);
  add_symmetric_product(p.tangent, -2 * pressure * J, inv);
  return p;
}

} // namespace ballonet::solver
