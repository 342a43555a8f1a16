// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/inertia_work.h"

namespace ballonet::solver
{

StepRule backward_euler() { return {.b_start = 0, .b_end = 1, .g_start = 0, .g_end = 1, .alpha = 0}; }

StepRule generalised_alpha(double spectral_radius)
{
  const double alpha = (spectral_radius - 1) / (spectral_radius + 1);
  const double gamma = 0.5 - alpha, beta = (1 - alpha) * (1 - alpha) / 4;
  return {.b_start = 0.5 - beta, .b_end = beta, .g_start = 1 - gamma, .g_end = gamma, .alpha = alpha};
}

StepRule step_rule(const Path &path)
{
  const bool second_order = path.integrator == Integrator::generalised_alpha ||
                            (path.integrator == Integrator::by_control && path.control == Control::release);
  return second_order ? generalised_alpha(path.spectral_radius) : backward_euler();
}

InertiaWork::InertiaWork(std::vector<double> mass, std::vector<double> damping, const StepRule &rule)
    : mass_(std::move(mass)), damping_(std::move(damping)), rule_(rule)
{
  for (Node node = 0; node < mass_.size(); ++node)
    if (mass_[node] != 0)
      nodes_.push_back(node);
}

void InertiaWork::begin_step(const State &start, const Step &step)
{
  start_ = start;
  step_ = step;
}

/// At displacement `u` of the i-th of all displacements.
double InertiaWork::acceleration(std::size_t i, double u) const
{
  if (!step_.inertia)
    return 0;
  const double h = step_.dt;
  const double free = start_.displacement[i] + h * start_.velocity[i] + h * h * rule_.b_start * start_.acceleration[i];
  return (u - free) / (rule_.b_end * h * h);
}

double InertiaWork::velocity(std::size_t i, double u) const
{
  if (!step_.inertia)
    return (u - start_.displacement[i]) / step_.dt;
  return start_.velocity[i] + step_.dt * (rule_.g_start * start_.acceleration[i] + rule_.g_end * acceleration(i, u));
}

/// d force / d displacement of a node.
double InertiaWork::stiffness(Node node) const
{
  const double h = step_.dt;
  return (mass_[node] * (1 - rule_.alpha) / h + damping_[node] * rule_.g_end) / (rule_.b_end * h);
}

double InertiaWork::energy(const State &state) const
{
  if (!step_.inertia)
    return 0;
  const double h = step_.dt;
  double sum = 0;
  for (const auto node : nodes_)
    for (std::size_t i = 3 * node; i < 3 * node + 3; ++i) {
      const double w = rule_.b_end * h * h * acceleration(i, state.displacement[i]);
      const double force =
          mass_[node] * rule_.alpha * start_.acceleration[i] + damping_[node] * velocity(i, state.displacement[i] - w);
      sum += stiffness(node) * w * w / 2 + force * w;
    }
  return sum;
}

void InertiaWork::residual(const State &state, Assembly &out) const
{
  if (!step_.inertia)
    return;
  for (const auto node : nodes_) {
    Vector3 r;
    for (int d = 0; d < 3; ++d) {
      const std::size_t i = 3 * node + d;
      const double u = state.displacement[i];
      r[d] = mass_[node] * ((1 - rule_.alpha) * acceleration(i, u) + rule_.alpha * start_.acceleration[i]) +
             damping_[node] * velocity(i, u);
    }
    out.add_residual({&node, 1}, r);
  }
}

void InertiaWork::tangent(const State &, Assembly &out) const
{
  if (!step_.inertia)
    return;
  for (const auto node : nodes_) {
    const double k = stiffness(node);
    const std::array<double, 9> K = {k, 0, 0, 0, k, 0, 0, 0, k};
    out.add_tangent({&node, 1}, K);
  }
}

void InertiaWork::end_step(State &end) const
{
  for (std::size_t i = 0; i < end.displacement.size(); ++i) {
    end.velocity[i] = velocity(i, end.displacement[i]);
    end.acceleration[i] = acceleration(i, end.displacement[i]);
  }
}

double InertiaWork::kinetic_energy(const State &state) const
{
  double sum = 0;
  for (const auto node : nodes_)
    for (int d = 0; d < 3; ++d)
      sum += mass_[node] * state.velocity[3 * node + d] * state.velocity[3 * node + d];
  return sum / 2;
}

double InertiaWork::dissipated(const State &state) const
{
  if (!step_.inertia)
    return 0;
  double sum = 0;
  for (const auto node : nodes_)
    for (std::size_t i = 3 * node; i < 3 * node + 3; ++i)
      sum += damping_[node] * velocity(i, state.displacement[i]) * (state.displacement[i] - start_.displacement[i]);
  return sum;
}

} // namespace ballonet::solver
