// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/contact_scene.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <set>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

const Vector up({0, 0, 1});

ContactScene with_one_pass(ContactScene scene)
{
  scene.pair.passes = 1;
  return scene;
}

/// An undistorted plate 0.1 mm deep in the block's upper side, felt by the plate only.
ContactScene flat_scene() { return with_one_pass(contact_scene(Vector({1, 1, 0.9}), up, 0.8, 0, {2, 2, 1})); }

std::vector<double> residual(const ContactWork &work, const State &state)
{
  DenseAssembly assembly(state.displacement.size() / 3, false);
  work.residual(state, assembly);
  return assembly.residual;
}

/// Sum of nodal forces and of their moments about the origin.
std::array<Vector, 2> resultant(const Mesh &mesh, const State &state, const std::vector<double> &forces)
{
  std::array<Vector, 2> sum;
  const contact::CurrentPosition position = {mesh, state.displacement};
  const contact::NodalField force = {forces};
  for (Node n = 0; n < mesh.nodes.size(); ++n) {
    sum[0] += force(n);
    sum[1] += cross_product_3d(position(n), force(n));
  }
  return sum;
}

/// Everything turned by 70 degrees about (1, 2, 2) / 3 and shifted.
State turned(const Mesh &mesh, const State &state)
{
  const Vector axis({1. / 3, 2. / 3, 2. / 3}), shift({4, -7, 2});
  const double angle = 70 * std::acos(-1.) / 180;
  const contact::CurrentPosition position = {mesh, state.displacement};
  State result = state;
  for (Node n = 0; n < mesh.nodes.size(); ++n) {
    const Vector x = position(n);
    const Vector y = std::cos(angle) * x + std::sin(angle) * cross_product_3d(axis, x) +
                     (1 - std::cos(angle)) * (axis * x) * axis + shift;
    for (int i = 0; i < 3; ++i)
      result.displacement[3 * n + i] = y[i] - mesh.nodes[n][i];
  }
  return result;
}

std::set<std::uint32_t> touched_cells(const ContactWork &work, const State &state)
{
  std::set<std::uint32_t> cells;
  for (const ContactPoint &p : work.contact_points(state))
    cells.insert(p.primary->cell);
  return cells;
}

} // namespace

TEST_CASE("flat contact carries the pressure of the law over the plate's area")
{
  const ContactScene scene = flat_scene();
  ContactWork work(scene.mesh, scene.pair, all_owned);
  work.begin_step(scene.state, {.dt = 1e-3});
  const ContactSummary summary = work.summary(scene.state);
  const double pressure = 9 * (0.1 - 0.03);
  CHECK(summary.points == 25);
  CHECK(summary.area == Approx(0.64).epsilon(1e-12));
  CHECK(summary.penetration == Approx(0.1).epsilon(1e-12));
  CHECK(summary.secondary_force[2] == Approx(0.64 * pressure).epsilon(1e-12));
  CHECK(summary.primary_force.size() == 6);
  CHECK(summary.primary_force[5][2] == Approx(-0.64 * pressure).epsilon(1e-12)); // block.z1
  CHECK(work.contact_points(scene.state).front().pressure == Approx(pressure).epsilon(1e-12));
}

TEST_CASE("a cell thinner than twice the thickness is touched at its real surface")
{
  ContactScene scene;
  add_block(scene.mesh, "block", {1, 1, 1}, [](auto p) { return std::array<double, 3>{p[0], p[1], 0.4 * p[2]}; });
  add_block(scene.mesh, "plate", {1, 1, 1}, [](auto p) {
    return std::array<double, 3>{p[0], p[1], 0.38 + 0.4 * p[2]};
  });
  scene.pair = {"pair", {"plate.z0"}, {"block.z1", "block.z0"}, 0, 0.3, 9, 0.06};
  scene.state.displacement.assign(3 * scene.mesh.nodes.size(), 0.);
  ContactWork work(scene.mesh, scene.pair, all_owned);
  work.begin_step(scene.state, {.dt = 1e-3});
  CHECK(work.summary(scene.state).penetration == Approx(0.02).epsilon(1e-10));
}

TEST_CASE("a rigid motion of everything changes no energy, and forces and moments balance")
{
  for (const ContactScene &scene : {interior_scene(), edge_scene(), corner_scene()}) {
    ContactWork work(scene.mesh, scene.pair, all_owned);
    work.begin_step(scene.state, {.dt = 1e-3});
    const State rotated = turned(scene.mesh, scene.state);
    CHECK(work.energy(rotated) == Approx(work.energy(scene.state)).epsilon(1e-12));
    for (const State &state : {scene.state, rotated}) {
      const auto forces = residual(work, state);
      const auto [force, moment] = resultant(scene.mesh, state, forces);
      CHECK(force.norm() < 1e-12 * norm(forces));
      CHECK(moment.norm() < 1e-12 * norm(forces) * 10);
    }
  }
}

