// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/snes_iteration.h"
#include "solver/petsc_call.h"
#include <algorithm>

namespace ballonet::solver
{

namespace
{

/// Copies this rank's displacements between two vectors of which one may have the parameter behind them.
void copy_displacement(Vec from, Vec to)
{
  PetscInt size_from, size_to;
  const double *source;
  double *target;
  petsc(VecGetLocalSize(from, &size_from));
  petsc(VecGetLocalSize(to, &size_to));
  petsc(VecGetArrayRead(from, &source));
  petsc(VecGetArray(to, &target));
  std::copy_n(source, std::min(size_from, size_to), target);
  petsc(VecRestoreArray(to, &target));
  petsc(VecRestoreArrayRead(from, &source));
}

} // namespace

SnesIteration::SnesIteration(const LinearSystem &system, MPI_Comm comm, int max_iterations) : comm_(comm)
{
  int rank, ranks;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &ranks);
  holds_parameter_ = rank == ranks - 1;
  Vec displacement = system.create_vector();
  PetscInt local;
  petsc(VecGetLocalSize(displacement, &local));
  petsc(VecDestroy(&displacement));
  local += holds_parameter_;
  petsc(VecCreateMPI(comm, local, PETSC_DETERMINE, &x_));
  petsc(VecDuplicate(x_, &f_));
  petsc(MatCreateShell(comm, local, local, PETSC_DETERMINE, PETSC_DETERMINE, this, &shell_));
  petsc(SNESCreate(comm, &snes_));
  petsc(SNESSetType(snes_, SNESNEWTONLS));
  petsc(SNESSetTolerances(snes_, 0, 0, 0, max_iterations, PETSC_DEFAULT));
  petsc(SNESSetCheckJacobianDomainError(snes_, PETSC_TRUE));
  set_callbacks();
  set_linear_solver();
  set_line_search();
}

SnesIteration::~SnesIteration()
{
  SNESDestroy(&snes_);
  MatDestroy(&shell_);
  VecDestroy(&x_);
  VecDestroy(&f_);
}

void SnesIteration::set_callbacks()
{
  petsc(SNESSetFunction(
      snes_, f_,
      [](SNES, Vec x, Vec f, void *self) {
        static_cast<SnesIteration *>(self)->evaluate(x, f);
        return PetscErrorCode(0);
      },
      this));
  petsc(SNESSetJacobian(
      snes_, shell_, shell_,
      [](SNES snes, Vec, Mat, Mat, void *self) {
        if (!static_cast<SnesIteration *>(self)->linearise())
          SNESSetJacobianDomainError(snes);
        return PetscErrorCode(0);
      },
      this));
  petsc(SNESSetConvergenceTest(
      snes_,
      [](SNES, PetscInt iteration, PetscReal, PetscReal, PetscReal, SNESConvergedReason *reason, void *self) {
        *reason = static_cast<SnesIteration *>(self)->judge(iteration);
        return PetscErrorCode(0);
      },
      this, nullptr));
}

void SnesIteration::set_linear_solver()
{
  KSP ksp;
  PC pc;
  petsc(SNESGetKSP(snes_, &ksp));
  petsc(KSPSetType(ksp, KSPPREONLY));
  petsc(KSPGetPC(ksp, &pc));
  petsc(PCSetType(pc, PCSHELL));
  petsc(PCShellSetContext(pc, this));
  petsc(PCShellSetApply(pc, [](PC pc, Vec f, Vec y) {
    void *self;
    PetscErrorCode code = PCShellGetContext(pc, &self);
    static_cast<SnesIteration *>(self)->solve(f, y);
    return code;
  }));
}

void SnesIteration::set_line_search()
{
  SNESLineSearch search;
  petsc(SNESGetLineSearch(snes_, &search));
  petsc(SNESLineSearchSetType(search, SNESLINESEARCHSHELL));
  petsc(SNESLineSearchShellSetUserFunc(
      search,
      [](SNESLineSearch search, void *self) {
        Vec x, f, y;
        PetscErrorCode code = SNESLineSearchGetVecs(search, &x, &f, &y, nullptr, nullptr);
        SNES snes;
        code = code ? code : SNESLineSearchGetSNES(search, &snes);
        static_cast<SnesIteration *>(self)->update(x, y);
        code = code ? code : SNESComputeFunction(snes, x, f);
        code = code ? code : SNESLineSearchComputeNorms(search);
        return code ? code : SNESLineSearchSetReason(search, SNES_LINESEARCH_SUCCEEDED);
      },
      this));
}

void SnesIteration::iterate(Vec displacement, double parameter)
{
  combine(displacement, parameter, x_);
  petsc(SNESSolve(snes_, nullptr, x_));
}

double SnesIteration::sum(double value) const
{
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, comm_);
  return value;
}

double SnesIteration::parameter_of(Vec vector) const
{
  double parameter = 0;
  if (holds_parameter_) {
    PetscInt size;
    const double *values;
    petsc(VecGetLocalSize(vector, &size));
    petsc(VecGetArrayRead(vector, &values));
    parameter = values[size - 1];
    petsc(VecRestoreArrayRead(vector, &values));
  }
  return sum(parameter);
}

void SnesIteration::combine(Vec displacement, double parameter, Vec vector) const
{
  copy_displacement(displacement, vector);
  if (!holds_parameter_)
    return;
  PetscInt size;
  double *values;
  petsc(VecGetLocalSize(vector, &size));
  petsc(VecGetArray(vector, &values));
  values[size - 1] = parameter;
  petsc(VecRestoreArray(vector, &values));
}

void SnesIteration::split(Vec vector, Vec displacement) const { copy_displacement(vector, displacement); }

} // namespace ballonet::solver
