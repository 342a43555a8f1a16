// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/inertia_work.h"
#include "tests/support/derivative_check.h"

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

State moving(std::size_t size)
{
  State state;
  state.displacement = random_field(size, 1, 1);
  state.velocity = random_field(size, 3, 2);
  state.acceleration = random_field(size, 20, 3);
  return state;
}

/// One mass m on a linear spring k, damped by d = mass_damping m: the inertia's own steps, solved exactly.
struct Oscillator {
  double mass = 2, stiffness = 50, mass_damping = 0;
  State state;

  /// Lets it go at rest, 1 mm away from equilibrium.
  Oscillator() { state.displacement = {1, 0, 0}, state.velocity = {0, 0, 0}, state.acceleration = {-25, 0, 0}; }

  void step(InertiaWork &inertia, double dt)
  {
    inertia.begin_step(state, {.dt = dt, .inertia = true});
    const auto linear = assembled(inertia, state);
    const double residual = linear.residual[0] + stiffness * state.displacement[0];
    state.displacement[0] -= residual / (linear.tangent[0] + stiffness);
    inertia.end_step(state);
  }

  InertiaWork inertia(const StepRule &rule) const { return InertiaWork({mass}, {mass_damping * mass}, rule); }
  double energy(const InertiaWork &inertia) const
  {
    return inertia.kinetic_energy(state) + stiffness * state.displacement[0] * state.displacement[0] / 2;
  }
  /// Damped free oscillation in closed form.
  double exact(double time) const
  {
    const double c = mass_damping / 2, omega = std::sqrt(stiffness / mass - c * c);
    return std::exp(-c * time) * (std::cos(omega * time) + c / omega * std::sin(omega * time));
  }
};

/// Error of the displacement after a time, in `steps` steps; with `uneven` every step is half as long in the second
/// half of the time.
double error(const StepRule &rule, int steps, double mass_damping, bool uneven)
{
  constexpr double time = 1.7;
  Oscillator oscillator;
  oscillator.mass_damping = mass_damping;
  auto inertia = oscillator.inertia(rule);
  const double dt = time / steps;
  for (int i = 0; i < steps; ++i)
    if (uneven && 2 * i >= steps)
      oscillator.step(inertia, dt / 2), oscillator.step(inertia, dt / 2);
    else
      oscillator.step(inertia, dt);
  return std::abs(oscillator.state.displacement[0] - oscillator.exact(time));
}

void check_order(const StepRule &rule, double order, double mass_damping, bool uneven = false)
{
  const double coarse = error(rule, 400, mass_damping, uneven), fine = error(rule, 800, mass_damping, uneven);
  INFO("errors " << coarse << " and " << fine << ", spectral parameter " << rule.alpha);
  CHECK(std::log2(coarse / fine) == Approx(order).margin(0.1));
}

} // namespace

TEST_CASE("inertia: backward Euler is the potential m |u - u_n - h v_n|^2 / (2 h^2) and vanishes for free flight")
{
  const std::vector<double> mass = {2, 0.5, 1};
  InertiaWork work(mass, {0, 0, 0}, backward_euler());
  const State start = moving(9);
  work.begin_step(start, {.dt = 0.1, .inertia = true});
  const State flown = moved(start, start.velocity, 0.1);
  CHECK(norm(residual(work, flown)) < 1e-12);
  const auto braking = random_field(9, 1, 4);
  double expected = 0;
  for (int i = 0; i < 9; ++i)
    expected += mass[i / 3] * braking[i] * braking[i] / (2 * 0.1 * 0.1);
  CHECK(work.energy(moved(flown, braking, 1)) == Approx(expected));
  CHECK(residual(work, start)[0] == Approx(-2 * start.velocity[0] / 0.1)); // m (v - v_n) / dt with v = 0

  double kinetic = 0;
  for (int i = 0; i < 9; ++i)
    kinetic += mass[i / 3] * start.velocity[i] * start.velocity[i] / 2;
  CHECK(work.kinetic_energy(start) == Approx(kinetic));
}

TEST_CASE("inertia: forces are derivatives of the incremental potential for every rule, with damping")
{
  for (const auto &rule : {backward_euler(), generalised_alpha(1), generalised_alpha(0.8), generalised_alpha(0)}) {
    InertiaWork work({2, 0.5, 1}, {4, 1, 0}, rule);
    const State start = moving(9);
    work.begin_step(start, {.dt = 0.1, .inertia = true});
    const State braked = moved(start, random_field(9, 1, 3), 1);
    check_residual(work, braked);
    check_tangent(work, braked, [&](const State &at) { return residual(work, at); });
  }
}

