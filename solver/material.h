// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/parameters.h"
#include "solver/voigt.h"
#include <memory>

namespace ballonet::solver
{

/// A constitutive law at a point, as a function of C = F^T F only, so that it is objective by construction.
class MaterialLaw
{
public:
  struct Point {
    double energy;  ///< psi per reference volume, MPa
    Voigt stress;   ///< S = d psi / d E (second Piola-Kirchhoff), MPa
    Voigt2 tangent; ///< d S / d E, MPa
  };
  virtual ~MaterialLaw() = default;

  /// The whole law.
  virtual Point evaluate(const Voigt &C) const = 0;

  /// The part that does not see the volume ratio; the other part is kappa (J - 1)^2 / 2. Throws std::logic_error for
  /// a law without this split.
  virtual Point evaluate_isochoric(const Voigt &C) const;

  virtual double shear_modulus() const = 0; ///< mu at rest, MPa
  virtual double bulk_modulus() const = 0;  ///< kappa at rest, MPa
};

/// Throws std::invalid_argument naming the coefficient that is missing.
std::unique_ptr<MaterialLaw> make_material(const Material &parameters);

} // namespace ballonet::solver
