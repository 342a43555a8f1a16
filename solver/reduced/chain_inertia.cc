// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/chain_inertia.h"
#include "solver/reduced/tridiagonal.h"
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace ballonet::solver::reduced
{
namespace
{

/// Cosines and sines of all angles: those of differences follow without further calls.
struct Directions {
  explicit Directions(const Angles &al) : c(al.size()), s(al.size())
  {
    for (std::size_t i = 0; i < al.size(); ++i)
      c[i] = std::cos(al[i]), s[i] = std::sin(al[i]);
  }
  double cos_between(std::size_t j, std::size_t k) const { return c[k] * c[j] + s[k] * s[j]; }
  double sin_between(std::size_t j, std::size_t k) const { return s[k] * c[j] - c[k] * s[j]; } // of al_k - al_j
  std::vector<double> c, s;
};

double lever_along(const RibChain &chain, std::size_t k)
{
  const Unit &unit = chain.units()[k];
  return chain.pitch() * (unit.mass_above * chain.pitch() + unit.mass * unit.along);
}

double lever_across(const RibChain &chain, std::size_t k)
{
  return chain.pitch() * chain.units()[k].mass * chain.units()[k].across;
}

std::vector<double> multiply(const SymmetricMatrix &A, const std::vector<double> &x)
{
  std::vector<double> y(x.size(), 0.0);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      y[i] += A(i, j) * x[j];
      y[j] += j < i ? A(i, j) * x[i] : 0;
    }
  return y;
}

} // namespace

Inertia inertia(const RibChain &chain, const Angles &al, const std::vector<double> &velocity)
{
  const Directions to(al);
  Inertia result{SymmetricMatrix(chain.size()), std::vector<double>(chain.size(), 0.0)};
  for (std::size_t k = 0; k < chain.size(); ++k) {
    const Unit &unit = chain.units()[k];
    const double A = lever_along(chain, k), B = lever_across(chain, k);
    for (std::size_t j = 0; j < k; ++j) {
      const double cosine = to.cos_between(j, k), sine = to.sin_between(j, k);
      const double slope = B * cosine - A * sine; // dM_jk / dal_k
      result.mass(k, j) = A * cosine + B * sine;
      result.velocity[j] += slope * velocity[k] * velocity[k];
      result.velocity[k] -= slope * velocity[j] * velocity[j];
    }
    result.mass(k, k) = unit.mass_above * chain.pitch() * chain.pitch() +
                        unit.mass * (unit.along * unit.along + unit.across * unit.across) + unit.rotary;
  }
  return result;
}

double lowest_frequency(const RibChain &chain, const Angles &al, double k)
{
  const SymmetricMatrix M = inertia(chain, al, Angles(chain.size(), 0.0)).mass;
  const std::vector<double> diagonal = chain.tangent_diagonal(al, k);
  std::vector<double> mode(chain.size(), 1.0);
  double omega2 = 0;
  for (int i = 0; i < 100; ++i) {
    const std::vector<double> momentum = multiply(M, mode);
    const TridiagonalSolution next = solve_tridiagonal(diagonal, -k, momentum);
    if (next.negative_pivots > 0)
      throw std::domain_error("the chain is not stable");
    const double work = std::inner_product(next.x.begin(), next.x.end(), momentum.begin(), 0.0);
    omega2 = std::inner_product(mode.begin(), mode.end(), momentum.begin(), 0.0) / work;
    for (std::size_t j = 0; j < mode.size(); ++j)
      mode[j] = next.x[j] * omega2;
  }
  return std::sqrt(omega2) / (2 * std::numbers::pi);
}

} // namespace ballonet::solver::reduced
