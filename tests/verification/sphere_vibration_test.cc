// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/equilibrium.h"
#include "tests/support/comparison.h"
#include "tests/support/rubber_sphere.h"
#include <catch2/catch.hpp>
#include <cmath>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double A = 1, B = 1.6, mu = 0.3, density = 1e-9; // mm, MPa, t/mm^3

double outer_radius(double a) { return std::cbrt(a * a * a + B * B * B - A * A * A); }

/// Hollow incompressible neo-Hookean sphere (Green and Zerna), a the inner radius.
double pressure(double a)
{
  const double inner = a / A, outer = outer_radius(a) / B;
  const auto term = [](double l) { return 4 / l + std::pow(l, -4); };
  return mu / 2 * (term(outer) - term(inner));
}

/// omega^2 of its small radial motion at held pressure: the wall moves with r^2 dr/dt the same everywhere, its kinetic
/// energy is 2 pi rho a^4 (da/dt)^2 (1/a - 1/b) (Guo and Solecki 1963), the force at held pressure 4 pi a^2 (p -
/// pressure(a)).
double radial_omega_squared(double a)
{
  const double h = 1e-5, slope = (pressure(a + h) - pressure(a - h)) / (2 * h);
  return slope / (density * a * (1 - a / outer_radius(a)));
}

struct Sphere : RubberSphere {
  Sphere() : RubberSphere(A, B, mu)
  {
    parameters.materials[0].density = density;
    parameters.cavity = Cavity{"inner"};
  }
};

/// How radial a shape is: cosine of its angle to the incompressible radial motion, by mass.
double breathing(const Mode &mode, const Equilibrium &equilibrium, const State &state)
{
  const auto &mesh = equilibrium.discretization().mesh();
  std::vector<double> mass(mesh.nodes.size());
  add_nodal_mass(equilibrium.discretization(), 0, 1, mass);
  double product = 0, shape = 0, radial = 0;
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n) {
    double x[3], r = 0;
    for (int d = 0; d < 3; ++d)
      x[d] = mesh.nodes[n][d] + state.displacement[3 * n + d], r += x[d] * x[d];
    for (int d = 0; d < 3; ++d) {
      const double expected = x[d] / (r * std::sqrt(r)); // r^2 dr = const
      product += mass[n] * mode.shape[3 * n + d] * expected;
      shape += mass[n] * mode.shape[3 * n + d] * mode.shape[3 * n + d], radial += mass[n] * expected * expected;
    }
  }
  return std::abs(product) / std::sqrt(shape * radial);
}

State blown_to(Equilibrium &equilibrium, double inner_radius)
{
  State state = equilibrium.initial_state();
  const double start = equilibrium.volume(state);
  for (double a = A; a < inner_radius;) {
    a = std::min(a + 0.1, inner_radius);
    const auto outcome = equilibrium.solve(
        state, {.dt = 1}, {.what = NewtonSolver::Prescribe::volume, .volume = start * std::pow(a / A, 3)});
    INFO(outcome.reason);
    REQUIRE(outcome.converged);
  }
  return state;
}

} // namespace

// The limit of the pressure is at a = 1.63 mm.
TEST_CASE("radial mode of a thick sphere: stable before its limit pressure, growing after it, gone at held volume")
{
  const Sphere sphere;
  Equilibrium equilibrium(sphere.parameters, sphere.mesh, MPI_COMM_SELF);
  for (const double a : {1.2, 2.2}) {
    const State state = blown_to(equilibrium, a);
    const bool stable = radial_omega_squared(a) > 0;
    CHECK(stable == (a < 1.5));
    const auto modes = equilibrium.modes(state, {.count = 8});
    const auto &radial = *std::max_element(modes.begin(), modes.end(), [&](const Mode &m, const Mode &n) {
      return breathing(m, equilibrium, state) < breathing(n, equilibrium, state);
    });
    CHECK(breathing(radial, equilibrium, state) > 0.999);
    const std::string name = "thick sphere at inner radius " + std::string(stable ? "1.2" : "2.2") + " mm: ";
    const char *source = "radial motion of an incompressible sphere, exact (Guo and Solecki 1963)";
    compare(
        {name + "omega^2 of the radial mode", source, radial_omega_squared(a), radial.omega_squared, 5e-3, "1/s^2"});
    CHECK((stable ? radial.growth_rate() : radial.frequency()) == 0);
    CHECK(std::count_if(modes.begin(), modes.end(), [](const Mode &m) { return m.omega_squared < 0; }) == !stable);
    for (const auto &mode : equilibrium.modes(state, {.count = 8, .volume_held = true})) {
      CHECK(mode.omega_squared > 0);
      CHECK(breathing(mode, equilibrium, state) < 0.01);
    }
  }
}
