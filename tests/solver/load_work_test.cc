// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/load_work.h"
#include "tests/support/box_mesh.h"
#include "tests/support/derivative_check.h"
#include "tests/support/round_mesh.h"
#include <numeric>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

State at_rest(const Mesh &mesh)
{
  State state;
  state.displacement.assign(3 * mesh.nodes.size(), 0.);
  state.velocity = state.displacement;
  state.load_factor = 1;
  return state;
}

Vector3 total(const std::vector<double> &forces)
{
  Vector3 sum{};
  for (std::size_t i = 0; i < forces.size(); ++i)
    sum[i % 3] += forces[i];
  return sum;
}

void check_equal(const Vector3 &value, const Vector3 &expected)
{
  for (int d = 0; d < 3; ++d)
    CHECK(value[d] == Approx(expected[d]).margin(1e-12));
}

Load pressure_on(const std::string &surface, double pressure) { return {surface, {0, 0, 0}, pressure}; }

} // namespace

TEST_CASE("follower load: total force on flat and curved faces, at rest and stretched")
{
  const auto block = box_mesh(1, 2, 1, [](Point3 x) { return Point3{2 * x[0], 3 * x[1], x[2]}; });
  const Discretization flat(block, MPI_COMM_SELF);
  const FollowerLoad on_top(flat, pressure_on("z1", 0.2));
  State state = at_rest(block);
  check_equal(total(residual(on_top, state)), {0, 0, 0.2 * 6}); // the residual is minus the force, which acts downwards
  for (std::size_t n = 0; n < block.nodes.size(); ++n)
    state.displacement[3 * n] = 0.5 * block.nodes[n][0];
  check_equal(total(residual(on_top, state)), {0, 0, 0.2 * 9});

  const auto tube = quarter_tube(3, 4, 7, 1, 2, 1);
  const Discretization curved(tube, MPI_COMM_SELF);
  check_equal(total(residual(FollowerLoad(curved, pressure_on("outer", 0.2)), at_rest(tube))),
              {0.2 * 28, 0.2 * 28, 0}); // pressure times projected area
  check_equal(total(residual(FollowerLoad(curved, pressure_on("inner", 0.2)), at_rest(tube))),
              {-0.2 * 21, -0.2 * 21, 0});
}

TEST_CASE("follower load: potential where the rim is at rest, symmetric part of the tangent elsewhere")
{
  const auto mesh = box_mesh(2, 2, 1);
  const Discretization discretization(mesh, MPI_COMM_SELF);
  FollowerLoad load(discretization, pressure_on("z1", 0.8));
  State state = at_rest(mesh);
  state.load_factor = 0.5;
  state.displacement = random_field(state.displacement.size(), 0.05, 3);
  const auto exact = assembled(load, state);
  const double h = 1e-6;

  auto inside = random_field(state.displacement.size(), 1, 4);
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    for (int d = 0; d < 2; ++d)
      if (mesh.nodes[n][d] == 0 || mesh.nodes[n][d] == 1)
        std::fill_n(&inside[3 * n], 3, 0.);
  const double slope = (load.energy(moved(state, inside, h)) - load.energy(moved(state, inside, -h))) / (2 * h);
  CHECK(slope == Approx(dot(exact.residual, inside)).margin(1e-9));

  const auto anywhere = random_field(state.displacement.size(), 1, 5);
  const auto plus = residual(load, moved(state, anywhere, h)), minus = residual(load, moved(state, anywhere, -h));
  CHECK(dot(anywhere, product(exact, anywhere)) ==
        Approx((dot(anywhere, plus) - dot(anywhere, minus)) / (2 * h)).margin(1e-8));
}

TEST_CASE("dead load: traction times area plus weight, scaled with the load factor")
{
  const auto mesh = quarter_tube(3, 4, 7, 1, 6, 1);
  const Discretization discretization(mesh, MPI_COMM_SELF);
  std::vector<double> mass(mesh.nodes.size());
  add_nodal_mass(discretization, 0, 2e-3, mass);
  DeadLoad load(discretization, mass, {0, 0, -10}, {{"y0", {1, 2, 3}, 0}, {"x0", {0, 0, 1}, 0}});
  const double weight = 10 * std::accumulate(mass.begin(), mass.end(), 0.);
  State state = at_rest(mesh);
  state.load_factor = 0.5;
  check_equal(total(residual(load, state)), {-3.5, -7, -10.5 - 3.5 + weight / 2}); // faces of 7 mm^2
  state.displacement = random_field(state.displacement.size(), 1, 3);
  check_residual(load, state);
}

TEST_CASE("mass: all nodes positive, in sum density times volume")
{
  const auto mesh = eighth_sphere(3, 4, 2, 2);
  const Discretization discretization(mesh, MPI_COMM_SELF);
  std::vector<double> mass(mesh.nodes.size());
  add_nodal_mass(discretization, 0, 1.2e-9, mass);
  CHECK(*std::min_element(mass.begin(), mass.end()) > 0);
  const double volume = M_PI / 6 * (64 - 27);
  CHECK(std::accumulate(mass.begin(), mass.end(), 0.) == Approx(1.2e-9 * volume).epsilon(1e-3));
}
