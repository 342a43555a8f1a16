// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/material.h"

namespace ballonet::solver
{

/// psi = lambda (tr E)^2 / 2 + mu E : E, linear elasticity with finite rotation (Saint-Venant-Kirchhoff).
class SaintVenant : public MaterialLaw
{
public:
  SaintVenant(double lambda, double mu) : lambda_(lambda), mu_(mu) {}
  Point evaluate(const Voigt &C) const override;
  double shear_modulus() const override { return mu_; }
  double bulk_modulus() const override { return lambda_ + 2 * mu_ / 3; }

private:
  double lambda_, mu_;
};

} // namespace ballonet::solver