TEST_CASE("forces on secondary and primary surface are equal and opposite, also with friction")
{
  const ContactScene scene = edge_scene();
  ContactWork work(scene.mesh, scene.pair, all_owned);
  work.begin_step(scene.state, {.dt = 1e-3});
  const State slid = with_plate_moved(scene, Vector({-0.02, 0.03, -0.02}));
  const ContactSummary summary = work.summary(slid);
  Vector sum, largest;
  for (int i = 0; i < 3; ++i) {
    sum[i] = summary.secondary_force[i];
    largest[i] = std::abs(sum[i]);
    for (const auto &force : summary.primary_force)
      sum[i] += force[i];
  }
  CHECK(largest.norm() > 0.1);
  CHECK(sum.norm() < 1e-12 * largest.norm());
  ContactSummary doubled = summary;
  doubled += summary;
  CHECK(doubled.area == 2 * summary.area);
  CHECK(doubled.penetration == summary.penetration);
}

TEST_CASE("friction tends to the Coulomb limit for large slip and vanishes without slip")
{
  ContactScene scene = flat_scene();
  scene.pair.elastic_slip = 1e-3;
  ContactWork work(scene.mesh, scene.pair, all_owned);
  work.begin_step(scene.state, {.dt = 1e-4});
  const double normal = work.summary(scene.state).secondary_force[2];
  CHECK(std::abs(work.summary(scene.state).secondary_force[0]) < 1e-12 * normal);
  const State slid = with_plate_moved(scene, Vector({0.1, 0, 0}));
  CHECK(work.summary(slid).secondary_force[0] == Approx(-0.3 * normal).epsilon(1e-4));
  const State small = with_plate_moved(scene, Vector({1e-6, 0, 0})); // against an elastic slip of 1e-3 mm
  CHECK(work.summary(small).secondary_force[0] == Approx(-0.3 * normal * 1e-3).epsilon(1e-4));
}

TEST_CASE("after the first iterations the pairing follows only what moves by half the margin")
{
  ContactScene scene;
  for (const double x : {0., 1.1}) // two blocks with a gap of 0.1 mm
    add_block(scene.mesh, x > 0 ? "right" : "left", {1, 1, 1}, [x](auto p) {
      return std::array<double, 3>{x + p[0], p[1], p[2]};
    });
  add_block(scene.mesh, "plate", {1, 1, 1}, [](auto p) {
    return std::array<double, 3>{0.24 + 0.8 * p[0], 0.1 + 0.8 * p[1], 0.9 + 0.4 * p[2]};
  });
  scene.pair = {"pair", {"plate.z0"}, {"left.z1", "right.z1"}, 0, 0.3, 9, 0.06};
  scene.pair.passes = 1;
  scene.state.displacement.assign(3 * scene.mesh.nodes.size(), 0.);
  ContactWork work(scene.mesh, scene.pair, all_owned, {.margin = 0.2});
  work.begin_step(scene.state, {.dt = 1e-3});
  CHECK(touched_cells(work, scene.state) == std::set<std::uint32_t>{0});
  const State nudged = with_plate_moved(scene, Vector({0.09, 0, 0}));
  work.begin_iteration(nudged, 6);
  CHECK(touched_cells(work, nudged) == std::set<std::uint32_t>{0});
  work.begin_iteration(nudged, 5);
  CHECK(touched_cells(work, nudged) == std::set<std::uint32_t>{0, 1});
  const State slid = with_plate_moved(scene, Vector({0.9, 0, 0}));
  work.begin_iteration(slid, 6);
  CHECK(touched_cells(work, slid) == std::set<std::uint32_t>{1});
}

TEST_CASE("contact that began after the last search is found by a new one")
{
  const ContactScene scene = contact_scene(Vector({1, 1, 2}), up, 0.8, 0, {2, 2, 1});
  ContactWork work(scene.mesh, scene.pair, all_owned);
  work.begin_step(scene.state, {.dt = 1e-3}); // 1 mm apart
  const State touching = with_plate_moved(scene, Vector({0, 0, -1.1}));
  CHECK(work.energy(touching) == 0);
  const double missed = work.missed_force(touching);
  CHECK(work.energy(touching) == 0); // looking changes nothing
  work.begin_iteration(touching, 0);
  CHECK(missed > 0.1);
  CHECK(missed == Approx(work.summary(touching).normal_force).epsilon(1e-12));
  CHECK(work.missed_force(touching) < 1e-12);
}

