// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/linear_system.h"
#include <petscsnes.h>

namespace ballonet::solver
{

/// PETSc's Newton iteration (SNES) for a displacement and one load parameter, with everything that belongs to the
/// problem left to the derived class: the residual, the tangent, its solution, how far to go, and when to stop. The
/// last rank appends the parameter to its part of the vectors.
class SnesIteration
{
public:
  SnesIteration(const LinearSystem &system, MPI_Comm comm, int max_iterations);
  virtual ~SnesIteration();
  SnesIteration(const SnesIteration &) = delete;
  SnesIteration &operator=(const SnesIteration &) = delete;

protected:
  /// From a displacement and a parameter on, until judge() says so.
  void iterate(Vec displacement, double parameter);

  /// Residual at x.
  virtual void evaluate(Vec x, Vec residual) = 0;
  /// Makes the tangent of the present state ready for solve(); false when that fails.
  virtual bool linearise() = 0;
  /// y = K^-1 f with that tangent.
  virtual void solve(Vec f, Vec y) = 0;
  /// x -= y, or a part of it.
  virtual void update(Vec x, Vec y) = 0;
  virtual SNESConvergedReason judge(int iteration) = 0;

  double sum(double value) const;
  double parameter_of(Vec vector) const;
  void combine(Vec displacement, double parameter, Vec vector) const;
  void split(Vec vector, Vec displacement) const;

private:
  void set_callbacks();
  void set_linear_solver();
  void set_line_search();

  MPI_Comm comm_;
  bool holds_parameter_;
  SNES snes_ = nullptr;
  Mat shell_ = nullptr;
  Vec x_ = nullptr, f_ = nullptr;
};

} // namespace ballonet::solver
