// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/contact_scene.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

/// Fraction of a plate's motion that contact allows; the plate starts `gap` above the block.
double allowed(double gap, const Vector &motion)
{
  const ContactScene scene = contact_scene(Vector({1, 1, 1 + gap}), Vector({0, 0, 1}), 1.2, 0, {2, 2, 1});
  ContactWork work(scene.mesh, scene.pair, all_owned);
  work.begin_step(scene.state, {.dt = 1e-3});
  return work.largest_step(scene.state, with_plate_moved(scene, motion).displacement);
}

constexpr double deepest = 0.7 * 0.3; // of the thickness

} // namespace

TEST_CASE("a step stops before the core of the primary body")
{
  CHECK(allowed(-0.1, Vector({0, 0, -0.1})) == 1);
  const double fraction = allowed(-0.1, Vector({0, 0, -0.2}));
  CHECK(fraction * 0.2 <= deepest - 0.1 + 1e-12);
  CHECK(fraction * 0.2 > deepest - 0.1 - 2e-3);
}

TEST_CASE("a step does not jump through, whether paired before or not")
{
  for (const double gap : {0.05, 0.5, 3.})
    for (const double way : {gap + 0.4, gap + 2, gap + 9.}) {
      const double fraction = allowed(gap, Vector({0, 0, -way}));
      CHECK(fraction * way <= gap + deepest + 1e-9);
      CHECK(fraction * way > gap + deepest - 0.01);
    }
}

TEST_CASE("a point in the core may leave but not go deeper")
{
  CHECK(allowed(-0.25, Vector({0, 0, 0.2})) == 1);
  CHECK(allowed(-0.25, Vector({0, 0, -0.02})) < 0.01);
}

TEST_CASE("motion of both bodies together, and motion apart, is not limited")
{
  const ContactScene scene = interior_scene();
  ContactWork work(scene.mesh, scene.pair, all_owned);
  work.begin_step(scene.state, {.dt = 1e-3});
  CHECK(work.largest_step(scene.state, std::vector<double>(scene.state.displacement.size(), 50.)) == 1);
  CHECK(allowed(-0.1, Vector({0, 0, 5})) == 1);
  CHECK(allowed(0.1, Vector({5, 0, 0})) == 1);
}
