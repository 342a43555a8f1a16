// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/verification/small_swing.h"
#include <catch2/catch.hpp>
#include <cmath>

namespace ballonet::tests
{

using namespace solver;

namespace
{

struct Peak {
  double time, height;
};

/// The largest value of the parabola through three values one step apart, the middle one at `time`.
Peak peak(double before, double at, double after, double time, double dt)
{
  const double slope = (after - before) / 2, bend = after - 2 * at + before;
  return {time - dt * slope / bend, at - slope * slope / (2 * bend)};
}

} // namespace

Swing small_swing(Equilibrium &equilibrium, const State &state, const Mode &mode, double amplitude, int periods,
                  int steps)
{
  const double dt = 1 / (mode.frequency() * steps);
  const auto largest = std::max_element(mode.shape.begin(), mode.shape.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); }) -
                       mode.shape.begin();
  State now = state;
  for (std::size_t i = 0; i < mode.shape.size(); ++i) {
    now.displacement[i] += amplitude * mode.shape[i];
    now.velocity[i] = 0;
    now.acceleration[i] = -mode.omega_squared * amplitude * mode.shape[i];
  }
  std::vector<double> share = {1};
  std::vector<Peak> peaks;
  for (int k = 1; k <= periods * steps + steps / 4; ++k) {
    const auto outcome = equilibrium.solve(now, {.dt = dt, .inertia = true}, {.parameter = state.pressure});
    INFO(outcome.reason);
    REQUIRE(outcome.converged);
    share.push_back((now.displacement[largest] - state.displacement[largest]) / (amplitude * mode.shape[largest]));
    if (k > 1 && share[k - 1] > share[k] && share[k - 1] > share[k - 2])
      peaks.push_back(peak(share[k - 2], share[k - 1], share[k], (k - 1) * dt, dt));
  }
  REQUIRE(peaks.size() >= 2);
  const double swings = peaks.size() - 1;
  const double period = (peaks.back().time - peaks.front().time) / swings;
  const double decrement = std::log(peaks.front().height / peaks.back().height) / swings;
  return {1 / period, decrement / std::hypot(2 * M_PI, decrement)};
}

} // namespace ballonet::tests
