// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/equilibrium.h"
#include "tests/support/contact_scene.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

TEST_CASE("a state whose contact the present pairs do not know is objected to, with the reason")
{
  const ContactScene scene = contact_scene(Vector({1, 1, 2}), Vector({0, 0, 1}), 0.8, 0, {2, 2, 1});
  Parameters parameters;
  parameters.materials.resize(1);
  parameters.materials[0].name = "rubber", parameters.materials[0].c10 = 0.2, parameters.materials[0].d1 = 0.5;
  parameters.bodies = {{"block", "rubber"}, {"plate", "rubber"}};
  parameters.supports = {{"block.z0", {"x", "y", "z"}}, {"plate.z1", {"x", "y", "z"}}};
  parameters.contact_pairs = {scene.pair};
  Equilibrium equilibrium(parameters, scene.mesh, MPI_COMM_SELF);
  State state = equilibrium.initial_state();
  REQUIRE(equilibrium.solve(state, {.dt = 1}, {}).converged);
  CHECK(equilibrium.contacts().objection(state) == "");
  const State touching = with_plate_moved(scene, Vector({0, 0, -1.1})); // within all limits of penetration
  CHECK_THAT(equilibrium.contacts().objection(touching), Catch::Contains("a new search finds"));
}
