// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_rigid.h"
#include "solver/contact_shift.h"
#include "tests/support/contact_scene.h"
#include "tests/support/derivative_check.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

/// The scene with augmented contact and random shifts of up to `largest` mm.
ContactScene augmented(ContactScene scene, double largest)
{
  scene.pair.enforcement = Enforcement::augmented_lagrangian;
  ContactWork work(scene.mesh, scene.pair, all_owned);
  scene.state.contact_shift = random_field(work.number_shifts_from(0), largest / 2, 3);
  for (double &shift : scene.state.contact_shift)
    shift += largest / 2;
  return scene;
}

/// A block of 2 x 2 x 1 mm that dips 0.1 mm into the plane z = 0.
struct DippedBlock : ContactScene {
  RigidBody body;
  explicit DippedBlock(double distortion)
  {
    add_block(mesh, "block", {2, 2, 1}, [](auto p) { return std::array<double, 3>{2 * p[0], 2 * p[1], p[2] - 0.1}; });
    distort(mesh, distortion, 11);
    pair = {"pair", {"block.z0"}, {"body"}, 0.3, 0.35, 9, 0.06};
    pair.enforcement = Enforcement::augmented_lagrangian;
    state.displacement.assign(3 * mesh.nodes.size(), 0.);
  }
  RigidContactWork work() const { return {mesh, pair, body, all_owned}; }
};

State slid(const State &state) { return moved(state, random_field(state.displacement.size(), 0.01, 5), 1); }

template <class Work>
void check_derivatives(Work &work, const State &start)
{
  work.begin_step(start, {.dt = 3e-3});
  const State state = slid(start);
  work.advance(state, std::vector<double>(state.displacement.size(), 0.), 1);
  check_residual(work, state);
  check_tangent(work, state, [&](const State &s) { return residual(work, s); });
}

} // namespace

TEST_CASE("contact shifts: residual and tangent are derivatives of the energy, with friction")
{
  for (const ContactScene &bare : {interior_scene(), edge_scene(), corner_scene()}) {
    const ContactScene scene = augmented(bare, 0.05);
    ContactWork work(scene.mesh, scene.pair, all_owned), penalty(bare.mesh, bare.pair, all_owned);
    check_derivatives(work, scene.state);
    penalty.begin_step(bare.state, {.dt = 3e-3});
    CHECK(work.summary(scene.state).points > penalty.summary(bare.state).points);
    CHECK(work.summary(scene.state).normal_force > 1.1 * penalty.summary(bare.state).normal_force);
    CHECK(work.summary(scene.state).penetration == penalty.summary(bare.state).penetration);
  }
  DippedBlock block(0.03);
  RigidContactWork work = block.work();
  block.state.contact_shift.assign(work.number_shifts_from(0), 0.05);
  check_derivatives(work, block.state);
}

TEST_CASE("contact shifts: zero shifts are the penalty, to the last digit")
{
  const ContactScene bare = edge_scene(), scene = augmented(bare, 0);
  ContactWork work(scene.mesh, scene.pair, all_owned), penalty(bare.mesh, bare.pair, all_owned);
  work.begin_step(scene.state, {.dt = 3e-3});
  penalty.begin_step(bare.state, {.dt = 3e-3});
  CHECK(penalty.number_shifts_from(5) == 5);
  CHECK(work.energy(slid(scene.state)) == penalty.energy(slid(bare.state)));
  CHECK(residual(work, slid(scene.state)) == residual(penalty, slid(bare.state)));
}

TEST_CASE("contact shifts: a shift adds to the penetration, and friction feels the whole pressure")
{
  DippedBlock block(0);
  block.pair.elastic_slip = 3e-4;
  RigidContactWork work = block.work();
  REQUIRE(work.number_shifts_from(0) == 9); // corners of 2 x 2 faces
  block.state.contact_shift.assign(9, 0.02);
  work.begin_step(block.state, {.dt = 3e-3});
  const double force = 4 * 9 * (0.1 + 0.02 - 0.03);
  const ContactSummary summary = work.summary(block.state);
  CHECK(summary.normal_force == Approx(force).epsilon(1e-12));
  CHECK(summary.penetration == Approx(0.1).epsilon(1e-12));
  State pulled = block.state;
  for (std::size_t i = 0; i < pulled.displacement.size(); i += 3)
    pulled.displacement[i] = 0.1;
  CHECK(work.summary(pulled).secondary_force[0] == Approx(-0.3 * force).epsilon(1e-4));
}

TEST_CASE("contact shifts: mean gaps are weighted by the pressure, and negative where the shift keeps apart")
{
  DippedBlock block(0);
  for (std::size_t i = 2; i < block.state.displacement.size(); i += 3)
    block.state.displacement[i] = 0.11; // 0.01 mm above the plane
  RigidContactWork work = block.work();
  work.number_shifts_from(2); // behind another pair
  block.state.contact_shift.assign(11, 0.05);
  work.begin_step(block.state, {.dt = 3e-3});
  contact::MeanGaps gaps(11);
  work.add_gaps(block.state, gaps);
  CHECK(gaps.force[0] == 0);
  CHECK(gaps.penetration(0) == 0);
  double force = 0;
  for (std::size_t n = 2; n < 11; ++n) {
    CHECK(gaps.penetration(n) == Approx(-0.01).epsilon(1e-10));
    force += gaps.force[n];
  }
  CHECK(force == Approx(work.summary(block.state).normal_force).epsilon(1e-12));
}

TEST_CASE("contact shifts: both sides of a pair have their own, with one pass only the side that has points")
{
  ContactScene scene = augmented(interior_scene(), 0.05);
  ContactWork two(scene.mesh, scene.pair, all_owned);
  CHECK(two.number_shifts_from(0) == 4 + 8); // corners of the plate's face and of the block
  scene.pair.passes = 1;
  ContactWork one(scene.mesh, scene.pair, all_owned);
  CHECK(one.number_shifts_from(0) == 4);
}
