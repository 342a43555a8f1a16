// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/derivative_check.h"
#include "tests/support/two_arms.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double gap = TwoArms::gap, arm = TwoArms::arm; // mm

ContactWork started(const TwoArms &fold, const State &state)
{
  ContactWork work(fold.mesh, fold.pair, all_owned);
  work.begin_step(state, {.dt = 1e-6});
  return work;
}

} // namespace

TEST_CASE("self-contact: a surface does not touch its own neighbourhood, open or bent")
{
  const TwoArms fold;
  CHECK(started(fold, fold.state).summary(fold.state).points == 0);
  const State bent = moved(fold.state, random_field(fold.state.displacement.size(), 0.02, 3), 1);
  CHECK(started(fold, bent).summary(bent).points == 0);
}

TEST_CASE("self-contact: two parts that meet press on each other by the law, once")
{
  for (const int passes : {1, 2}) {
    const TwoArms fold(passes);
    const State state = fold.closed(0.05);
    const auto summary = started(fold, state).summary(state);
    CHECK(summary.penetration == Approx(0.05).epsilon(1e-10));
    CHECK(summary.area == Approx(arm).epsilon(1e-10));
    CHECK(summary.normal_force == Approx(arm * 9 * 0.05 * 0.05 / 0.12).epsilon(1e-10));
  }
}

TEST_CASE("self-contact: forces balance, friction included, and residual and tangent are derivatives")
{
  TwoArms fold;
  const State shut = fold.closed(0.05);
  const ContactWork work = started(fold, shut);
  const State slid = moved(fold.closed(0.06, 1e-3), random_field(shut.displacement.size(), 0.01, 5), 1);
  ContactWork exact = started(fold, shut);
  exact.advance(slid, std::vector<double>(slid.displacement.size(), 0.), 1);
  check_residual(exact, slid);
  check_tangent(exact, slid, [&](const State &state) { return residual(exact, state); });
  const auto forces = residual(work, slid);
  Vector sum;
  for (std::size_t i = 0; i < forces.size(); ++i)
    sum[i % 3] += forces[i];
  CHECK(norm(forces) > 0.05);
  CHECK(sum.norm() < 1e-10);
}

TEST_CASE("self-contact: a step stops before one part goes through the other")
{
  const TwoArms fold;
  const ContactWork work = started(fold, fold.state);
  const State far = fold.closed(3);
  const double fraction = work.largest_step(fold.state, far.displacement);
  CHECK(fraction * (gap + 3) < gap + 0.7 * 0.15 + 1e-9);
  CHECK(fraction * (gap + 3) > gap);
  CHECK(work.largest_step(fold.state, fold.closed(0.05).displacement) == 1);
}
