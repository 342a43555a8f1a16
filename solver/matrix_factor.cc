// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/matrix_factor.h"
#include "solver/petsc_call.h"
#include <cmath>

namespace ballonet::solver
{

namespace
{

/// Options MUMPS takes only from the options database (PETSc 3.18).
void set_mumps_options()
{
  const std::pair<const char *, const char *> options[] = {{"icntl_4", "0"},   // silent
                                                           {"icntl_6", "0"},   // no permutation to a heavy diagonal
                                                           {"icntl_7", "2"},   // ordering: approximate minimum fill
                                                           {"icntl_8", "0"},   // no scaling: definite, units alike
                                                           {"icntl_12", "1"},  // plain symmetric ordering
                                                           {"icntl_14", "80"}, // % of extra working space
                                                           {"cntl_1", "0"}};   // pivots in order: faster by 8 %
  for (const auto &[key, value] : options)
    petsc(PetscOptionsSetValue(nullptr, (std::string("-ballonet_mat_mumps_") + key).c_str(), value));
}

PC create_factor(MPI_Comm comm, Mat matrix)
{
  PC factor;
  petsc(PCCreate(comm, &factor));
  petsc(PCSetOptionsPrefix(factor, "ballonet_"));
  petsc(PCSetType(factor, PCCHOLESKY));
  petsc(PCSetOperators(factor, matrix, matrix));
  petsc(PCFactorSetMatSolverType(factor, MATSOLVERMUMPS));
  petsc(PCSetFromOptions(factor));
  petsc(PCFactorSetUpMatSolverType(factor));
  return factor;
}

KSP create_krylov(MPI_Comm comm, Mat matrix, PC factor)
{
  constexpr double tolerance = 1e-4;  // keeps Newton's pace
  constexpr int most_iterations = 12; // cost as much as a factorisation
  KSP krylov;
  petsc(KSPCreate(comm, &krylov));
  petsc(KSPSetType(krylov, KSPGMRES));
  petsc(KSPSetPC(krylov, factor));
  petsc(KSPSetOperators(krylov, matrix, matrix));
  petsc(KSPSetTolerances(krylov, tolerance, PETSC_DEFAULT, PETSC_DEFAULT, most_iterations));
  return krylov;
}

} // namespace

MatrixFactor::MatrixFactor() { set_mumps_options(); }

MatrixFactor::~MatrixFactor()
{
  KSPDestroy(&krylov_);
  PCDestroy(&factor_);
}

void MatrixFactor::set_matrix(Mat matrix)
{
  MPI_Comm comm;
  petsc(PetscObjectGetComm(reinterpret_cast<PetscObject>(matrix), &comm));
  petsc(KSPDestroy(&krylov_));
  petsc(PCDestroy(&factor_));
  factor_ = create_factor(comm, matrix);
  krylov_ = create_krylov(comm, matrix, factor_);
}

bool MatrixFactor::compute()
{
  preconditions_ = false;
  ++computed_;
  petsc(PCSetReusePreconditioner(factor_, PETSC_FALSE));
  petsc(PCSetUp(factor_));
  Mat factor;
  petsc(PCFactorGetMatrix(factor_, &factor));
  PetscInt info;
  petsc(MatMumpsGetInfog(factor, 1, &info));
  if (info < 0)
    return false;
  petsc(MatMumpsGetInfog(factor, 12, &info));
  negative_pivots_ = info;
  return true;
}

void MatrixFactor::precondition()
{
  preconditions_ = true;
  petsc(PCSetReusePreconditioner(factor_, PETSC_TRUE));
}

void MatrixFactor::solve(Vec b, Vec x)
{
  if (preconditions_) {
    petsc(KSPSolve(krylov_, b, x));
    KSPConvergedReason reason;
    petsc(KSPGetConvergedReason(krylov_, &reason));
    if (reason > 0)
      return;
    if (!compute()) {
      petsc(VecSet(x, std::nan("")));
      return;
    }
  }
  petsc(PCApply(factor_, b, x));
}

} // namespace ballonet::solver
