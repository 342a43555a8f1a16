// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "tests/support/dense_assembly.h"
#include "tests/support/nodal_fields.h"
#include <algorithm>
#include <catch2/catch.hpp>

namespace ballonet::tests
{

inline DenseAssembly assembled(const solver::VirtualWork &work, const solver::State &state)
{
  DenseAssembly assembly(state.displacement.size() / 3);
  work.residual(state, assembly);
  work.tangent(state, assembly);
  return assembly;
}

inline std::vector<double> residual(const solver::VirtualWork &work, const solver::State &state)
{
  DenseAssembly assembly(state.displacement.size() / 3, false);
  work.residual(state, assembly);
  return assembly.residual;
}

/// Residual against central differences of the energy, in random directions.
inline void check_residual(const solver::VirtualWork &work, const solver::State &state, double tolerance = 1e-7)
{
  const auto exact = residual(work, state);
  REQUIRE(norm(exact) > 0);
  for (unsigned seed = 0; seed < 4; ++seed) {
    const auto direction = random_field(exact.size(), 1, seed);
    const double h = 1e-5;
    const double slope = (work.energy(moved(state, direction, h)) - work.energy(moved(state, direction, -h))) / (2 * h);
    INFO("difference " << slope << ", residual " << dot(exact, direction));
    CHECK(std::abs(slope - dot(exact, direction)) < tolerance * norm(exact) * norm(direction));
  }
}

inline std::vector<double> product(const DenseAssembly &assembly, const std::vector<double> &direction)
{
  const std::size_t n = direction.size();
  std::vector<double> result(n);
  for (std::size_t i = 0; i < n; ++i)
    result[i] = dot(std::span(assembly.tangent).subspan(n * i, n), direction);
  return result;
}

/// Symmetric tangent against central differences of `residual_at(state)`, in random directions.
template <class ResidualAt>
void check_tangent(const solver::VirtualWork &work, const solver::State &state, const ResidualAt &residual_at,
                   double tolerance = 1e-6)
{
  const auto exact = assembled(work, state);
  for (unsigned seed = 0; seed < 3; ++seed) {
    const auto direction = random_field(exact.residual.size(), 1, seed);
    const double h = 1e-6;
    const auto plus = residual_at(moved(state, direction, h)), minus = residual_at(moved(state, direction, -h));
    auto difference = product(exact, direction);
    const double size = norm(difference);
    for (std::size_t i = 0; i < difference.size(); ++i)
      difference[i] -= (plus[i] - minus[i]) / (2 * h);
    INFO("relative difference " << norm(difference) / size);
    CHECK(norm(difference) < tolerance * size);
    const auto other = random_field(exact.residual.size(), 1, seed + 100);
    CHECK(std::abs(dot(other, product(exact, direction)) - dot(direction, product(exact, other))) <
          1e-12 * size * norm(other));
  }
}

} // namespace ballonet::tests
