// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/chain_inertia.h"
#include <catch2/catch.hpp>
#include <cmath>

using namespace ballonet::solver::reduced;

namespace
{

RibChain chain_of(Load load)
{
  const Parameters parameters;
  return {parameters, make_hinge(parameters), load};
}

Angles crooked(std::size_t n)
{
  Angles al;
  for (std::size_t i = 0; i < n; ++i)
    al.push_back(0.15 * static_cast<double>(i) + 0.3 * std::sin(2.0 * static_cast<double>(i)));
  return al;
}

/// Twice the kinetic energy, from the velocities of the centres of mass.
double kinetic(const RibChain &chain, const Angles &al, const std::vector<double> &v)
{
  double sum = 0, vx = 0, vy = 0;
  for (std::size_t i = 0; i < al.size(); ++i) {
    const Unit &unit = chain.units()[i];
    const double c = std::cos(al[i]), s = std::sin(al[i]);
    const double x = vx + v[i] * (-unit.along * c - unit.across * s),
                 y = vy + v[i] * (-unit.along * s + unit.across * c);
    sum += unit.mass * (x * x + y * y) + unit.rotary * v[i] * v[i];
    vx -= chain.pitch() * c * v[i];
    vy -= chain.pitch() * s * v[i];
  }
  return sum;
}

double quadratic(const SymmetricMatrix &M, const std::vector<double> &v)
{
  double sum = 0;
  for (std::size_t i = 0; i < v.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j)
      sum += (i == j ? 1 : 2) * M(i, j) * v[i] * v[j];
  return sum;
}

} // namespace

TEST_CASE("the mass matrix gives the kinetic energy")
{
  const RibChain chain = chain_of(Load::with_balloon);
  const Angles al = crooked(chain.size());
  std::vector<double> v;
  for (std::size_t i = 0; i < chain.size(); ++i)
    v.push_back(std::cos(3.0 * static_cast<double>(i)));
  CHECK(quadratic(inertia(chain, al, v).mass, v) == Approx(kinetic(chain, al, v)));
}

TEST_CASE("the velocity forces conserve energy")
{
  // d/dt (v M v / 2) = v M v' + v M' v / 2 with M v' = -h must vanish: v h = v M' v / 2.
  const RibChain chain = chain_of(Load::with_balloon);
  Angles al = crooked(chain.size());
  std::vector<double> v;
  for (std::size_t i = 0; i < chain.size(); ++i)
    v.push_back(1 + std::sin(5.0 * static_cast<double>(i)));
  const Inertia here = inertia(chain, al, v);
  double power = 0;
  const double h = 1e-6;
  Angles before = al, after = al;
  for (std::size_t i = 0; i < v.size(); ++i) {
    power += v[i] * here.velocity[i];
    before[i] -= h * v[i];
    after[i] += h * v[i];
  }
  const double change = (kinetic(chain, after, v) - kinetic(chain, before, v)) / (2 * h);
  CHECK(power == Approx(change / 2).epsilon(1e-6));
}

TEST_CASE("first natural frequency of the backbone, weightless and about its droop")
{
  const Parameters parameters;
  const double k = make_hinge(parameters).stiffness();
  const RibChain chain = chain_of(Load::backbone);
  CHECK(lowest_frequency(chain, *chain.droop(k), k) == Approx(1.43).margin(0.005));

  Parameters weightless;
  weightless.gravity = 0;
  const RibChain floating(weightless, make_hinge(weightless), Load::backbone);
  CHECK(lowest_frequency(floating, Angles(20, 0.0), k) == Approx(2.11).margin(0.005));
  CHECK_THROWS_AS(lowest_frequency(chain, Angles(20, 0.0), k / 4), std::domain_error);
}

TEST_CASE("Cholesky's method refuses an indefinite matrix")
{
  SymmetricMatrix A(2);
  A(0, 0) = 1, A(1, 0) = 2, A(1, 1) = 1;
  CHECK_THROWS_AS(solve_positive(A, {1, 1}), std::domain_error);
  SymmetricMatrix B(2);
  B(0, 0) = 2, B(1, 0) = 1, B(1, 1) = 3;
  const auto x = solve_positive(B, {4, 7});
  CHECK(x[0] == Approx(1));
  CHECK(x[1] == Approx(2));
}
