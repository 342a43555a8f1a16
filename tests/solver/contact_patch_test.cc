// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_law.h"
#include "solver/contact_patch.h"
#include <catch2/catch.hpp>
#include <random>

using namespace ballonet::solver;
using namespace ballonet::solver::contact;

namespace
{

PatchNodes curved_patch(std::mt19937 &generator)
{
  std::uniform_real_distribution<double> shift(-0.12, 0.12);
  PatchNodes nodes;
  for (int a = 0; a < 9; ++a)
    nodes[a] = Point3({a % 3 * 0.6 + shift(generator), a / 3 * 0.5 + shift(generator), shift(generator)});
  return nodes;
}

double sampled_distance(const PatchNodes &nodes, const PatchRange &range, const Point3 &x)
{
  constexpr int n = 300;
  double smallest = 1e300;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const Parameters2 xi = {range.low[0] + i * (range.high[0] - range.low[0]) / n,
                              range.low[1] + j * (range.high[1] - range.low[1]) / n};
      smallest = std::min(smallest, (x - patch_point(nodes, xi).position).norm());
    }
  return smallest;
}

} // namespace

TEST_CASE("closest point of a curved patch agrees with dense sampling")
{
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> where(-0.7, 1.9);
  const std::array<PatchRange, 4> ranges = {{{}, {{0.3, 0}, {1, 0.7}}, {{0.5, 0}, {0.5, 1}}, {{0.5, 0.5}, {0.5, 0.5}}}};
  std::array<int, 3> free_count = {};
  for (int trial = 0; trial < 200; ++trial) {
    const PatchNodes nodes = curved_patch(generator);
    const PatchRange &range = ranges[trial % 4];
    const Point3 x({where(generator), where(generator), 0.4 * where(generator)});
    const ClosestPoint c = closest_point(nodes, range, x);
    REQUIRE(c.converged);
    const double sampled = sampled_distance(nodes, range, x);
    CHECK(c.distance <= sampled + 1e-12);
    CHECK(c.distance >= sampled - 1e-2);
    for (int a = 0; a < 2; ++a) {
      CHECK((c.xi[a] >= range.low[a] && c.xi[a] <= range.high[a]));
      if (c.free[a])
        CHECK(std::abs(c.normal * c.tangent[a]) < 1e-10);
      else
        CHECK((c.xi[a] == range.low[a] || c.xi[a] == range.high[a]));
    }
    ++free_count[c.free[0] + c.free[1]];
  }
  for (const int count : free_count) // interior, edge and corner were all met
    CHECK(count > 10);
}

TEST_CASE("a warm start finds the same closest point")
{
  std::mt19937 generator(3);
  const PatchNodes nodes = curved_patch(generator);
  const Point3 x({0.5, 0.4, 0.3});
  const ClosestPoint cold = closest_point(nodes, {}, x), warm = closest_point(nodes, {}, x, {0.1, 0.9});
  CHECK(warm.xi[0] == Approx(cold.xi[0]).margin(1e-12));
  CHECK(warm.xi[1] == Approx(cold.xi[1]).margin(1e-12));
}

TEST_CASE("contact law: pressure and slope are derivatives, quadratic onset")
{
  for (const double onset : {0.06, 0.}) {
    const ContactLaw law = {9, onset};
    for (const double g : {-0.1, 0.02, 0.05, 0.07, 0.3}) {
      const double h = 1e-5;
      CHECK(law.pressure(g) == Approx((law.energy(g + h) - law.energy(g - h)) / (2 * h)).margin(1e-9));
      CHECK(law.slope(g) == Approx((law.pressure(g + h) - law.pressure(g - h)) / (2 * h)).margin(1e-9));
    }
    CHECK(law.pressure(0.3) == Approx(9 * (0.3 - onset / 2)));
  }
  CHECK(ContactLaw{9, 0.06}.pressure(0.03) == Approx(9 * 0.03 * 0.03 / 0.12));
}
