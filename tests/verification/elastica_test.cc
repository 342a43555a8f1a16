// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/box_mesh.h"
#include "tests/support/comparison.h"
#include "tests/support/elastica.h"
#include "tests/support/run_to_end.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

TEST_CASE("the elastica computed here is the one of the literature")
{
  // Mattiasson, Numerical results from large deflection beam and frame problems (1981), table 1, P L^2 / E I = 4
  const Tip tip = elastica(4);
  CHECK(tip.y == Approx(0.66996).margin(1e-5));
  CHECK(1 - tip.x == Approx(0.32894).margin(1e-5));
}

// A slender cantilever (length 40 times the height) with a dead shear force at its end. Shear and stretch of the real
// beam, which the elastica has not, are of the order (h / L)^2 = 6e-4.
TEST_CASE("cantilever with a dead end force follows Euler's elastica")
{
  const double length = 40, modulus = 1000, alpha = 4, force = alpha * modulus / 12 / (length * length);
  const auto mesh = box_mesh(16, 1, 1, [&](Point3 x) { return Point3{length * x[0], x[1] - 0.5, x[2] - 0.5}; });
  Parameters parameters;
  parameters.materials.resize(1);
  auto &m = parameters.materials[0];
  m.name = "steel", m.law = Law::saint_venant, m.youngs_modulus = modulus, m.poisson_ratio = 0;
  parameters.bodies = {{"body", "steel"}};
  parameters.supports = {{"x0", {"x", "y", "z"}}};
  parameters.loads = {{"x1", {0, force, 0}, 0}};
  parameters.path.control = Control::load;
  parameters.path.load_steps = 2;
  parameters.newton.force_floor = 1e-3;
  Simulation simulation(parameters, mesh, MPI_COMM_SELF);
  run_to_end(simulation);

  double x = 0, y = 0, count = 0;
  for (const auto node : surface_nodes(mesh, "x1"))
    if (mesh.nodes[node][1] == 0 && mesh.nodes[node][2] == 0) {
      x += simulation.progress().state.displacement[3 * node];
      y += simulation.progress().state.displacement[3 * node + 1];
      ++count;
    }
  REQUIRE(count == 1);
  const Tip tip = elastica(alpha);
  const char *source = "Euler's elastica, integrated in the test; Mattiasson (1981)";
  compare({"cantilever, P L^2 / E I = 4: deflection of the tip", source, length * tip.y, y, 0.01, "mm"});
  compare({"cantilever, P L^2 / E I = 4: shortening", source, length * (1 - tip.x), -x, 0.01, "mm"});
}
