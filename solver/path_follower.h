// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/critical_points.h"
#include "solver/equilibrium.h"
#include "solver/step_plan.h"
#include <functional>

namespace ballonet::solver
{

/// A converged step, as shown to the observer.
struct PathPoint {
  const PathProgress &progress;
  double dt;               ///< s
  double reference_volume; ///< V0, mm^3
  NewtonSolver::Outcome newton;
  double dissipated_share = 0; ///< viscous work of the step over all energy moved in it
  double kinetic_share = 0;    ///< kinetic over stored energy
  bool at_rest = false;        ///< an equilibrium; else a state of a motion
  Stability stability = {};    ///< of the static tangent at rest; of the step's, with its viscosity and mass, in motion
  std::vector<CriticalPoint> critical_points = {}; ///< between the equilibrium before and this one
};

enum class PathStatus { ended, diverged, step_limit, time_limit };

struct PathResult {
  PathStatus status = PathStatus::ended;
  std::string reason; ///< why the path ended, in words
};

/// Follows the equilibrium path, step by step as the plan says.
class PathFollower
{
public:
  /// Looks at a converged step; a text says why the path shall end here.
  using Observer = std::function<std::string(const PathPoint &)>;
  /// Hears what happens: steps, cuts, residuals.
  using Log = std::function<void(const std::string &)>;

  PathFollower(Equilibrium &equilibrium, const Path &path, MPI_Comm comm);

  PathProgress start() const;
  PathResult run(PathProgress &progress, const Observer &observe, const Log &log);

private:
  /// Tries one step; false when the path is over, with the reason in `result`.
  bool advance(PathProgress &progress, const Observer &observe, const Log &log, PathResult &result);
  NewtonSolver::Outcome solve(PathProgress &progress, State &state, const StepPlan::Attempt &attempt);
  bool reject(PathProgress &progress, const StepPlan::Attempt &attempt, PathResult &result) const;
  void accept(PathProgress &progress, State &&end, const NewtonSolver::Outcome &outcome) const;
  /// Relaxes a state in motion at held volume, if it is time for that and an equilibrium is found.
  void seek_rest(PathProgress &progress, PathPoint &point, const Log &log);
  PathPoint point(const PathProgress &progress, const Step &step, const Energies &before, const Energies &after,
                  const NewtonSolver::Outcome &outcome) const;
  /// Counts the unstable motions of an equilibrium, and looks for critical points between it and the one before.
  void look_at_stability(PathProgress &progress, PathPoint &point);
  void find_critical_points(const Station &before, NewtonSolver::Prescribe what, PathProgress &progress,
                            PathPoint &point, const Log &log);
  void branch_off(const CriticalPoint &from, PathProgress &progress, PathPoint &point, const Log &log);
  double seconds() const;

  Equilibrium &equilibrium_;
  const Path &path_;
  MPI_Comm comm_;
  double reference_volume_, started_;
  StepPlan plan_;
  CriticalPointSearch search_;
};

} // namespace ballonet::solver
