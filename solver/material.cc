// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/material.h"
#include "solver/material_neo_hookean.h"
#include "solver/material_saint_venant.h"
#include <stdexcept>

namespace ballonet::solver
{

double von_mises(const Matrix3 &F, const Voigt &S)
{
  double sigma[3][3] = {};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          sigma[i][j] += F[3 * i + k] * S[voigt_index[k][l]] * F[3 * j + l];
  const double mean = (sigma[0][0] + sigma[1][1] + sigma[2][2]) / 3;
  double square = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double s = sigma[i][j] - (i == j) * mean;
      square += s * s;
    }
  return std::sqrt(1.5 * square) / determinant(F);
}

MaterialLaw::Point MaterialLaw::evaluate_isochoric(const Voigt &) const
{
  throw std::logic_error("this law has no split into an isochoric and a volumetric part");
}

namespace
{

double required(const std::optional<double> &value, const char *key, const Material &material)
{
  if (!value)
    throw std::invalid_argument("material \"" + material.name + "\" needs " + key);
  return *value;
}

} // namespace

std::unique_ptr<MaterialLaw> make_material(const Material &m)
{
  if (m.law == Law::neo_hookean && m.c10)
    return std::make_unique<NeoHookean>(*m.c10, 2 / required(m.d1, "d1", m));
  const double E = required(m.youngs_modulus, m.law == Law::neo_hookean ? "c10 and d1" : "youngs_modulus", m);
  const double nu = required(m.poisson_ratio, "poisson_ratio", m);
  const double mu = E / (2 * (1 + nu)), kappa = E / (3 * (1 - 2 * nu));
  if (m.law == Law::neo_hookean)
    return std::make_unique<NeoHookean>(mu / 2, kappa);
  return std::make_unique<SaintVenant>(kappa - 2 * mu / 3, mu);
}

} // namespace ballonet::solver
