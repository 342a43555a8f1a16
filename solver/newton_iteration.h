// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/increment_watch.h"
#include "solver/newton.h"
#include "solver/petsc_call.h"
#include "solver/snes_iteration.h"

namespace ballonet::solver
{

/// The Newton iteration of one step: residual, tangent and increment of all contributions with the second equation.
struct NewtonSolver::Implementation : SnesIteration {
  using SnesIteration::iterate, SnesIteration::sum;

  LinearSystem &system;
  std::vector<VirtualWork *> works, loads;
  CavityWork *cavity;
  MPI_Comm comm;
  Newton parameters;

  Vec u = nullptr, residual = nullptr;
  Vec force = nullptr, free_force = nullptr; ///< F, and without what acts on held values
  Vec response = nullptr;                    ///< K^-1 F
  Vec start = nullptr, direction = nullptr;  ///< of a step of prescribed arc length

  State *state = nullptr;
  Target target;
  Outcome outcome;
  double held_miss = 0, parameter_miss = 0, residual_norm = 0, force_scale = 0;
  IncrementWatch watch;
  bool convex = false;  ///< the step has met a tangent that had to be made convex
  int first_pivots = 0; ///< negative ones at the start of the step
  bool new_couplings = false;

  Implementation(LinearSystem &system, std::vector<VirtualWork *> works, std::vector<VirtualWork *> loads,
                 CavityWork *cavity, MPI_Comm comm, const Newton &parameters);
  ~Implementation() override;

  double dot(Vec a, Vec b) const
  {
    double product;
    petsc(VecDot(a, b, &product));
    return product;
  }
  /// The load parameter of a state.
  double &parameter(State &s) const { return cavity ? s.pressure : s.load_factor; }
  Vec constraint() const { return target.what == Prescribe::volume ? force : direction; }

  /// A cavity's pressure always is an unknown, the load factor only along an arc.
  bool has_unknown_load() const { return cavity || target.what == Prescribe::arc_length; }
  Outcome run();
  void assemble_force();
  double miss(Vec x);
  void evaluate(Vec x, Vec f) override;
  void choose_direction();
  void go_along(std::span<const double> given);
  bool linearise() override;
  bool last_factor_serves() const;
  bool has_factor() const;
  void couple();
  bool factorise();
  bool factorise_convex();
  void solve(Vec f, Vec y) override;
  void update(Vec x, Vec y) override;
  void assemble_residual();
  double search(const std::vector<double> &increment, double parameter_increment);
  bool prescribed_is_met() const;
  bool has_no_patience(int iteration, double relative) const;
  SNESConvergedReason judge(int iteration) override;
  void begin_iteration(int iteration);
};

} // namespace ballonet::solver
