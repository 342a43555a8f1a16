// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/cantilever_beam.h"
#include "tests/support/comparison.h"
#include "tests/verification/small_swing.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

/// Mean displacement of the end of the beam, as a direction.
Vector3 end_motion(const Mode &mode, const Mesh &mesh)
{
  Vector3 mean{};
  for (const auto node : surface_nodes(mesh, "x1"))
    for (int d = 0; d < 3; ++d)
      mean[d] += std::abs(mode.shape[3 * node + d]);
  return mean;
}

/// The n-th mode (0, 1, ...) that moves the end along `direction` more than along the others.
const Mode &along(const std::vector<Mode> &modes, const Mesh &mesh, int direction, int n = 0)
{
  for (const auto &mode : modes) {
    const auto motion = end_motion(mode, mesh);
    if (std::max_element(motion.begin(), motion.end()) - motion.begin() == direction && n-- == 0)
      return mode;
  }
  FAIL("there is no such mode along " << direction);
  return modes.front();
}

/// A soft beam that hangs down under its weight by half its length.
struct DroopingBeam {
  CantileverBeam beam;
  DroopingBeam()
  {
    beam.parameters.materials[0].youngs_modulus = 0.2;
    beam.parameters.gravity = {0, 0, -9810};
    beam.parameters.path.spectral_radius = 1;
    beam.parameters.newton = {.tolerance = 1e-10, .force_floor = 1e-6};
  }
  State hanging(Equilibrium &equilibrium) const
  {
    State state = equilibrium.initial_state();
    for (const double factor : {0.2, 0.4, 0.6, 0.8, 1.}) {
      const auto outcome = equilibrium.solve(state, {.dt = 1e6, .load_factor = factor}, {});
      INFO(outcome.reason);
      REQUIRE(outcome.converged);
    }
    return state;
  }
};

/// Damping ratio of the beam's first mode in a free swing beside that of Rayleigh damping.
void check_damping(const char *what, CantileverBeam beam, double alpha, double beta)
{
  beam.parameters.path.spectral_radius = 1;
  Equilibrium equilibrium(beam.parameters, beam.mesh, MPI_COMM_SELF);
  const auto mode = equilibrium.modes(equilibrium.initial_state(), {.count = 1})[0];
  const double omega = std::sqrt(mode.omega_squared);
  const auto swing = small_swing(equilibrium, equilibrium.initial_state(), mode, 1e-2, 3, 400);
  compare({std::string("damping ratio of ") + what, "Rayleigh damping, (alpha / omega + beta omega) / 2",
           (alpha / omega + beta * omega) / 2, swing.damping_ratio, 5e-3});
}

} // namespace

TEST_CASE("natural frequencies of a slender cantilever")
{
  const CantileverBeam beam(60, 20);
  Equilibrium equilibrium(beam.parameters, beam.mesh, MPI_COMM_SELF);
  const auto modes = equilibrium.modes(equilibrium.initial_state(), {.count = 14});
  const char *source = "Euler and Bernoulli's beam; shear and rotary inertia left out, (h / L)^2 = 3e-4 ... 6e-4";
  const auto check = [&](const char *what, double expected, const Mode &mode, double tolerance) {
    compare({std::string("cantilever 60 x 1.5 x 1 mm: ") + what, source, expected, mode.frequency(), tolerance, "Hz"});
  };
  check("first bending across the height", beam.bending_frequency(0, beam.height), along(modes, beam.mesh, 2), 2e-3);
  check("first bending across the width", beam.bending_frequency(0, beam.width), along(modes, beam.mesh, 1), 2e-3);
  check("second bending across the height", beam.bending_frequency(1, beam.height), along(modes, beam.mesh, 2, 1),
        4e-3);
  check("first longitudinal", beam.axial_frequency(), along(modes, beam.mesh, 0), 1e-3);
}

TEST_CASE("a drooping beam swings about its equilibrium with the frequency of its first mode")
{
  const DroopingBeam drooping;
  Equilibrium equilibrium(drooping.beam.parameters, drooping.beam.mesh, MPI_COMM_SELF);
  const State state = drooping.hanging(equilibrium);
  double lowest = 0;
  for (std::size_t i = 2; i < state.displacement.size(); i += 3)
    lowest = std::min(lowest, state.displacement[i]);
  CHECK(lowest < -0.4 * drooping.beam.length); // far from straight
  const auto mode = equilibrium.modes(state, {.count = 1})[0];
  const auto swing = small_swing(equilibrium, state, mode, 2e-3, 3, 100);
  compare({"beam drooping by half its length: frequency of a small swing", "its own first mode; trapezoidal rule",
           mode.frequency(), swing.frequency, 1e-3, "Hz"});
  compare({"beam drooping by half its length: damping ratio of that swing at spectral radius 1", "no damping", 0,
           swing.damping_ratio, 1e-5, "1", Comparison::Kind::absolute});
}

// Damping alpha M + beta K gives the ratio (alpha / omega + beta omega) / 2. Kelvin and Voigt's law here is beta = tau
// on the shear part of the stiffness only: to first order a bar that is free to contract has the beta
// tau (1 + 2 nu^2) / (1 + nu).
TEST_CASE("damping ratio of a beam by mass damping and by relaxation time")
{
  CantileverBeam beam;
  beam.parameters.materials[0].mass_damping = 4;
  check_damping("a cantilever, mass_damping = 4 / s", beam, 4, 0);

  beam = CantileverBeam();
  beam.parameters.materials[0].relaxation_time = 2e-4;
  check_damping("a cantilever, relaxation_time = 0.2 ms, nu = 0", beam, 0, 2e-4);

  const double nu = 0.3, tau = 5e-6;
  CantileverBeam bar; // held so that it contracts freely and does not bend
  bar.parameters.supports = {{"x0", {"x"}}, {"y0", {"y"}}, {"z0", {"z"}}};
  bar.parameters.materials[0].poisson_ratio = nu, bar.parameters.materials[0].relaxation_time = tau;
  check_damping("a bar, longitudinal, relaxation_time = 5 us, nu = 0.3", bar, 0, tau * (1 + 2 * nu * nu) / (1 + nu));
}
