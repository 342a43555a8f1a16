// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/equilibrium.h"
#include "studies/simulation_model.h"
#include "tests/support/comparison.h"
#include "tests/verification/small_swing.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::studies;
using namespace ballonet::tests;
namespace geometry = ballonet::geometry;

namespace
{

SimulationModel bare_backbone(const geometry::MeshSizes &mesh)
{
  Study study = default_study(ActuatorKind::pebs);
  study.actuator.pebs.with_balloon = false;
  study.path.control = Control::release;
  study.mesh = mesh;
  auto model = build_model(study);
  REQUIRE(std::holds_alternative<SimulationModel>(model));
  return std::get<SimulationModel>(std::move(model));
}

State drooping(Equilibrium &equilibrium)
{
  State state = equilibrium.initial_state();
  const auto outcome = equilibrium.solve(state, {.dt = 1e6}, {}); // without viscous stress
  INFO(outcome.reason);
  REQUIRE(outcome.converged);
  return state;
}

} // namespace

// The reduced model is a chain of rigid ribs on elastic hinges (tests/reduced): 1.43 Hz about its droop, 2.11 Hz
// without weight. The two models differ in their droop by some degrees; the weight takes a third off the frequency.
TEST_CASE("first mode of the default backbone, weightless and about its droop")
{
  const auto model = bare_backbone({});
  const Mesh mesh = solver_mesh(model.mesh);
  Equilibrium equilibrium(model.parameters, mesh, MPI_COMM_SELF);
  const auto upright = equilibrium.modes(equilibrium.initial_state(), {.count = 1})[0];
  const auto hanging = equilibrium.modes(drooping(equilibrium), {.count = 1})[0];
  const char *source = "reduced model: rigid ribs on elastic hinges";
  compare({"backbone without weight: first natural frequency", source, 2.11, upright.frequency(), 0.05, "Hz"});
  compare({"backbone about its droop: first natural frequency", source, 1.43, hanging.frequency(), 0.05, "Hz"});
}

// In a step as long as h the viscosity C adds C / h to the tangent, and to first order shape . C shape / (h shape . M
// shape) = 2 zeta omega / h to omega^2: the damping ratio zeta of the mode without following it in time.
TEST_CASE("a small swing of the drooping backbone has the frequency of its first mode, damped by the relaxation time")
{
  auto model = bare_backbone({.along_fold = 6, .across_wall = 2, .around_ring = 16});
  model.parameters.newton = {.tolerance = 1e-7, .force_floor = 1e-2}; // the swing's forces are of the order of 1e-4 N
  const Mesh mesh = solver_mesh(model.mesh);
  Equilibrium equilibrium(model.parameters, mesh, MPI_COMM_SELF);
  const State state = drooping(equilibrium);
  const auto mode = equilibrium.modes(state, {.count = 1})[0];
  const auto swing = small_swing(equilibrium, state, mode, 0.5, 2, 30);
  compare({"backbone, coarse mesh: frequency of a small swing", "its own first mode", mode.frequency(), swing.frequency,
           1e-2, "Hz"});
  const double h = 10, omega = 2 * M_PI * mode.frequency();
  const auto stiffened = equilibrium.modes(state, {.count = 1, .dt = h})[0];
  compare({"backbone, coarse mesh: damping ratio of that swing", "viscosity of the first mode, to first order",
           (stiffened.omega_squared - mode.omega_squared) * h / (2 * omega), swing.damping_ratio, 2e-2});
}
