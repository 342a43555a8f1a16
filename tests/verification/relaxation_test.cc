// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/simulation.h"
#include "tests/support/comparison.h"
#include "tests/support/rubber_sphere.h"
#include "tests/support/thick_wall.h"
#include <catch2/catch.hpp>
#include <cmath>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

/// A thick neo-Hookean sphere whose viscosity doubles its pressure in a step from V0 to 2 V0 within 20 ms.
struct ViscousSphere : RubberSphere {
  ViscousSphere() : RubberSphere(inner_radius, outer_radius, wall_mu)
  {
    parameters.materials[0].density = 1e-9, parameters.materials[0].relaxation_time = 0.02;
    parameters.cavity = Cavity{"inner"};
  }
};

const char *const source = "incompressible neo-Hookean sphere, exact (Green and Zerna 1954)";

} // namespace

TEST_CASE("relaxation: a viscous sphere driven fast and left alone at its volume has the pressure of the elastic one")
{
  const ViscousSphere sphere;
  Equilibrium equilibrium(sphere.parameters, sphere.mesh, MPI_COMM_SELF);
  State state = equilibrium.initial_state();
  const NewtonSolver::Target doubled = {.what = NewtonSolver::Prescribe::volume,
                                        .volume = 2 * equilibrium.volume(state)};
  REQUIRE(equilibrium.solve(state, {.dt = 0.02, .inertia = true}, doubled).converged);
  compare({"viscous sphere driven to 2 V0 in one relaxation time: pressure over that of the elastic one",
           "at least 1.5, else the case shows nothing", 1.5, state.pressure / sphere_pressure(2), 0, "1",
           Comparison::Kind::at_least});
  const auto outcome = equilibrium.solve(state, {.dt = infinity, .inertia = false, .rates = false}, doubled);
  REQUIRE(outcome.converged);
  compare({"the same relaxed at held volume: pressure", source, 1e3 * sphere_pressure(2), 1e3 * state.pressure, 1e-3,
           "kPa"});
  const auto zero = [](double value) { return value == 0; };
  CHECK(std::all_of(state.velocity.begin(), state.velocity.end(), zero));
  CHECK(std::all_of(state.acceleration.begin(), state.acceleration.end(), zero));
  CHECK(equilibrium.energies(state).dissipated == 0);
  CHECK(equilibrium.energies(state).kinetic == 0);
}

TEST_CASE("relaxation: the path of a viscous sphere under its volume is that of the elastic one, whatever the rate")
{
  ViscousSphere sphere;
  auto &path = sphere.parameters.path;
  path.volume_rate = 50, path.volume_max = 6, path.step_max = 0.01,
  path.preload_steps = 1; // to 6 V0 in five relaxation times
  const auto error_of_path = [&](Rates rates) {
    sphere.parameters.path.rates = rates;
    Simulation simulation(sphere.parameters, sphere.mesh, MPI_COMM_SELF);
    double worst = 0;
    const auto result = simulation.run(
        [&](const PathPoint &point) {
          CHECK(point.at_rest == (rates == Rates::where_needed || point.progress.step == 1));
          const double ratio = point.progress.volume / point.reference_volume;
          if (ratio > 1.5)
            worst = std::max(worst, std::abs(point.progress.state.pressure / sphere_pressure(ratio) - 1));
          return "";
        },
        [](const std::string &) {});
    INFO(result.reason);
    REQUIRE(result.status == PathStatus::ended);
    return worst;
  };
  compare({"viscous sphere, path to 6 V0: largest relative error of a pressure called equilibrium", source, 0,
           error_of_path(Rates::where_needed), 1e-3, "1", Comparison::Kind::absolute});
  compare({"the same in motion (rates = always): relative error", "at least 0.1, else the case shows nothing", 0.1,
           error_of_path(Rates::always), 0, "1", Comparison::Kind::at_least});
}
