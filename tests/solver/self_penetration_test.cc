// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/self_penetration.h"
#include "tests/support/contact_scene.h"
#include "tests/support/two_arms.h"
#include <algorithm>
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

std::vector<Violation> violations(const TwoArms &scene, const State &state, double tolerance = 0.1)
{
  return SelfPenetration(scene.mesh, scene.pair, tolerance).find(state);
}

} // namespace

TEST_CASE("parts of a body that are apart, touch or bend are not reported")
{
  const TwoArms scene;
  CHECK(violations(scene, scene.state).empty());
  CHECK(violations(scene, scene.closed(0.05)).empty()); // tolerated
  const State bent = moved(scene.state, random_field(scene.state.displacement.size(), 0.02, 3), 1);
  CHECK(violations(scene, bent).empty());
}

TEST_CASE("a part of a body inside another part is found, with its depth")
{
  const TwoArms scene;
  const auto found = violations(scene, scene.closed(0.15));
  CHECK(found.size() == 2 * 33); // the inner side of each arm, 5 x 1 faces
  CHECK(found.front().depth == Approx(0.15).epsilon(1e-9));
  CHECK(found.front().body == "fold");
  CHECK(violations(scene, scene.closed(0.15), 0.2).empty());
}

TEST_CASE("in a wall thinner than the tolerance a node counts from the middle on")
{
  TwoArms scene;
  const auto thin = [&](double depth) { // the lower arm squeezed to 0.08 mm, its inner side left where it was
    State state = scene.closed(depth);
    for (std::size_t n = 0; n < scene.mesh.nodes.size(); ++n)
      if (const double y = scene.mesh.nodes[n][1]; y < 0)
        state.displacement[3 * n + 1] += (-TwoArms::gap / 2 - y) * (1 - 0.08 / TwoArms::wall);
    return state;
  };
  const auto in_lower = [&](const State &state) {
    const auto found = violations(scene, state);
    return std::count_if(found.begin(), found.end(),
                         [&](const Violation &v) { return scene.mesh.nodes[v.node][1] > 0; });
  };
  CHECK(in_lower(thin(0.03)) == 0);
  CHECK(in_lower(thin(0.05)) == 33);
}

TEST_CASE("what is near at rest is a neighbour and may be compressed")
{
  TwoArms scene;
  scene.pair.thickness = 0.3; // twice that is more than the gap
  CHECK(violations(scene, scene.closed(0.15)).empty());
}

TEST_CASE("in the corner of a rounded edge a self-penetration counts from the rounding")
{
  TwoArms scene; // the lower arm slid along until 0.08 mm of its end stay below the upper one's, 0.12 mm deep
  const State state = scene.closed(0.12, TwoArms::arm - 0.08);
  CHECK(violations(scene, state, 0.06).size() == 6);
  for (const char *arm : {"upper", "lower"})
    for (const auto &side : all_sides(arm))
      scene.pair.secondary.push_back(side);
  scene.pair.primary = scene.pair.secondary;
  scene.pair.thickness = 0.2; // 0.2 - |(0.12, 0.08)| = 0.056 mm
  CHECK(violations(scene, state, 0.06).empty());
  CHECK(violations(scene, state, 0.05).size() == 2); // at the middle of the width; its ends are corners
}
