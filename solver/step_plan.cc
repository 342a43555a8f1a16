// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/step_plan.h"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace ballonet::solver
{

using Prescribe = NewtonSolver::Prescribe;

namespace
{

constexpr int static_patience = 10; // iterations where a step in motion can take over

/// Whether the path is driven by the load factor itself.
bool drives_load(Control control, bool has_cavity)
{
  return control == Control::load || (control == Control::arc_length && !has_cavity);
}

} // namespace

StepPlan::StepPlan(const Path &path, double reference_volume, bool feels_rates)
    : path_(path), reference_volume_(reference_volume), feels_rates_(feels_rates)
{
  if (drives_cavity(path.control) && !has_cavity())
    throw std::invalid_argument(
        "path.control needs a cavity; without one use control = \"load\", \"arc_length\" or \"release\"");
  if (path.control == Control::release && !path.inertia)
    throw std::invalid_argument("path.control = \"release\" is motion with mass; it needs path.inertia = true");
}

/// A body without a cavity is driven by its load factor itself, along an arc from the second step on.
bool StepPlan::preloading(const PathProgress &progress) const
{
  const bool on_arc = progress.arc_length > 0;
  return progress.state.load_factor < 1 && !on_arc;
}

void StepPlan::start(PathProgress &progress) const
{
  progress.volume = reference_volume_;
  progress.stretch = 1. / (drives_load(path_.control, has_cavity()) ? path_.load_steps : path_.preload_steps);
  progress.dt = path_.step_initial;
  if (path_.control == Control::release) {
    progress.state.load_factor = 1; // no preload
    progress.state.pressure = path_.initial_pressure;
  }
}

StepPlan::Attempt StepPlan::preload(const PathProgress &progress) const
{
  const double from = progress.state.load_factor;
  const double to = from + progress.stretch > 1 - 1e-9 ? 1 : from + progress.stretch;
  return {{(to - from) * path_.preload_time, to, false, false},
          {.parameter = to * path_.initial_pressure},
          &PathProgress::stretch};
}

StepPlan::Attempt StepPlan::along_arc(const PathProgress &progress) const
{
  return {{path_.preload_time, progress.state.load_factor, false, false},
          {.what = Prescribe::arc_length, .arc_length = progress.arc_length},
          &PathProgress::arc_length};
}

StepPlan::Attempt StepPlan::in_time(const PathProgress &progress) const
{
  Attempt attempt = {{progress.dt, 1, path_.inertia}, {}, &PathProgress::dt};
  auto &[step, target, length, may_move] = attempt;
  target.parameter = progress.state.pressure + path_.pressure_rate * progress.dt;
  if (path_.control == Control::volume) {
    target.what = Prescribe::volume;
    target.volume = progress.volume + path_.volume_rate * reference_volume_ * progress.dt;
  } else if (path_.control == Control::release) {
    target.parameter = path_.initial_pressure;
    step.dt = std::min(progress.dt, path_.duration - progress.state.time);
  } else if (path_.control != Control::ramp) {
    step.inertia = false;
  }
  if (path_.control == Control::volume || path_.control == Control::pressure) {
    const bool seeks_rest = path_.rates == Rates::where_needed || !feels_rates_;
    step.rates = !seeks_rest || progress.regularisation.moving;
    step.inertia = step.inertia && step.rates;
    may_move = feels_rates_ && !step.rates;
    target.patience = may_move ? static_patience : 0;
  }
  return attempt;
}

StepPlan::Attempt StepPlan::to_rest(const PathProgress &progress) const
{
  Attempt attempt = {{infinity, progress.state.load_factor, false, false}, {.parameter = progress.state.pressure}, {}};
  if (path_.control == Control::volume) {
    attempt.target.what = Prescribe::volume;
    attempt.target.volume = progress.volume;
  }
  attempt.target.patience = static_patience;
  return attempt;
}

StepPlan::Attempt StepPlan::next(const PathProgress &progress) const
{
  if (preloading(progress))
    return preload(progress);
  return progress.arc_length > 0 ? along_arc(progress) : in_time(progress);
}

/// How much the next step may grow for the sake of what moves faster and faster. Viscous forces of a snap grow from
/// step to step, and the rate of dissipation with the square of them: it may not grow by more than half in a step of
/// the same length.
double StepPlan::snap_limit(PathProgress &progress, const Attempt &taken, double dissipated) const
{
  if (taken.length != &PathProgress::dt)
    return infinity;
  const double before = std::exchange(progress.dissipation, dissipated / taken.step.dt);
  return before > 0 && progress.dissipation > 0 ? std::max(0.4, 1.5 * before / progress.dissipation) : infinity;
}

/// The first step along an arc is as long as the step under prescribed load before it.
void StepPlan::lengthen(PathProgress &progress, const Attempt &taken, int factorisations, double dissipated) const
{
  const double by_cost = factorisations <= 5 ? 1.5 : factorisations > 10 ? 0.6 : 1;
  const double factor = std::min(by_cost, snap_limit(progress, taken, dissipated));
  double &length = progress.*taken.length;
  progress.ceiling *= 1.1;
  length = std::min(length * factor, std::max(length, progress.ceiling));
  progress.dt = std::min(progress.dt, path_.step_max);
  const bool drives = !has_cavity() || taken.length == &PathProgress::dt;
  if (path_.control == Control::arc_length && drives && progress.arc_length == 0) {
    const auto &v = progress.state.velocity;
    progress.arc_length = taken.step.dt * std::sqrt(std::inner_product(v.begin(), v.end(), v.begin(), 0.));
  }
  const double n_nodes = progress.state.displacement.size() / 3;
  progress.arc_length = std::min(progress.arc_length, path_.arc_step_max * std::sqrt(n_nodes));
}

bool StepPlan::shorten(PathProgress &progress, const Attempt &rejected) const
{
  double &length = progress.*rejected.length;
  progress.ceiling = 0.8 * length;
  length *= 0.4;
  return length >= (rejected.length == &PathProgress::dt ? path_.step_min : 1e-6);
}

std::string StepPlan::end_reached(const PathProgress &progress) const
{
  if (progress.state.load_factor < 1)
    return {};
  if (drives_load(path_.control, has_cavity()))
    return "the full load is reached";
  if (path_.control == Control::release)
    return progress.state.time >= path_.duration * (1 - 1e-12) ? "path.duration is reached" : "";
  if (progress.volume >= path_.volume_max * reference_volume_)
    return "path.volume_max is reached";
  if (progress.pressure_peak >= path_.pressure_max)
    return "path.pressure_max is reached";
  return {};
}

} // namespace ballonet::solver
