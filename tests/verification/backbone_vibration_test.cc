// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/equilibrium.h"
#include "studies/simulation_model.h"
#include "tests/support/comparison.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::studies;
using namespace ballonet::tests;

namespace
{

SimulationModel bare_backbone()
{
  Study study = default_study(ActuatorKind::pebs);
  study.actuator.pebs.with_balloon = false;
  study.path.control = Control::load;
  auto model = build_model(study);
  REQUIRE(std::holds_alternative<SimulationModel>(model));
  return std::get<SimulationModel>(std::move(model));
}

} // namespace

// The reduced model is a chain of rigid ribs on elastic hinges (tests/reduced): 1.43 Hz about its droop, 2.11 Hz
// without weight. The two models differ in their droop by some degrees; the weight takes a third off the frequency.
TEST_CASE("first mode of the default backbone, weightless and about its droop")
{
  const auto model = bare_backbone();
  const Mesh mesh = solver_mesh(model.mesh);
  Equilibrium equilibrium(model.parameters, mesh, MPI_COMM_SELF);
  State state = equilibrium.initial_state();
  const auto upright = equilibrium.modes(state, {.count = 1})[0];
  const auto outcome = equilibrium.solve(state, {.dt = 10}, {});
  INFO(outcome.reason);
  REQUIRE(outcome.converged);
  const auto drooping = equilibrium.modes(state, {.count = 1})[0];
  const char *source = "reduced model: rigid ribs on elastic hinges";
  compare({"backbone without weight: first natural frequency", source, 2.11, upright.frequency(), 0.05, "Hz"});
  compare({"backbone about its droop: first natural frequency", source, 1.43, drooping.frequency(), 0.05, "Hz"});
}
