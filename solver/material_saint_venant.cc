// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/material_saint_venant.h"

namespace ballonet::solver
{

MaterialLaw::Point SaintVenant::evaluate(const Voigt &C) const
{
  const Voigt E = green_strain(C);
  Point p{};
  add_dyad(p.tangent, lambda_, voigt_unit, voigt_unit);
  add_symmetric_product(p.tangent, 2 * mu_, voigt_unit);
  p.stress = multiply(p.tangent, E);
  p.energy = dot(p.stress, E) / 2;
  return p;
}

} // namespace ballonet::solver
