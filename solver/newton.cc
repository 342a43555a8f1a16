// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/newton.h"
#include "solver/increment_watch.h"
#include "solver/petsc_call.h"
#include <algorithm>
#include <cmath>
#include <petscsnes.h>

namespace ballonet::solver
{

struct NewtonSolver::Implementation {
  LinearSystem &system;
  std::vector<VirtualWork *> works;
  CavityWork *cavity;
  MPI_Comm comm;
  Newton parameters;
  bool holds_pressure_unknown; ///< the last rank appends p to its part of the SNES vector

  SNES snes = nullptr;
  Mat shell = nullptr;
  Vec x = nullptr, f = nullptr; ///< displacement and pressure
  Vec u = nullptr, residual = nullptr, gradient = nullptr, free_gradient = nullptr, response = nullptr;

  State *state = nullptr;
  Target target;
  Outcome outcome;
  double held_miss = 0, residual_norm = 0, force_scale = 0;
  IncrementWatch watch;
  bool convex = false;  ///< the step has met a tangent that had to be made convex
  int first_pivots = 0; ///< negative ones at the start of the step
  bool new_couplings = false;

  Implementation(LinearSystem &system, std::vector<VirtualWork *> works, CavityWork *cavity, MPI_Comm comm,
                 const Newton &parameters);
  ~Implementation();

  double sum(double value) const
  {
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, comm);
    return value;
  }
  double pressure_of(Vec vector) const;
  void combine(Vec displacement, double pressure, Vec vector) const;
  void split(Vec vector, Vec displacement) const;

  void evaluate(Vec f);
  bool linearise();
  bool factorise();
  void solve_bordered(Vec f, Vec y);
  void update(Vec x, Vec y);
  void assemble_residual();
  double search(const std::vector<double> &increment, double pressure_increment);
  SNESConvergedReason judge(int iteration);
  void begin_iteration(int iteration);
};

NewtonSolver::Implementation::Implementation(LinearSystem &system, std::vector<VirtualWork *> works, CavityWork *cavity,
                                             MPI_Comm comm, const Newton &parameters)
    : system(system), works(std::move(works)), cavity(cavity), comm(comm), parameters(parameters)
{
  int rank, ranks;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &ranks);
  holds_pressure_unknown = rank == ranks - 1;
  for (Vec *vector : {&u, &residual, &gradient, &free_gradient, &response})
    *vector = system.create_vector();
  PetscInt local;
  petsc(VecGetLocalSize(u, &local));
  petsc(VecCreateMPI(comm, local + holds_pressure_unknown, PETSC_DETERMINE, &x));
  petsc(VecDuplicate(x, &f));
  petsc(VecGetLocalSize(x, &local));
  petsc(MatCreateShell(comm, local, local, PETSC_DETERMINE, PETSC_DETERMINE, this, &shell));

  petsc(SNESCreate(comm, &snes));
  petsc(SNESSetType(snes, SNESNEWTONLS));
  petsc(SNESSetFunction(
      snes, f,
      [](SNES, Vec, Vec f, void *self) {
        static_cast<Implementation *>(self)->evaluate(f);
        return PetscErrorCode(0);
      },
      this));
  petsc(SNESSetJacobian(
      snes, shell, shell,
      [](SNES snes, Vec, Mat, Mat, void *self) {
        if (!static_cast<Implementation *>(self)->linearise())
          SNESSetJacobianDomainError(snes);
        return PetscErrorCode(0);
      },
      this));
  petsc(SNESSetConvergenceTest(
      snes,
      [](SNES, PetscInt iteration, PetscReal, PetscReal, PetscReal, SNESConvergedReason *reason, void *self) {
        *reason = static_cast<Implementation *>(self)->judge(iteration);
        return PetscErrorCode(0);
      },
      this, nullptr));
  petsc(SNESSetTolerances(snes, 0, 0, 0, parameters.max_iterations, PETSC_DEFAULT));
  petsc(SNESSetCheckJacobianDomainError(snes, PETSC_TRUE));

  KSP ksp;
  PC pc;
  petsc(SNESGetKSP(snes, &ksp));
  petsc(KSPSetType(ksp, KSPPREONLY));
  petsc(KSPGetPC(ksp, &pc));
  petsc(PCSetType(pc, PCSHELL));
  petsc(PCShellSetContext(pc, this));
  petsc(PCShellSetApply(pc, [](PC pc, Vec f, Vec y) {
    void *self;
    PetscErrorCode code = PCShellGetContext(pc, &self);
    static_cast<Implementation *>(self)->solve_bordered(f, y);
    return code;
  }));

  SNESLineSearch search;
  petsc(SNESGetLineSearch(snes, &search));
  petsc(SNESLineSearchSetType(search, SNESLINESEARCHSHELL));
  petsc(SNESLineSearchShellSetUserFunc(
      search,
      [](SNESLineSearch search, void *self) {
        Vec x, f, y;
        PetscErrorCode code = SNESLineSearchGetVecs(search, &x, &f, &y, nullptr, nullptr);
        SNES snes;
        code = code ? code : SNESLineSearchGetSNES(search, &snes);
        static_cast<Implementation *>(self)->update(x, y);
        code = code ? code : SNESComputeFunction(snes, x, f);
        code = code ? code : SNESLineSearchComputeNorms(search);
        return code ? code : SNESLineSearchSetReason(search, SNES_LINESEARCH_SUCCEEDED);
      },
      this));
}

