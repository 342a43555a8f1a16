// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/equilibrium.h"
#include "tests/support/comparison.h"
#include "tests/support/round_mesh.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

struct Work {
  double inflation = 0; ///< of the gas on the way up, N mm
  double cycle = 0;     ///< over the whole way
  double dissipated = 0;
  double stored = 0; ///< at the end
};

/// Inflates a thick sphere from V0 to 8 V0, through its limit pressure, and back again in equal times. The gas does the
/// work of p dV by the trapezoidal rule.
Work inflate_and_deflate(double relaxation_time, int steps)
{
  const auto mesh = eighth_sphere(1, 1.6, 2, 2);
  Parameters parameters;
  parameters.materials.resize(1);
  auto &rubber = parameters.materials[0];
  rubber.name = "rubber", rubber.c10 = 0.15, rubber.d1 = 0.01, rubber.relaxation_time = relaxation_time;
  parameters.bodies = {{"body", "rubber", true}};
  parameters.supports = {{"x0", {"x"}}, {"y0", {"y"}}, {"z0", {"z"}}};
  parameters.cavity = Cavity{"inner"};
  parameters.newton = {.tolerance = 1e-9, .force_floor = 1e-2};
  Equilibrium equilibrium(parameters, mesh, MPI_COMM_SELF);
  State state = equilibrium.initial_state();
  const double start = equilibrium.volume(state);
  Work work;
  double volume = start, radius = 1;
  for (int k = 1; k <= 2 * steps; ++k) {
    radius += (k <= steps ? 1. : -1.) / steps;
    const double pressure = state.pressure, target = start * radius * radius * radius;
    const auto outcome =
        equilibrium.solve(state, {.dt = 1. / steps}, {.what = NewtonSolver::Prescribe::volume, .volume = target});
    INFO(outcome.reason);
    REQUIRE(outcome.converged);
    const double gained = (pressure + state.pressure) / 2 * (target - volume);
    work.cycle += gained;
    work.inflation += k <= steps ? gained : 0;
    work.dissipated += equilibrium.energies(state).dissipated;
    volume = target;
  }
  work.stored = equilibrium.energies(state).stored;
  return work;
}

} // namespace

TEST_CASE("energy: an elastic body gives back over a slow cycle what was put in")
{
  const auto work = inflate_and_deflate(0, 20);
  const char *source = "conservation of energy";
  const auto kind = Comparison::Kind::absolute;
  compare({"thick sphere, V0 to 8 V0 and back, elastic: work kept over work put in", source, 0,
           work.cycle / work.inflation, 1e-7, "1", kind});
  CHECK(work.dissipated == 0);
  CHECK(work.stored < 1e-7 * work.inflation);
}

// Backward Euler takes the viscous stress at the end of a step, the work above its mean: they meet like the step.
TEST_CASE("energy: the work put into a viscous body over a cycle is what the viscosity took")
{
  const double tau = 0.02; // of 1 s up and 1 s down
  const auto coarse = inflate_and_deflate(tau, 20), fine = inflate_and_deflate(tau, 40);
  const auto miss = [](const Work &work) { return work.cycle / (work.dissipated + work.stored) - 1; };
  INFO("work put in " << fine.inflation << ", kept " << fine.cycle << " N mm, miss in 20 steps " << miss(coarse));
  CHECK(fine.cycle > 0.02 * fine.inflation);
  compare({"thick sphere, V0 to 8 V0 and back, viscous: work kept over work of the viscosity, 40 steps up",
           "conservation of energy", 1, fine.cycle / (fine.dissipated + fine.stored), 3e-2});
  compare({"thick sphere, the same: error in 20 steps over that in 40", "theory: 2 for backward Euler", 1.7,
           miss(coarse) / miss(fine), 0, "1", Comparison::Kind::at_least});
}
