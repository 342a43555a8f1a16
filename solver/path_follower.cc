// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/path_follower.h"
#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace ballonet::solver
{

namespace
{

std::string residual_text(const NewtonSolver::Outcome &outcome)
{
  std::ostringstream text;
  text.precision(2);
  for (const double r : outcome.residuals)
    text << ' ' << std::scientific << r;
  return text.str();
}

} // namespace

PathFollower::PathFollower(Equilibrium &equilibrium, const Path &path, MPI_Comm comm)
    : equilibrium_(equilibrium), path_(path), comm_(comm),
      reference_volume_(equilibrium.volume(equilibrium.initial_state())), started_(MPI_Wtime())
{
  if (path.control == Control::arc_length)
    throw std::invalid_argument("path.control = \"arc_length\" is not available in this version; "
                                "use volume, pressure, ramp, load or release");
  if (drives_cavity(path.control) && !equilibrium.has_cavity())
    throw std::invalid_argument("path.control needs a cavity; without one use control = \"load\" or \"release\"");
  if (path.control == Control::release && !path.inertia)
    throw std::invalid_argument("path.control = \"release\" is motion with mass; it needs path.inertia = true");
}

PathProgress PathFollower::start() const
{
  PathProgress progress;
  progress.state = equilibrium_.initial_state();
  progress.volume = reference_volume_;
  progress.stretch = 1. / (path_.control == Control::load ? path_.load_steps : path_.preload_steps);
  progress.dt = path_.step_initial;
  if (path_.control == Control::release) {
    progress.load_factor = 1; // no preload
    progress.state.pressure = path_.initial_pressure;
    equilibrium_.release(progress.state);
  }
  return progress;
}

/// Wall time since the start, the same on every rank.
double PathFollower::seconds() const
{
  double elapsed = MPI_Wtime() - started_;
  MPI_Bcast(&elapsed, 1, MPI_DOUBLE, 0, comm_);
  return elapsed;
}

PathFollower::Attempt PathFollower::next(const PathProgress &progress) const
{
  Attempt attempt;
  if (preloading(progress)) {
    attempt.stretch = std::min(progress.stretch, 1 - progress.load_factor);
    const bool last = 1 - progress.load_factor - attempt.stretch < 1e-9;
    attempt.step = {attempt.stretch * path_.preload_time, last ? 1 : progress.load_factor + attempt.stretch, false};
    attempt.target.pressure = attempt.step.load_factor * path_.initial_pressure;
  } else if (path_.control == Control::release) {
    attempt.step = {std::min(progress.dt, path_.duration - progress.state.time), 1, true};
    attempt.target.pressure = path_.initial_pressure;
  } else {
    attempt.step = {progress.dt, 1, path_.inertia && path_.control != Control::pressure};
    attempt.target.volume_prescribed = path_.control == Control::volume;
    attempt.target.volume = progress.volume + path_.volume_rate * reference_volume_ * progress.dt;
    attempt.target.pressure = progress.state.pressure + path_.pressure_rate * progress.dt;
  }
  return attempt;
}

void PathFollower::adapt(PathProgress &progress, int factorisations) const
{
  const double factor = factorisations <= 5 ? 1.5 : factorisations > 10 ? 0.6 : 1;
  if (preloading(progress))
    progress.stretch *= factor;
  else
    progress.dt = std::min(progress.dt * factor, path_.step_max);
}

bool PathFollower::advance(PathProgress &progress, const Observer &observe, const Log &log, PathResult &result)
{
  const auto attempt = next(progress);
  const Energies before = equilibrium_.energies(progress.state);
  State state = progress.state;
  const auto outcome = equilibrium_.solve(state, attempt.step, attempt.target);
  progress.iterations += outcome.iterations();
  progress.factorisations += outcome.factorisations;
  const std::string objection = outcome.converged ? equilibrium_.objection(state) : outcome.reason;
  std::ostringstream line;
  if (!objection.empty()) {
    ++progress.cuts;
    progress.setbacks += 2;
    (preloading(progress) ? progress.stretch : progress.dt) *= 0.4;
    line << "cut  dt " << attempt.step.dt << " s: " << objection << ";" << residual_text(outcome);
    log(line.str());
    result.reason = objection;
    return false;
  }
  const bool was_preload = preloading(progress);
  state.time += attempt.step.dt;
  progress.state = std::move(state);
  progress.load_factor = attempt.step.load_factor;
  progress.volume = outcome.volume;
  progress.pressure_peak = std::max(progress.pressure_peak, progress.state.pressure);
  ++progress.step;
  progress.setbacks = std::max(0, progress.setbacks - 1);

  PathPoint point{progress, attempt.step.dt, reference_volume_, outcome};
  const Energies after = equilibrium_.energies(progress.state);
  const double moved = std::abs(after.stored - before.stored) + after.dissipated +
                       (attempt.step.inertia ? std::abs(after.kinetic - before.kinetic) : 0);
  point.dissipated_share = moved > 0 ? after.dissipated / moved : 0;
  point.kinetic_share = attempt.step.inertia && after.stored > 0 ? after.kinetic / after.stored : 0;
  line << "step " << progress.step << "  dt " << attempt.step.dt << " s  p " << 1e3 * progress.state.pressure << " kPa";
  if (reference_volume_ > 0)
    line << "  V/V0 " << progress.volume / reference_volume_;
  line << "  negative pivots " << outcome.negative_pivots << ";" << residual_text(outcome);
  log(line.str());
  if (was_preload && !preloading(progress))
    progress.dt = path_.step_initial;
  else
    adapt(progress, outcome.factorisations);
  result.reason = observe(point);
  return true;
}

std::string PathFollower::end_reached(const PathProgress &progress) const
{
  if (preloading(progress))
    return {};
  if (path_.control == Control::load)
    return "the full load is reached";
  if (path_.control == Control::release)
    return progress.state.time >= path_.duration * (1 - 1e-12) ? "path.duration is reached" : "";
  if (progress.volume >= path_.volume_max * reference_volume_)
    return "path.volume_max is reached";
  if (progress.pressure_peak >= path_.pressure_max)
    return "path.pressure_max is reached";
  return {};
}

PathResult PathFollower::run(PathProgress &progress, const Observer &observe, const Log &log)
{
  PathResult result;
  while (true) {
    if (result.reason = end_reached(progress); !result.reason.empty())
      return result;
    if (progress.step >= path_.max_steps)
      return {PathStatus::step_limit, "path.max_steps is reached"};
    if (seconds() > path_.time_limit)
      return {PathStatus::time_limit, "path.time_limit is reached"};
    if (advance(progress, observe, log, result)) {
      if (!result.reason.empty())
        return result; // the observer has seen enough
    } else if (preloading(progress) ? progress.stretch < 1e-6 : progress.dt < path_.step_min) {
      return {PathStatus::diverged, "the step became smaller than allowed; last attempt: " + result.reason};
    } else if (progress.setbacks > path_.max_setbacks) {
      return {PathStatus::diverged, "the path has come to a standstill; last attempt: " + result.reason};
    }
  }
}

} // namespace ballonet::solver
