// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/newton_iteration.h"
#include <algorithm>
#include <cmath>

namespace ballonet::solver
{

namespace
{

constexpr double held_tolerance = 1e-10; // mm

}

NewtonSolver::Implementation::Implementation(LinearSystem &system, std::vector<VirtualWork *> works,
                                             std::vector<VirtualWork *> loads, CavityWork *cavity, MPI_Comm comm,
                                             const Newton &parameters)
    : SnesIteration(system, comm, parameters.max_iterations), system(system), works(std::move(works)),
      loads(std::move(loads)), cavity(cavity), comm(comm), parameters(parameters)
{
  for (Vec *vector : {&u, &residual, &force, &free_force, &response, &start, &direction})
    *vector = system.create_vector();
}

NewtonSolver::Implementation::~Implementation()
{
  for (Vec *vector : {&u, &residual, &force, &free_force, &response, &start, &direction})
    VecDestroy(vector);
}

/// From the displacement u of the state.
NewtonSolver::Outcome NewtonSolver::Implementation::run()
{
  watch = {};
  begin_iteration(static_cast<int>(outcome.residuals.size()));
  const int factorisations = system.factorisations();
  iterate(u, parameter(*state));
  outcome.factorisations += system.factorisations() - factorisations;
  if (!outcome.converged && outcome.reason.empty())
    outcome.reason = "the linear system could not be solved";
  return outcome;
}

void NewtonSolver::Implementation::assemble_residual()
{
  system.assemble(
      [&](Assembly &assembly) {
        for (const auto *work : works)
          work->residual(*state, assembly);
      },
      residual);
}

/// F = -dR/dp. Loads are linear in the load factor.
void NewtonSolver::Implementation::assemble_force()
{
  if (cavity) {
    system.assemble([&](Assembly &assembly) { cavity->volume_gradient(*state, assembly); }, force);
  } else {
    State full = *state;
    full.load_factor = 1;
    system.assemble(
        [&](Assembly &assembly) {
          for (const auto *load : loads)
            load->residual(full, assembly);
        },
        force);
    petsc(VecScale(force, -1));
  }
  petsc(VecCopy(force, free_force));
  system.clear_held(free_force);
}

/// How far the state is from what is prescribed; `x` holds its displacement.
double NewtonSolver::Implementation::miss(Vec x)
{
  if (target.what == Prescribe::volume)
    return outcome.volume - target.volume;
  if (target.what == Prescribe::parameter)
    return parameter(*state) - target.parameter;
  split(x, u);
  petsc(VecAXPY(u, -1, start));
  return dot(direction, u) - target.arc_length;
}

/// Residual of the current state; norms of its free part, of the misses of held values and of the force scale.
void NewtonSolver::Implementation::evaluate(Vec x, Vec out)
{
  assemble_residual();
  const double reaction = system.clear_held(residual);
  petsc(VecNorm(residual, NORM_2, &residual_norm));
  held_miss = system.hold(*state, residual);
  force_scale = std::max(parameters.force_floor, reaction);
  if (has_unknown_load()) {
    assemble_force();
    double norm;
    petsc(VecNorm(free_force, NORM_2, &norm));
    force_scale = std::max(force_scale, std::abs(parameter(*state)) * norm);
  }
  outcome.volume = cavity ? sum(cavity->volume(*state)) : 0;
  parameter_miss = miss(x);
  combine(residual, parameter_miss, out);
}

/// Whether the matrix still has the pattern of a factor of this step.
bool NewtonSolver::Implementation::has_factor() const { return outcome.residuals.size() > 1 && !new_couplings; }

/// Close to the solution the last factor is nearly the present one; it serves as long as that shows.
bool NewtonSolver::Implementation::last_factor_serves() const
{
  const auto &r = outcome.residuals;
  return has_factor() && held_miss < held_tolerance && r.back() < parameters.reuse_below &&
         r.back() < 0.1 * r[r.size() - 2];
}

bool NewtonSolver::Implementation::linearise()
{
  if (last_factor_serves()) {
    system.keep_factor();
  } else if (has_factor() && !convex && outcome.residuals.back() < parameters.krylov_below) {
    system.precondition(works, *state);
  } else {
    couple();
    if (!factorise()) {
      outcome.reason = "the factorisation of the tangent failed";
      return false;
    }
  }
  if (has_unknown_load()) {
    system.solve(free_force, response);
    outcome.compliance = dot(free_force, response);
  }
  if (target.what == Prescribe::arc_length && target.direction.empty() && outcome.residuals.size() == 1)
    choose_direction();
  return true;
}

/// Along the path's tangent, onwards: where the velocity points, or with growing load at the start of the path.
void NewtonSolver::Implementation::choose_direction()
{
  double size;
  petsc(VecCopy(response, direction));
  petsc(VecNormalize(direction, &size));
  system.scatter(state->velocity, u);
  if (dot(direction, u) < 0)
    petsc(VecScale(direction, -1));
}

void NewtonSolver::Implementation::go_along(std::span<const double> given)
{
  if (given.empty())
    return;
  double size;
  system.scatter({given.begin(), given.end()}, direction);
  system.clear_held(direction);
  petsc(VecNormalize(direction, &size));
}

void NewtonSolver::Implementation::couple()
{
  if (!new_couplings)
    return;
  std::vector<std::vector<Node>> couplings;
  for (const auto *work : works)
    work->add_couplings(couplings);
  system.couple(couplings);
  new_couplings = false;
}

/// A tangent with more negative pivots than at the start of the step points away from the solution once the increments
/// do not shrink (or at once if it has two more): from then on contact's geometric part is left out of tangents that
/// have too many of them. Far from the solution a tangent is taken to have as many as the one before.
bool NewtonSolver::Implementation::factorise()
{
  const bool far = outcome.residuals.back() > parameters.krylov_below;
  if (outcome.convexified && far)
    return factorise_convex();
  if (!system.factorise(works, *state))
    return false;
  outcome.negative_pivots = system.negative_pivots();
  if (outcome.residuals.size() == 1)
    first_pivots = outcome.negative_pivots;
  const bool indefinite = outcome.negative_pivots > first_pivots;
  convex = convex || (indefinite && (watch.struggling() || outcome.negative_pivots > first_pivots + 1));
  outcome.convexified = convex && indefinite;
  return !outcome.convexified || factorise_convex();
}

bool NewtonSolver::Implementation::factorise_convex()
{
  for (auto *work : works)
    work->convexify(true);
  const bool done = system.factorise(works, *state);
  for (auto *work : works)
    work->convexify(false);
  return done;
}

void NewtonSolver::Implementation::solve(Vec f, Vec y)
{
  split(f, residual);
  system.solve_held(residual, u);
  if (!outcome.convexified)
    outcome.negative_pivots = system.negative_pivots(); // GMRES may have asked for a factor
  double change = parameter_of(f);
  if (has_unknown_load()) {
    if (target.what != Prescribe::parameter)
      change = (change - dot(constraint(), u)) / dot(constraint(), response);
    petsc(VecAXPY(u, change, response));
  }
  combine(u, change, y);
}

/// Half for a step along which the potential's slope does not come down, else 1. One trial only: contact must be let in
/// to be felt, and shortening until the slope comes down stops just outside it, for ever.
double NewtonSolver::Implementation::search(const std::vector<double> &increment, double parameter_increment)
{
  constexpr double enough = 0.8;
  const State from = *state;
  double slope_at_start, slope;
  system.clear_held(residual);
  slope_at_start = dot(residual, u);
  for (std::size_t i = 0; i < increment.size(); ++i)
    state->displacement[i] += increment[i];
  parameter(*state) += parameter_increment;
  assemble_residual();
  system.clear_held(residual);
  slope = dot(residual, u);
  *state = from;
  return std::abs(slope) <= enough * std::abs(slope_at_start) ? 1 : 0.5;
}

/// x -= fraction * y with the largest fraction every contribution can bear; stored quantities go along.
void NewtonSolver::Implementation::update(Vec x, Vec y)
{
  std::vector<double> increment(state->displacement.size());
  split(y, u);
  petsc(VecScale(u, -1));
  system.gather(u, increment);
  double fraction = 1;
  for (const auto *work : works)
    fraction = std::min(fraction, work->largest_step(*state, increment));
  MPI_Allreduce(MPI_IN_PLACE, &fraction, 1, MPI_DOUBLE, MPI_MIN, comm);
  fraction = watch.trusted(increment, fraction);
  if (watch.struggling() && fraction == 1) // else left alone: a perfect step of a nearly incompressible body raises it
    fraction = search(increment, -parameter_of(y));
  watch.taken(fraction);
  outcome.restless = watch.largest() / 3;
  for (auto *work : works)
    work->advance(*state, increment, fraction);
  petsc(VecAXPY(x, -fraction, y));
  split(x, u);
  system.gather(u, state->displacement);
  parameter(*state) = parameter_of(x);
  begin_iteration(outcome.residuals.size());
}

void NewtonSolver::Implementation::begin_iteration(int iteration)
{
  for (auto *work : works) {
    new_couplings = new_couplings || work->couplings_changed(); // by begin_step
    work->begin_iteration(*state, iteration);
    new_couplings = new_couplings || work->couplings_changed();
  }
  MPI_Allreduce(MPI_IN_PLACE, &new_couplings, 1, MPI_CXX_BOOL, MPI_LOR, comm);
}

bool NewtonSolver::Implementation::prescribed_is_met() const
{
  if (target.what == Prescribe::volume)
    return std::abs(parameter_miss) <= parameters.tolerance * target.volume;
  if (target.what == Prescribe::arc_length)
    return std::abs(parameter_miss) <= parameters.tolerance * (target.arc_length > 0 ? target.arc_length : 1);
  return parameter_miss == 0 || !cavity;
}

/// A step that motion can take over must come down to a residual of 0.3 within its patience, at a pace that shows
/// from four iterations before on.
bool NewtonSolver::Implementation::has_no_patience(int iteration, double relative) const
{
  constexpr double enough = 0.3, pace = 0.4;
  const int left = target.patience - iteration;
  return target.patience > 0 && left <= 4 && relative > enough * std::pow(pace, -left);
}

SNESConvergedReason NewtonSolver::Implementation::judge(int iteration)
{
  const double relative = residual_norm / force_scale;
  outcome.residuals.push_back(relative);
  if (!std::isfinite(relative)) {
    outcome.reason = "the residual is not a number";
    return SNES_DIVERGED_FNORM_NAN;
  }
  if (relative <= parameters.tolerance && held_miss < held_tolerance && prescribed_is_met()) {
    outcome.converged = true;
    return SNES_CONVERGED_FNORM_RELATIVE;
  }
  if (const auto reason = watch.reason_to_give_up()) {
    outcome.reason = *reason;
    return SNES_DIVERGED_LINE_SEARCH;
  }
  if (iteration >= parameters.max_iterations || has_no_patience(iteration, relative)) {
    outcome.reason =
        target.patience > 0 ? "no equilibrium is found in time" : "no convergence within newton.max_iterations";
    return SNES_DIVERGED_MAX_IT;
  }
  return SNES_CONVERGED_ITERATING;
}

} // namespace ballonet::solver
