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

/// What augmented contact has not reached.
std::string shortfall_text(const NewtonSolver::Outcome &outcome)
{
  return outcome.shortfall.empty() ? "" : "; " + outcome.shortfall;
}

std::string cut_text(const StepPlan::Attempt &attempt, const NewtonSolver::Outcome &outcome)
{
  std::ostringstream line;
  line << "cut  dt " << attempt.step.dt << " s" << (attempt.may_move ? ", static: " : ": ") << outcome.reason << ";"
       << residual_text(outcome);
  return line.str();
}

std::string rest_text(double before, double after, const NewtonSolver::Outcome &outcome)
{
  std::ostringstream line;
  line << "rest  p " << 1e3 * before << " kPa -> ";
  if (outcome.converged)
    line << 1e3 * after << " kPa  negative pivots " << outcome.negative_pivots << ";";
  else
    line << "not found: " << outcome.reason << ";";
  line << residual_text(outcome);
  return line.str() + shortfall_text(outcome);
}

std::string step_text(const PathProgress &progress, const StepPlan::Attempt &attempt, double reference_volume,
                      const NewtonSolver::Outcome &outcome)
{
  std::ostringstream line;
  line << "step " << progress.step << "  dt " << attempt.step.dt << " s" << (attempt.step.rates ? "  moving" : "")
       << "  p " << 1e3 * progress.state.pressure << " kPa";
  if (reference_volume > 0)
    line << "  V/V0 " << progress.volume / reference_volume;
  if (attempt.target.what == NewtonSolver::Prescribe::arc_length)
    line << "  load factor " << progress.state.load_factor;
  line << "  negative pivots " << outcome.negative_pivots << ";" << residual_text(outcome) << shortfall_text(outcome);
  return line.str();
}

} // namespace

PathFollower::PathFollower(Equilibrium &equilibrium, const Path &path, MPI_Comm comm)
    : equilibrium_(equilibrium), path_(path), comm_(comm),
      reference_volume_(equilibrium.volume(equilibrium.initial_state())), started_(MPI_Wtime()),
      plan_(path, reference_volume_, equilibrium.feels_rates()), search_(equilibrium, path.critical_tolerance)
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
  point.at_rest = !step.rates;
  return point;
}

/// An outcome that has converged may still be refused, with the reason.
NewtonSolver::Outcome PathFollower::solve(PathProgress &progress, State &state, const StepPlan::Attempt &attempt)
{
  auto outcome = equilibrium_.solve(state, attempt.step, attempt.target);
  progress.iterations += outcome.iterations();
  progress.factorisations += outcome.factorisations;
  if (outcome.converged)
    outcome.reason = equilibrium_.contacts().objection(state);
  outcome.converged = outcome.reason.empty();
  return outcome;
}

bool PathFollower::reject(PathProgress &progress, const StepPlan::Attempt &attempt, PathResult &result) const
{
  ++progress.cuts;
  if (attempt.may_move) {
    progress.regularisation.set_in_motion(path_.rest_every);
    return true;
  }
  progress.setbacks += 2;
  if (!plan_.shorten(progress, attempt))
    result = {PathStatus::diverged, "the step became smaller than allowed; last attempt: " + result.reason};
  else if (progress.setbacks > path_.max_setbacks)
    result = {PathStatus::diverged, "the path has come to a standstill; last attempt: " + result.reason};
  return result.status != PathStatus::diverged;
}

void PathFollower::seek_rest(PathProgress &progress, PathPoint &point, const Log &log)
{
  State state = progress.state;
  const auto outcome = solve(progress, state, plan_.to_rest(progress));
  log(rest_text(progress.state.pressure, state.pressure, outcome));
  progress.regularisation.sought_rest(outcome.converged, path_.rest_every);
  if (!outcome.converged)
    return;
  progress.state = std::move(state);
  point.newton = outcome;
  point.kinetic_share = 0;
  point.at_rest = true;
}

void PathFollower::look_at_stability(PathProgress &progress, PathPoint &point)
{
  point.stability = point.newton.stability();
  if (!point.at_rest)
    return;
  if (path_.critical_points == CriticalPoints::locate || point.newton.convexified) {
    const int spent = equilibrium_.factorisations();
    point.stability = equilibrium_.stability(progress.state);
    progress.factorisations += equilibrium_.factorisations() - spent;
  }
  progress.stability = point.stability;
}

void PathFollower::find_critical_points(const Station &before, NewtonSolver::Prescribe what, PathProgress &progress,
                                        PathPoint &point, const Log &log)
{
  const int spent = equilibrium_.factorisations();
  point.critical_points =
      search_.between(before, {progress.state, progress.volume, progress.stability}, what, progress.step, log);
  const auto bifurcation = std::find_if(point.critical_points.begin(), point.critical_points.end(),
                                        [](const CriticalPoint &p) { return p.kind == CriticalKind::bifurcation; });
  if (path_.branch_amplitude > 0 && bifurcation != point.critical_points.end())
    branch_off(*bifurcation, progress, point, log);
  progress.factorisations += equilibrium_.factorisations() - spent;
}

/// The state before the bifurcation and the one on the branch are as a step of the path.
void PathFollower::branch_off(const CriticalPoint &from, PathProgress &progress, PathPoint &point, const Log &log)
{
  auto branch = search_.branch_off(from, path_.branch_amplitude);
  const std::string objection =
      branch ? equilibrium_.contacts().objection(branch->state) : "no equilibrium is found there";
  if (!objection.empty()) {
    log("branch_amplitude: the path stays on its branch: " + objection);
    return;
  }
  for (std::size_t i = 0; i < branch->state.displacement.size(); ++i)
    branch->state.velocity[i] = (branch->state.displacement[i] - from.state.displacement[i]) / path_.preload_time;
  branch->state.time = progress.state.time;
  progress.state = std::move(branch->state);
  progress.volume = branch->volume;
  progress.stability = point.stability = branch->stability;
  std::ostringstream line;
  line << "goes on along the mode, p " << 1e3 * progress.state.pressure << " kPa, volume " << progress.volume
       << " mm^3, load factor " << progress.state.load_factor;
  log(line.str());
}

bool PathFollower::advance(PathProgress &progress, const Observer &observe, const Log &log, PathResult &result)
{
  const auto attempt = plan_.next(progress);
  const Energies before = equilibrium_.energies(progress.state);
  State state = progress.state;
  const auto outcome = solve(progress, state, attempt);
  result.reason = outcome.reason;
  if (!outcome.converged) {
    log(cut_text(attempt, outcome));
    return reject(progress, attempt, result);
  }
  state.time += attempt.step.dt;
  const Energies after = equilibrium_.energies(state);
  const Station start = {progress.state, progress.volume, progress.stability};
  const bool was_at_rest = !progress.regularisation.moving;
  accept(progress, std::move(state), outcome);
  log(step_text(progress, attempt, reference_volume_, outcome));
  plan_.lengthen(progress, attempt, outcome.factorisations, after.dissipated);
  PathPoint stop = point(progress, attempt.step, before, after, outcome);
  auto &regularisation = progress.regularisation;
  attempt.step.rates ? regularisation.moved() : regularisation.stayed_at_rest();
  if (regularisation.seeks_rest())
    seek_rest(progress, stop, log);
  look_at_stability(progress, stop);
  if (path_.critical_points == CriticalPoints::locate && was_at_rest && !attempt.step.rates)
    find_critical_points(start, attempt.target.what, progress, stop, log);
  progress.pressure_peak = std::max(progress.pressure_peak, progress.state.pressure);
  result.reason = observe(stop);
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
