// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_rigid.h"
#include "solver/rigid_penetration.h"
#include "tests/support/contact_scene.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

/// A block of 2 x 2 x 1 mm, its lower side 1 mm above the floor; the pair names one side of it alone.
struct Falling : ContactScene {
  RigidBody floor;

  explicit Falling(const std::string &side)
  {
    add_block(mesh, "block", {2, 2, 1}, [](auto p) { return std::array<double, 3>{2 * p[0], 2 * p[1], p[2]}; });
    floor.name = "floor", floor.point = {0, 0, -1};
    pair = {"pair", {side}, {"floor"}, 0, 0.3, 9, 0.06};
    state.displacement.assign(3 * mesh.nodes.size(), 0.);
  }

  State lowered(double by) const
  {
    State result = state;
    for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
      result.displacement[3 * n + 2] = -by;
    return result;
  }
};

} // namespace

TEST_CASE("nodes deeper in a rigid body than allowed are found, with their depth")
{
  const Falling scene("block.z0");
  const RigidPenetration check(scene.mesh, scene.pair, scene.floor, 0.1);
  CHECK(check.find(scene.state).empty());
  CHECK(check.find(scene.lowered(1.05)).empty()); // 0.05 mm deep, tolerated
  const auto found = check.find(scene.lowered(1.2));
  REQUIRE(found.size() == 25); // the lower side
  CHECK(found.front().depth == Approx(0.2).epsilon(1e-12));
  CHECK(found.front().body == "floor");
}

TEST_CASE("a part of a body that its contact pair does not name is not let into a rigid body either")
{
  const Falling scene("block.z1"); // the upper side, which never gets there
  const State state = scene.lowered(1.2);
  const RigidContactWork work(scene.mesh, scene.pair, scene.floor, all_owned);
  CHECK(work.energy(state) == 0);
  CHECK(work.summary(state).penetration == 0);
  CHECK(RigidPenetration(scene.mesh, scene.pair, scene.floor, 0.1).find(state).size() == 25);
}

TEST_CASE("what lies in a rigid body at rest is built in")
{
  Falling scene("block.z0");
  scene.floor.point = {0, 0, 0.2};
  const RigidPenetration check(scene.mesh, scene.pair, scene.floor, 0.1);
  CHECK(check.find(scene.state).empty());
  CHECK(check.find(scene.lowered(0.5)).size() == 16); // the ring of nodes in the middle of the sides
}