TEST_CASE("with frozen pairing a point slides on to the neighbouring face and around an edge")
{
  ContactScene scene = with_one_pass(contact_scene(Vector({0.6, 1, 0.9}), up, 0.5, 0, {2, 2, 1}));
  scene.pair.friction = 0;
  for (const Vector &motion : {Vector({0.8, 0.2, 0}), Vector({1.4, 0, -0.19})}) { // -0.2 would touch the core
    const State slid = with_plate_moved(scene, motion);
    ContactWork work(scene.mesh, scene.pair, all_owned, {.margin = 1}); // couples cells that far ahead
    work.begin_step(scene.state, {.dt = 1e-3});
    const auto cells = touched_cells(work, scene.state);
    const double frozen = work.energy(slid);
    CHECK(frozen > 1e-3);
    CHECK(touched_cells(work, slid) != cells);
    work.begin_iteration(slid, 0);
    CHECK(frozen == Approx(work.energy(slid)).epsilon(1e-12));
  }
}

TEST_CASE("the tangent couples announced nodes only, and new couplings are reported once")
{
  const ContactScene scene = contact_scene(Vector({0.45, 0.5, 0.9}), up, 0.8, 0, {6, 1, 1});
  ContactWork work(scene.mesh, scene.pair, all_owned, {.margin = 0.05});
  work.begin_step(scene.state, {.dt = 1e-3});
  CHECK(work.couplings_changed());
  work.begin_iteration(scene.state, 0);
  CHECK_FALSE(work.couplings_changed());
  const State slid = with_plate_moved(scene, Vector({1.1, 0, 0}));
  work.begin_iteration(slid, 1);
  CHECK(work.couplings_changed());

  std::vector<std::vector<Node>> announced;
  work.add_couplings(announced);
  DenseAssembly assembly(scene.mesh.nodes.size());
  work.tangent(slid, assembly);
  CHECK(assembly.tangent_nodes.size() > 0);
  for (const auto &nodes : assembly.tangent_nodes)
    CHECK(std::find(announced.begin(), announced.end(), nodes) != announced.end());
}

TEST_CASE("parts of two ranks add up to the whole")
{
  ContactScene scene = contact_scene(Vector({1, 1, 0.9}), up, 1.2, 0.03, {2, 2, 1});
  scene.pair.secondary = all_sides("block");
  scene.pair.primary = {"plate.z0"};
  auto started = [&](const std::function<bool(std::uint32_t)> &owned) {
    auto work = std::make_unique<ContactWork>(scene.mesh, scene.pair, owned);
    work->begin_step(scene.state, {.dt = 1e-3});
    return work;
  };
  const auto whole = started(all_owned);
  const auto even = started([](std::uint32_t c) { return c % 2 == 0; });
  const auto odd = started([](std::uint32_t c) { return c % 2 == 1; });
  CHECK(even->energy(scene.state) > 0);
  CHECK(odd->energy(scene.state) > 0);
  CHECK(even->energy(scene.state) + odd->energy(scene.state) == Approx(whole->energy(scene.state)).epsilon(1e-13));
  ContactSummary sum = even->summary(scene.state);
  sum += odd->summary(scene.state);
  CHECK(sum.points == whole->summary(scene.state).points);
}

TEST_CASE("wrong input is refused")
{
  const ContactScene scene = flat_scene();
  ContactPair unknown = scene.pair, thin = scene.pair;
  unknown.primary = {"nowhere"};
  thin.thickness = 0;
  for (const ContactPair &pair : {unknown, thin})
    CHECK_THROWS_AS(ContactWork(scene.mesh, pair, all_owned), std::invalid_argument);
}

TEST_CASE("a step begins with the state alone, whatever has been before")
{
  const ContactScene scene = contact_scene(Vector({0.45, 0.5, 0.9}), up, 0.8, 0, {6, 1, 1});
  ContactWork fresh(scene.mesh, scene.pair, all_owned), used(scene.mesh, scene.pair, all_owned);
  used.begin_step(with_plate_moved(scene, Vector({1.1, 0, 0})), {.dt = 1e-3});
  used.begin_iteration(with_plate_moved(scene, Vector({0.9, 0, 0})), 20); // crossing is off now
  std::vector<std::vector<Node>> couplings, expected_couplings;
  for (ContactWork *work : {&used, &fresh})
    work->begin_step(scene.state, {.dt = 1e-3});
  used.add_couplings(couplings);
  fresh.add_couplings(expected_couplings);
  CHECK(couplings == expected_couplings);
  const State slid = with_plate_moved(scene, Vector({0.1, 0, 0}));
  DenseAssembly assembly(scene.mesh.nodes.size()), expected(scene.mesh.nodes.size());
  used.residual(slid, assembly);
  used.tangent(slid, assembly);
  fresh.residual(slid, expected);
  fresh.tangent(slid, expected);
  CHECK(norm(expected.residual) > 1e-3);
  CHECK(assembly.residual == expected.residual);
  CHECK(assembly.tangent == expected.tangent);
}
