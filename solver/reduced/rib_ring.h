// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/reduced/parameters.h"

namespace ballonet::solver::reduced
{

/// Radial growth of a closed rib under the contact pressure q (MPa) of the balloon over one pitch, mm:
/// u = q Ri Rm p / (E t_r b) with the rib's middle radius Rm, its thickness t_r and width b.
inline double ring_growth(const Parameters &parameters, double contact_pressure)
{
  const Ribs &ribs = parameters.ribs;
  const double middle_radius = ribs.inner_radius + ribs.thickness / 2;
  return contact_pressure * ribs.inner_radius * middle_radius * parameters.pitch() /
         (parameters.wall.youngs_modulus * ribs.thickness * ribs.width);
}

} // namespace ballonet::solver::reduced
