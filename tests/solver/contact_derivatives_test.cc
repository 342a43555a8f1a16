// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/contact_scene.h"
#include <catch2/catch.hpp>
#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/lapack_full_matrix.h>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

DenseAssembly assembled(const ContactWork &work, const State &state)
{
  DenseAssembly assembly(state.displacement.size() / 3);
  work.residual(state, assembly);
  work.tangent(state, assembly);
  return assembly;
}

/// Residual against differences of the energy and tangent against differences of the residual, in random directions.
void check_derivatives(const ContactWork &work, const State &state)
{
  const std::size_t n = state.displacement.size();
  const DenseAssembly exact = assembled(work, state);
  REQUIRE(norm(exact.residual) > 5e-3);
  for (unsigned seed = 0; seed < 5; ++seed) {
    const auto direction = random_field(n, 1, seed);
    const double h = 1e-6;
    const double slope = (work.energy(moved(state, direction, h)) - work.energy(moved(state, direction, -h))) / (2 * h);
    CHECK(std::abs(slope - dot(exact.residual, direction)) < 1e-7 * norm(exact.residual));

    DenseAssembly plus(n / 3, false), minus(n / 3, false);
    work.residual(moved(state, direction, h), plus);
    work.residual(moved(state, direction, -h), minus);
    std::vector<double> product(n), difference(n);
    for (std::size_t i = 0; i < n; ++i) {
      product[i] = dot(std::span(exact.tangent).subspan(n * i, n), direction);
      difference[i] = product[i] - (plus.residual[i] - minus.residual[i]) / (2 * h);
    }
    CHECK(norm(difference) < 1e-6 * norm(product));
  }
}

void check_symmetry(const DenseAssembly &assembly)
{
  const std::size_t n = assembly.residual.size();
  double largest = 0, asymmetry = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) {
      largest = std::max(largest, std::abs(assembly.tangent[n * i + j]));
      asymmetry = std::max(asymmetry, std::abs(assembly.tangent[n * i + j] - assembly.tangent[n * j + i]));
    }
  CHECK(asymmetry < 1e-12 * largest);
}

enum class Felt { by_secondary, by_primary };

/// How many touching points of a surface have their closest point inside a patch (2), on an edge (1), on a corner (0).
std::array<int, 3> kinds(const ContactScene &scene, Felt felt)
{
  contact::ContactPairing pairing(scene.mesh, scene.pair, all_owned, 1);
  pairing.search(scene.state.displacement);
  std::array<int, 3> count = {};
  for (const contact::PairedPoint &p : pairing.touching(scene.state.displacement))
    if (pairing.is_secondary(p.own) == (felt == Felt::by_secondary))
      ++count[p.closest.free[0] + p.closest.free[1]];
  return count;
}

int number(const std::array<int, 3> &kinds) { return kinds[0] + kinds[1] + kinds[2]; }

void check_scene(const ContactScene &scene)
{
  ContactPair pair = scene.pair;
  pair.friction = 0;
  ContactWork smooth(scene.mesh, pair, all_owned);
  smooth.begin_step(scene.state, {.dt = 1e-3});
  check_derivatives(smooth, scene.state);
  check_symmetry(assembled(smooth, scene.state));

  // slid by about the elastic slip after it has stuck, with another stored pressure
  pair = scene.pair;
  pair.elastic_slip = 9e-3, pair.viscous_velocity = 30;
  ContactWork rough(scene.mesh, pair, all_owned);
  State stuck = scene.state;
  stuck.friction = random_field(3 * rough.number_points_from(0), 0.2, 9);
  rough.begin_step(stuck, {.dt = 3e-3});
  const State slid = moved(scene.state, random_field(scene.state.displacement.size(), 0.02, 5), 1);
  const std::vector<double> none(slid.displacement.size(), 0.);
  rough.advance(slid, none, 1);
  check_derivatives(rough, slid);
  check_symmetry(assembled(rough, slid));
}

double smallest_eigenvalue(const DenseAssembly &assembly)
{
  const std::size_t n = assembly.residual.size();
  dealii::LAPACKFullMatrix<double> matrix(n);
  dealii::FullMatrix<double> vectors;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j)
      matrix(i, j) = assembly.tangent[n * i + j];
  dealii::Vector<double> values;
  matrix.compute_eigenvalues_symmetric(-1e9, 1e9, 0, values, vectors);
  return *std::min_element(values.begin(), values.end());
}

} // namespace

