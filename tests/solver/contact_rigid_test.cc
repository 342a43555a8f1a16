// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_rigid.h"
#include "tests/support/contact_scene.h"
#include "tests/support/derivative_check.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

/// A distorted block of 2 x 2 x 1 mm whose lower side dips into a rigid body below it.
struct RigidScene : ContactScene {
  RigidBody body;
  RigidScene(RigidShapeKind kind, double distortion)
  {
    add_block(mesh, "block", {2, 2, 1}, [](auto p) { return std::array<double, 3>{2 * p[0], 2 * p[1], p[2] - 0.1}; });
    distort(mesh, distortion, 11);
    pair = {"pair", {"block.z0"}, {"body"}, 0.3, 0.35, 9, 0.06};
    state.displacement.assign(3 * mesh.nodes.size(), 0.);
    body.name = "body", body.shape = kind;
    if (kind == RigidShapeKind::cylinder)
      body.point = {1, 1, -1.5}, body.axis = {1, 1, 0}, body.radius = 1.5;
    if (kind == RigidShapeKind::box)
      body.point = {0.5, 0.5, -1}, body.half_lengths = {1, 1, 1};
    if (kind == RigidShapeKind::ellipsoid)
      body.point = {0.9, 1.1, -1}, body.half_lengths = {3, 2, 1};
  }
};

RigidContactWork started(const RigidScene &scene)
{
  RigidContactWork work(scene.mesh, scene.pair, scene.body, all_owned);
  work.begin_step(scene.state, {.dt = 3e-3});
  return work;
}

State moved_by(const RigidScene &scene, const Vector &by)
{
  State state = scene.state;
  for (std::size_t i = 0; i < state.displacement.size(); ++i)
    state.displacement[i] += by[i % 3];
  return state;
}

} // namespace

TEST_CASE("contact with rigid bodies: residual and tangent are derivatives of the energy, with friction")
{
  for (const auto kind :
       {RigidShapeKind::plane, RigidShapeKind::cylinder, RigidShapeKind::box, RigidShapeKind::ellipsoid}) {
    const RigidScene scene(kind, 0.03);
    RigidContactWork work = started(scene);
    const State slid = moved(scene.state, random_field(scene.state.displacement.size(), 0.02, 5), 1);
    work.advance(slid, std::vector<double>(slid.displacement.size(), 0.), 1);
    CHECK(work.summary(slid).points > 10);
    check_residual(work, slid);
    check_tangent(work, slid, [&](const State &state) { return residual(work, state); });
  }
}

TEST_CASE("contact with a rigid plane carries the pressure of the law, and friction tends to Coulomb's limit")
{
  RigidScene scene(RigidShapeKind::plane, 0);
  scene.pair.elastic_slip = 3e-4;
  const RigidContactWork work = started(scene);
  const auto summary = work.summary(scene.state);
  const double force = 4 * 9 * (0.1 - 0.03);
  CHECK(summary.secondary_force[2] == Approx(force).epsilon(1e-12));
  CHECK(summary.normal_force == Approx(force).epsilon(1e-12));
  CHECK(summary.primary_force.at(0)[2] == Approx(-force).epsilon(1e-12));
  CHECK(summary.area == Approx(4).epsilon(1e-12));
  CHECK(summary.penetration == Approx(0.1).epsilon(1e-12));
  CHECK(std::abs(summary.secondary_force[0]) < 1e-12);
  const auto slid = work.summary(moved_by(scene, Vector({0.1, 0, 0})));
  CHECK(slid.secondary_force[0] == Approx(-0.3 * force).epsilon(1e-4));
  CHECK_FALSE(work.contact_points(scene.state).at(0).primary);
}

TEST_CASE("a step into a rigid body ends before the core, also one that would go far through it")
{
  const RigidScene scene(RigidShapeKind::plane, 0);
  const RigidContactWork work = started(scene);
  const double deepest = 0.7 * 0.35;
  for (const double way : {0.2, 3., 50.}) {
    const double fraction = work.largest_step(scene.state, moved_by(scene, Vector({0, 0, -way})).displacement);
    CHECK(0.1 + fraction * way <= deepest + 1e-12);
    CHECK(0.1 + fraction * way > deepest - 2e-3);
  }
  CHECK(work.largest_step(scene.state, moved_by(scene, Vector({0, 0, -0.1})).displacement) == 1);
  CHECK(work.largest_step(scene.state, moved_by(scene, Vector({9, 0, 9})).displacement) == 1);
}

TEST_CASE("the deepest node counts as penetration of a rigid body, beside the points")
{
  RigidScene scene(RigidShapeKind::plane, 0);
  scene.pair.points_per_side = 2;
  scene.state.displacement[2] = -0.05; // of a corner
  CHECK(started(scene).summary(scene.state).penetration == Approx(0.15).epsilon(1e-12));
}

TEST_CASE("a rigid body stands alone in its pair")
{
  RigidScene scene(RigidShapeKind::plane, 0);
  scene.pair.primary.push_back("block.z1");
  CHECK_THROWS_AS(started(scene), std::invalid_argument);
}