NewtonSolver::Implementation::~Implementation()
{
  SNESDestroy(&snes);
  MatDestroy(&shell);
  for (Vec *vector : {&x, &f, &u, &residual, &gradient, &free_gradient, &response})
    VecDestroy(vector);
}

double NewtonSolver::Implementation::pressure_of(Vec vector) const
{
  double pressure = 0;
  if (holds_pressure_unknown) {
    PetscInt size;
    const double *values;
    petsc(VecGetLocalSize(vector, &size));
    petsc(VecGetArrayRead(vector, &values));
    pressure = values[size - 1];
    petsc(VecRestoreArrayRead(vector, &values));
  }
  return sum(pressure);
}

void NewtonSolver::Implementation::combine(Vec displacement, double pressure, Vec vector) const
{
  PetscInt size;
  const double *from;
  double *to;
  petsc(VecGetLocalSize(displacement, &size));
  petsc(VecGetArrayRead(displacement, &from));
  petsc(VecGetArray(vector, &to));
  std::copy(from, from + size, to);
  if (holds_pressure_unknown)
    to[size] = pressure;
  petsc(VecRestoreArray(vector, &to));
  petsc(VecRestoreArrayRead(displacement, &from));
}

void NewtonSolver::Implementation::split(Vec vector, Vec displacement) const
{
  PetscInt size;
  const double *from;
  double *to;
  petsc(VecGetLocalSize(displacement, &size));
  petsc(VecGetArrayRead(vector, &from));
  petsc(VecGetArray(displacement, &to));
  std::copy(from, from + size, to);
  petsc(VecRestoreArray(displacement, &to));
  petsc(VecRestoreArrayRead(vector, &from));
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

/// Residual of the current state; norms of its free part, of the misses of held values and of the force scale.
void NewtonSolver::Implementation::evaluate(Vec out)
{
  assemble_residual();
  const double reaction = system.clear_held(residual);
  petsc(VecNorm(residual, NORM_2, &residual_norm));
  held_miss = system.hold(*state, residual);
  force_scale = std::max(parameters.force_floor, reaction);
  double miss = state->pressure - target.pressure;
  if (cavity) {
    outcome.volume = sum(cavity->volume(*state));
    system.assemble([&](Assembly &assembly) { cavity->volume_gradient(*state, assembly); }, gradient);
    petsc(VecCopy(gradient, free_gradient));
    system.clear_held(free_gradient);
    double norm;
    petsc(VecNorm(free_gradient, NORM_2, &norm));
    force_scale = std::max(force_scale, std::abs(state->pressure) * norm);
    if (target.volume_prescribed)
      miss = outcome.volume - target.volume;
  }
  combine(residual, miss, out);
}

bool NewtonSolver::Implementation::linearise()
{
  if (new_couplings) {
    std::vector<std::vector<Node>> couplings;
    for (const auto *work : works)
      work->add_couplings(couplings);
    system.couple(couplings);
    new_couplings = false;
  }
  if (!factorise()) {
    outcome.reason = "the factorisation of the tangent failed";
    return false;
  }
  if (cavity)
    system.solve(free_gradient, response);
  return true;
}

/// A tangent with more negative pivots than at the start of the step points away from the solution once the increments
/// do not shrink (or at once if it has two more): from then on contact's geometric part is left out of tangents that
/// have too many of them.
bool NewtonSolver::Implementation::factorise()
{
  if (!system.factorise(works, *state))
    return false;
  outcome.negative_pivots = system.negative_pivots();
  if (outcome.residuals.size() == 1)
    first_pivots = outcome.negative_pivots;
  const bool indefinite = outcome.negative_pivots > first_pivots;
  convex = convex || (indefinite && (watch.struggling() || outcome.negative_pivots > first_pivots + 1));
  if (!convex || !indefinite)
    return true;
  for (auto *work : works)
    work->convexify(true);
  const bool done = system.factorise(works, *state);
  for (auto *work : works)
    work->convexify(false);
  return done;
}

void NewtonSolver::Implementation::solve_bordered(Vec f, Vec y)
{
  split(f, residual);
  system.solve_held(residual, u);
  double pressure = pressure_of(f);
  if (cavity) {
    if (target.volume_prescribed) {
      double reached, gained;
      petsc(VecDot(gradient, u, &reached));
      petsc(VecDot(gradient, response, &gained));
      pressure = (pressure - reached) / gained;
    }
    petsc(VecAXPY(u, pressure, response));
  }
  combine(u, pressure, y);
}

/// Half for a step along which the potential's slope does not come down, else 1. One trial only: contact must be let in
/// to be felt, and shortening until the slope comes down stops just outside it, for ever.
double NewtonSolver::Implementation::search(const std::vector<double> &increment, double pressure_increment)
{
  constexpr double enough = 0.8;
  const State start = *state;
  double slope_at_start, slope;
  system.clear_held(residual);
  petsc(VecDot(residual, u, &slope_at_start));
  for (std::size_t i = 0; i < increment.size(); ++i)
    state->displacement[i] += increment[i];
  state->pressure += pressure_increment;
  assemble_residual();
  system.clear_held(residual);
  petsc(VecDot(residual, u, &slope));
  *state = start;
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
    fraction = search(increment, -pressure_of(y));
  watch.taken(fraction);
  for (auto *work : works)
    work->advance(*state, increment, fraction);
  petsc(VecAXPY(x, -fraction, y));
  split(x, u);
  system.gather(u, state->displacement);
  state->pressure = pressure_of(x);
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

SNESConvergedReason NewtonSolver::Implementation::judge(int iteration)
{
  const double relative = residual_norm / force_scale;
  outcome.residuals.push_back(relative);
  if (!std::isfinite(relative)) {
    outcome.reason = "the residual is not a number";
    return SNES_DIVERGED_FNORM_NAN;
  }
  const double volume_miss = target.volume_prescribed ? std::abs(outcome.volume / target.volume - 1) : 0;
  const bool pressure_met = target.volume_prescribed || state->pressure == target.pressure || !cavity;
  if (relative <= parameters.tolerance && volume_miss <= parameters.tolerance && held_miss < 1e-10 && pressure_met) {
    outcome.converged = true;
    return SNES_CONVERGED_FNORM_RELATIVE;
  }
  if (const auto reason = watch.reason_to_give_up()) {
    outcome.reason = *reason;
    return SNES_DIVERGED_LINE_SEARCH;
  }
  if (iteration >= parameters.max_iterations) {
    outcome.reason = "no convergence within newton.max_iterations";
    return SNES_DIVERGED_MAX_IT;
  }
  return SNES_CONVERGED_ITERATING;
}

NewtonSolver::NewtonSolver(LinearSystem &system, std::vector<VirtualWork *> works, CavityWork *cavity, MPI_Comm comm,
                           const Newton &parameters)
    : impl_(std::make_unique<Implementation>(system, std::move(works), cavity, comm, parameters))
{
}

NewtonSolver::~NewtonSolver() = default;

NewtonSolver::Outcome NewtonSolver::solve(State &state, const Target &target)
{
  impl_->state = &state;
  impl_->target = target;
  impl_->outcome = {};
  impl_->watch = {};
  impl_->convex = false;
  impl_->system.scatter(state.displacement, impl_->u);
  impl_->combine(impl_->u, state.pressure, impl_->x);
  impl_->begin_iteration(0);
  petsc(SNESSolve(impl_->snes, nullptr, impl_->x));
  if (!impl_->outcome.converged && impl_->outcome.reason.empty())
    impl_->outcome.reason = "the linear system could not be solved";
  return impl_->outcome;
}

double NewtonSolver::volume(const State &state) const
{
  return impl_->cavity ? impl_->sum(impl_->cavity->volume(state)) : 0;
}

std::vector<double> NewtonSolver::forces(const State &state) const
{
  std::vector<double> forces(state.displacement.size());
  State copy = state;
  impl_->state = &copy;
  impl_->assemble_residual();
  impl_->system.gather(impl_->residual, forces);
  return forces;
}

} // namespace ballonet::solver