TEST_CASE("contact derivatives inside a face")
{
  for (const int passes : {1, 2}) {
    ContactScene scene = interior_scene();
    scene.pair.passes = passes;
    CHECK(kinds(scene, Felt::by_secondary)[2] > 10);
    CHECK(kinds(scene, Felt::by_primary)[2] > (passes == 1 ? -1 : 10));
    check_scene(scene);
  }
}

TEST_CASE("contact derivatives at an edge")
{
  for (const int passes : {1, 2}) {
    ContactScene scene = edge_scene();
    scene.pair.passes = passes;
    CHECK(kinds(scene, Felt::by_secondary)[1] > 3);
    check_scene(scene);
  }
}

TEST_CASE("contact derivatives at a corner")
{
  for (const int passes : {1, 2}) {
    ContactScene scene = corner_scene();
    scene.pair.passes = passes;
    CHECK(kinds(scene, Felt::by_secondary)[0] >= 3);
    check_scene(scene);
  }
}

TEST_CASE("contact derivatives where only an edge or a corner of the primary surface feels a coarse face")
{
  for (const Vector &up : {Vector({1, 0, 1}), Vector({1, 1, 1})}) {
    ContactScene scene =
        contact_scene(up == Vector({1, 0, 1}) ? Vector({1.85, 1, 0.85}) : Vector({1.82, 1.82, 0.82}), up, 9);
    scene.pair.points_per_side = 2; // 5 mm apart
    CHECK(number(kinds(scene, Felt::by_secondary)) == 0);
    CHECK(kinds(scene, Felt::by_primary)[2] >= 3);
    check_scene(scene);
  }
}

TEST_CASE("contact derivatives where points of the primary surface feel the rim of the secondary one")
{
  const ContactScene scene = contact_scene(Vector({1, 1, 0.9}), Vector({0, 0, 1}), 0.8);
  CHECK(kinds(scene, Felt::by_primary)[1] > 3);
  check_scene(scene);
}

TEST_CASE("the stored pressure follows the linear prediction and leaves the residual alone")
{
  const ContactScene scene = interior_scene();
  ContactWork work(scene.mesh, scene.pair, all_owned);
  work.begin_step(scene.state, {.dt = 1e-3});
  const State next = with_plate_moved(scene, Vector({0, 0, 1e-4}));
  std::vector<double> increment(next.displacement);
  const DenseAssembly before = assembled(work, next);
  work.advance(scene.state, increment, 1);
  const DenseAssembly predicted = assembled(work, next);
  work.advance(next, std::vector<double>(increment.size(), 0.), 1);
  const DenseAssembly exact = assembled(work, next);

  CHECK(before.residual == predicted.residual);
  auto distance = [](const DenseAssembly &a, const DenseAssembly &b) {
    std::vector<double> difference(a.tangent);
    for (std::size_t i = 0; i < difference.size(); ++i)
      difference[i] -= b.tangent[i];
    return norm(difference);
  };
  CHECK(distance(before, exact) > 1e-6 * norm(exact.tangent)); // pressure of the old state: first order
  CHECK(distance(predicted, exact) < 0.02 * distance(before, exact));
}

TEST_CASE("made convex, the tangent has no negative eigenvalue and the residual is the same")
{
  const ContactScene scene = edge_scene();
  ContactWork work(scene.mesh, scene.pair, all_owned);
  work.begin_step(scene.state, {.dt = 1e-3});
  const DenseAssembly exact = assembled(work, scene.state);
  work.convexify(true);
  const DenseAssembly convex = assembled(work, scene.state);
  work.convexify(false);
  const double rounding = 1e-10 * norm(exact.tangent);
  CHECK(smallest_eigenvalue(exact) < -1e-4 * norm(exact.tangent));
  CHECK(smallest_eigenvalue(convex) > -rounding);
  CHECK(convex.residual == exact.residual);
  CHECK(assembled(work, scene.state).tangent == exact.tangent);
}