TEST_CASE("inertia: the ends of steps obey the rule, and constant acceleration is followed exactly")
{
  InertiaWork work({1}, {0}, generalised_alpha(0.6));
  State state = moving(3);
  const State start = state;
  const double h[2] = {0.1, 0.03};
  for (const double dt : h) {
    work.begin_step(state, {.dt = dt, .inertia = true});
    for (int i = 0; i < 3; ++i)
      state.displacement[i] += dt * state.velocity[i] + dt * dt / 2 * start.acceleration[i];
    work.end_step(state);
  }
  for (int i = 0; i < 3; ++i) {
    CHECK(state.acceleration[i] == Approx(start.acceleration[i]));
    CHECK(state.velocity[i] == Approx(start.velocity[i] + (h[0] + h[1]) * start.acceleration[i]));
  }
  CHECK(residual(work, state)[1] == Approx(start.acceleration[1])); // m a
}

TEST_CASE("inertia: switched off it does nothing, and the velocity is the mean one of the step")
{
  InertiaWork work({2, 0.5, 1}, {4, 1, 0}, generalised_alpha(0.8));
  const State start = moving(9);
  State end = moved(start, random_field(9, 1, 3), 1);
  work.begin_step(start, {.dt = 0.1});
  CHECK(norm(residual(work, end)) == 0);
  CHECK(work.energy(end) == 0);
  CHECK(work.dissipated(end) == 0);
  work.end_step(end);
  CHECK(end.velocity[4] == Approx((end.displacement[4] - start.displacement[4]) / 0.1));
  CHECK(norm(end.acceleration) == 0);
}

TEST_CASE("inertia: order of convergence on a mass and a spring, one for backward Euler, two for generalised alpha")
{
  for (const double damping : {0., 1.5}) {
    check_order(backward_euler(), 1, damping);
    for (const double radius : {1., 0.8, 0.5, 0.})
      check_order(generalised_alpha(radius), 2, damping);
    check_order(generalised_alpha(0.5), 2, damping, true); // a change of the step
  }
}

TEST_CASE("inertia: the trapezoidal rule conserves energy, the others lose it")
{
  const auto lost = [](const StepRule &rule) {
    Oscillator oscillator;
    auto inertia = oscillator.inertia(rule);
    const double start = oscillator.energy(inertia);
    for (int i = 0; i < 1000; ++i)
      oscillator.step(inertia, 0.02);
    return 1 - oscillator.energy(inertia) / start;
  };
  CHECK(std::abs(lost(generalised_alpha(1))) < 1e-11);
  const double lost_08 = lost(generalised_alpha(0.8)), lost_0 = lost(generalised_alpha(0));
  CHECK(lost_08 > 1e-4);
  CHECK(lost_0 > 2 * lost_08);
  CHECK(lost(backward_euler()) > 0.9);
}

TEST_CASE("inertia: a step leaves the spectral radius of a very stiff spring's motion")
{
  for (const double radius : {1., 0.8, 0.3}) {
    Oscillator oscillator;
    oscillator.stiffness = 1e12;
    oscillator.state.acceleration[0] = -5e11;
    auto inertia = oscillator.inertia(generalised_alpha(radius));
    const auto amplitude = [&] {
      const auto &s = oscillator.state;
      return std::hypot(s.acceleration[0], s.velocity[0] / 0.1, s.displacement[0] / 0.01);
    };
    for (int i = 0; i < 10; ++i)
      oscillator.step(inertia, 0.1);
    const double before = amplitude();
    for (int i = 0; i < 40; ++i)
      oscillator.step(inertia, 0.1);
    INFO("spectral radius " << radius);
    CHECK(std::pow(amplitude() / before, 1. / 40) == Approx(radius).epsilon(0.1));
  }
}

TEST_CASE("inertia: what the damping takes is what the oscillator loses")
{
  Oscillator oscillator;
  oscillator.mass_damping = 1.5;
  auto inertia = oscillator.inertia(generalised_alpha(1));
  const double start = oscillator.energy(inertia);
  double taken = 0;
  for (int i = 0; i < 2000; ++i) {
    oscillator.step(inertia, 1e-3);
    taken += inertia.dissipated(oscillator.state);
  }
  CHECK(taken == Approx(start - oscillator.energy(inertia)).epsilon(5e-3));
}
