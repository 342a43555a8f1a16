// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/cavity_work.h"
#include "tests/support/box_mesh.h"
#include "tests/support/derivative_check.h"
#include "tests/support/round_mesh.h"

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

double volume(const Mesh &mesh, const Cavity &cavity)
{
  const Discretization discretization(mesh, MPI_COMM_SELF);
  State rest;
  rest.displacement.assign(3 * mesh.nodes.size(), 0.);
  return CavityWork(discretization, cavity).volume(rest);
}

} // namespace

TEST_CASE("cavity: gas between a block and a parallel plane, and a pyramid")
{
  const auto block = box_mesh(2, 3, 1, [](Point3 x) { return Point3{4 * x[0] + x[1], 5 * x[1], 2 * x[2]}; });
  // over the parallelogram of 20 mm^2 at z = 2, up to z = 5 or to the apex (1, 1, 5)
  CHECK(volume(block, {"z1", {0, 0, 5}, {"z"}}) == Approx(60));
  CHECK(volume(block, {"z1", {1, 1, 5}, {"x", "y", "z"}}) == Approx(20));
}

// The quadratic faces miss the circle by the fourth power of their angle: 5e-5 of the volume with four on a quarter.
TEST_CASE("cavity: quarter of a cylinder and eighth of a sphere")
{
  const auto tube = quarter_tube(3, 4, 7, 1, 4, 2);
  CHECK(volume(tube, {"inner", {0, 0, 0}, {"x", "y"}}) == Approx(M_PI / 4 * 9 * 7).epsilon(1e-4));
  CHECK(volume(tube, {"inner", {0, 0, 0}, {"x"}}) == Approx(M_PI / 4 * 9 * 7).epsilon(1e-4));
  CHECK(volume(eighth_sphere(3, 4, 1, 3), {"inner"}) == Approx(M_PI / 6 * 27).epsilon(1e-4));
}

TEST_CASE("cavity: pressure forces and their tangent are derivatives of the volume")
{
  const auto mesh = eighth_sphere(3, 4, 1, 1);
  const Discretization discretization(mesh, MPI_COMM_SELF);
  State state;
  state.displacement = random_field(3 * mesh.nodes.size(), 0.1, 2);
  state.pressure = 0.7;
  for (const std::vector<std::string> &directions : {std::vector<std::string>{"x", "y", "z"}, {"x", "y"}, {"z"}}) {
    const CavityWork work(discretization, {"inner", {0.3, -0.2, 0.1}, directions});
    check_residual(work, state);
    check_tangent(work, state, [&](const State &at) { return residual(work, at); });

    DenseAssembly gradient(mesh.nodes.size(), false);
    work.volume_gradient(state, gradient);
    const auto forces = residual(work, state);
    for (std::size_t i = 0; i < forces.size(); ++i)
      CHECK(forces[i] == Approx(-0.7 * gradient.residual[i]).margin(1e-14));
  }
}

TEST_CASE("cavity: nothing to measure is refused")
{
  CHECK_THROWS_AS(volume(box_mesh(1, 1, 1), {"z1", {0, 0, 0}, {}}), std::invalid_argument);
  CHECK_THROWS_AS(volume(box_mesh(1, 1, 1), {"nowhere"}), std::invalid_argument);
}
