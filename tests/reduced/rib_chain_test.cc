// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reference_table.h"
#include "solver/reduced/rib_chain.h"
#include "solver/reduced/tridiagonal.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

using namespace ballonet::solver::reduced;
using reference::degree;

namespace
{

/// A crooked pose without symmetry.
Angles crooked(std::size_t n)
{
  Angles al;
  for (std::size_t i = 0; i < n; ++i)
    al.push_back(0.1 * static_cast<double>(i) - 0.3 + 0.2 * std::sin(2.0 * static_cast<double>(i)));
  return al;
}

/// Hinge energy and weight, from the positions of the centres of mass.
double energy(const RibChain &chain, const Angles &al, double k, double gravity)
{
  double sum = 0, height = 0, below = 0;
  for (std::size_t i = 0; i < al.size(); ++i) {
    const Unit &unit = chain.units()[i];
    sum += k / 2 * (al[i] - below) * (al[i] - below);
    sum += gravity * unit.mass * (height + unit.along * std::cos(al[i]) + unit.across * std::sin(al[i]));
    height += chain.pitch() * std::cos(al[i]);
    below = al[i];
  }
  return sum;
}

double backbone_droop(const std::function<void(Parameters &)> &change)
{
  Parameters parameters;
  change(parameters);
  const Hinge hinge = make_hinge(parameters);
  const auto al = RibChain(parameters, hinge, Load::backbone).droop(hinge.stiffness());
  REQUIRE(al);
  return al->back() / degree;
}

} // namespace

TEST_CASE("the chain's residual and tangent are derivatives of its energy")
{
  const Parameters parameters;
  const RibChain chain(parameters, make_hinge(parameters), Load::with_balloon);
  Angles al = crooked(chain.size());
  const auto r = chain.residual(al, 26), diagonal = chain.tangent_diagonal(al, 26);
  const double h = 1e-5;
  for (std::size_t i = 0; i < al.size(); ++i) {
    const double angle = al[i];
    al[i] = angle + h;
    const double energy_above = energy(chain, al, 26, 9810), force_above = chain.residual(al, 26)[i];
    al[i] = angle - h;
    const double energy_below = energy(chain, al, 26, 9810), force_below = chain.residual(al, 26)[i];
    al[i] = angle;
    CHECK(r[i] == Approx((energy_above - energy_below) / (2 * h)).margin(1e-5));
    CHECK(diagonal[i] == Approx((force_above - force_below) / (2 * h)).margin(1e-5));
  }
}

TEST_CASE("without weight a moment bends all gaps alike: M = k al_N / N")
{
  Parameters parameters;
  parameters.gravity = 0;
  const RibChain chain(parameters, make_hinge(parameters), Load::backbone);
  const auto held = chain.hold(3.0, 26, Angles(chain.size(), 0.0));
  REQUIRE(held);
  CHECK(held->moment == Approx(26 * 3.0 / 20));
  for (double th : gap_angles(held->al))
    CHECK(th == Approx(0.15));
}

TEST_CASE("droop of the default backbone, alone and with the balloon")
{
  const Parameters parameters;
  const Hinge hinge = make_hinge(parameters);
  const RibChain backbone(parameters, hinge, Load::backbone), loaded(parameters, hinge, Load::with_balloon);
  CHECK(backbone.droop(25.656398766)->back() / degree == Approx(-39.196588995).epsilon(1e-6));
  CHECK(loaded.droop(25.656398766)->back() / degree == Approx(-51.712538787).epsilon(1e-6));
  CHECK(self_weight_number(backbone, hinge.stiffness(), 9810) == Approx(4.6).margin(0.05));
  CHECK(self_weight_number(loaded, hinge.stiffness(), 9810) == Approx(5.3).margin(0.05));
}

TEST_CASE("sensitivity of the droop to the dimensions, by 10 % each way")
{
  const auto droops = [](const std::function<double &(Parameters &)> &value, double low, double high) {
    CHECK(backbone_droop([&](Parameters &p) { value(p) *= 0.9; }) == Approx(low).margin(0.6));
    CHECK(backbone_droop([&](Parameters &p) { value(p) *= 1.1; }) == Approx(high).margin(0.6));
  };
  droops([](Parameters &p) -> double & { return p.wall.thickness; }, -69, -22);
  droops([](Parameters &p) -> double & { return p.wall.width; }, -59, -24);
  droops([](Parameters &p) -> double & { return p.ribs.inner_radius; }, -25, -55);
  droops([](Parameters &p) -> double & { return p.wall.youngs_modulus; }, -49, -32);
  droops([](Parameters &p) -> double & { return p.wall.rise; }, -31, -49);
  droops([](Parameters &p) -> double & { return p.wall.density; }, -31, -48);
  droops([](Parameters &p) -> double & { return p.ribs.thickness; }, -33, -46);
  droops([](Parameters &p) -> double & { return p.head.thickness; }, -37, -42);
}

TEST_CASE("given masses replace those of the volumes")
{
  Parameters parameters;
  parameters.ribs.mass = 1e-6;
  parameters.head.mass = 3e-6;
  parameters.wall.density = 0;
  const RibChain chain(parameters, make_hinge(parameters), Load::backbone);
  CHECK(chain.moving_mass() == Approx(23e-6));
  CHECK(chain.units().back().mass == Approx(4e-6));
}

TEST_CASE("a backbone too soft to carry itself hangs down")
{
  CHECK(backbone_droop([](Parameters &p) { p.wall.youngs_modulus = 36; }) == Approx(-145).margin(5));
}

TEST_CASE("the upright chain is stable under its weight and buckles when that is too much")
{
  Parameters parameters;
  const Hinge hinge = make_hinge(parameters);
  const RibChain chain(parameters, hinge, Load::backbone);
  const auto upright_is_stable = [&](double k) {
    const Angles upright(chain.size(), 0.0);
    return solve_tridiagonal(chain.tangent_diagonal(upright, k), -k, upright).negative_pivots == 0;
  };
  // Twenty hinges under an even weight buckle at a self-weight number of 7.27; the weight of a head lowers that.
  const double number = self_weight_number(chain, 1, parameters.gravity);
  CHECK(upright_is_stable(number / 4.6));
  CHECK_FALSE(upright_is_stable(number / 7.27));
}
