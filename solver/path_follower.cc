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

std::string cut_text(const StepPlan::Attempt &attempt, const std::string &reason, const NewtonSolver::Outcome &outcome)
{
  std::ostringstream line;
  line << "cut  dt " << attempt.step.dt << " s: " << reason << ";" << residual_text(outcome);
  return line.str();
}

std::string step_text(const PathProgress &progress, const StepPlan::Attempt &attempt, double reference_volume,
                      const NewtonSolver::Outcome &outcome)
{
  std::ostringstream line;
  line << "step " << progress.step << "  dt " << attempt.step.dt << " s  p " << 1e3 * progress.state.pressure << " kPa";
  if (reference_volume > 0)
    line << "  V/V0 " << progress.volume / reference_volume;
  if (attempt.target.what == NewtonSolver::Prescribe::arc_length)
    line << "  load factor " << progress.state.load_factor;
  line << "  negative pivots " << outcome.negative_pivots << ";" << residual_text(outcome);
  return line.str();
}

} // namespace

PathFollower::PathFollower(Equilibrium &equilibrium, const Path &path, MPI_Comm comm)
    : equilibrium_(equilibrium), path_(path), comm_(comm),
      reference_volume_(equilibrium.volume(equilibrium.initial_state())), started_(MPI_Wtime()),
      plan_(path, reference_volume_)
{
}

PathProgress PathFollower::start() const
{
  PathProgress progress;
  progress.state = equilibrium_.initial_state();
  plan_.start(progress);
  if (path_.control == Control::release)
    equilibrium_.release(progress.state);
  return progress;
}

/// Wall time since the start, the same on every rank.
double PathFollower::seconds() const
{
  double elapsed = MPI_Wtime() - started_;
  MPI_Bcast(&elapsed, 1, MPI_DOUBLE, 0, comm_);
  return elapsed;
}

void PathFollower::accept(PathProgress &progress, State &&end, const NewtonSolver::Outcome &outcome) const
{
  progress.state = std::move(end);
  progress.volume = outcome.volume;
  progress.pressure_peak = std::max(progress.pressure_peak, progress.state.pressure);
  ++progress.step;
  progress.setbacks = std::max(0, progress.setbacks - 1);
}

PathPoint PathFollower::point(const PathProgress &progress, const Step &step, const Energies &before,
                              const Energies &after, const NewtonSolver::Outcome &outcome) const
{
  PathPoint point{progress, step.dt, reference_volume_, outcome};
  const double moved = std::abs(after.stored - before.stored) + after.dissipated +
                       (step.inertia ? std::abs(after.kinetic - before.kinetic) : 0);
  point.dissipated_share = moved > 0 ? after.dissipated / moved : 0;
  point.kinetic_share = step.inertia && after.stored > 0 ? after.kinetic / after.stored : 0;
  return point;
}

bool PathFollower::advance(PathProgress &progress, const Observer &observe, const Log &log, PathResult &result)
{
  const auto attempt = plan_.next(progress);
  const Energies before = equilibrium_.energies(progress.state);
  State state = progress.state;
  const auto outcome = equilibrium_.solve(state, attempt.step, attempt.target);
  progress.iterations += outcome.iterations();
  progress.factorisations += outcome.factorisations;
  result.reason = outcome.converged ? equilibrium_.objection(state) : outcome.reason;
  if (!result.reason.empty()) {
    log(cut_text(attempt, result.reason, outcome));
    ++progress.cuts;
    progress.setbacks += 2;
    if (!plan_.shorten(progress, attempt))
      result = {PathStatus::diverged, "the step became smaller than allowed; last attempt: " + result.reason};
    else if (progress.setbacks > path_.max_setbacks)
      result = {PathStatus::diverged, "the path has come to a standstill; last attempt: " + result.reason};
    return result.status != PathStatus::diverged;
  }
  state.time += attempt.step.dt;
  const Energies after = equilibrium_.energies(state);
  accept(progress, std::move(state), outcome);
  log(step_text(progress, attempt, reference_volume_, outcome));
  plan_.lengthen(progress, attempt, outcome.factorisations, after.dissipated);
  result.reason = observe(point(progress, attempt.step, before, after, outcome));
  return result.reason.empty();
}

PathResult PathFollower::run(PathProgress &progress, const Observer &observe, const Log &log)
{
  PathResult result;
  do {
    if (const auto reason = plan_.end_reached(progress); !reason.empty())
      return {PathStatus::ended, reason};
    if (progress.step >= path_.max_steps)
      return {PathStatus::step_limit, "path.max_steps is reached"};
    if (seconds() > path_.time_limit)
      return {PathStatus::time_limit, "path.time_limit is reached"};
  } while (advance(progress, observe, log, result));
  return result;
}

} // namespace ballonet::solver
