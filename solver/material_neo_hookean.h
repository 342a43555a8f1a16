// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/material.h"

namespace ballonet::solver
{

/// psi = C10 (J^(-2/3) tr C - 3) + kappa (J - 1)^2 / 2, the form of the Abaqus manual with kappa = 2 / D1.
class NeoHookean : public MaterialLaw
{
public:
  NeoHookean(double c10, double kappa) : c10_(c10), kappa_(kappa) {}
  Point evaluate(const Voigt &C) const override;
  Point evaluate_isochoric(const Voigt &C) const override;
  double shear_modulus() const override { return 2 * c10_; }
  double bulk_modulus() const override { return kappa_; }

private:
  double c10_, kappa_;
};

} // namespace ballonet::solver
