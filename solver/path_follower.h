// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/equilibrium.h"
#include <functional>

namespace ballonet::solver
{

/// Where a path stands; all that is needed to go on from there.
struct PathProgress {
  State state;
  int step = 0;             ///< converged steps
  int cuts = 0;             ///< rejected attempts
  int setbacks = 0;         ///< two more with every cut, one less with every step: grows when the path stands still
  int iterations = 0;       ///< Newton iterations of all attempts
  int factorisations = 0;   ///< of all attempts
  double load_factor = 0;   ///< of gravity, loads and moved supports
  double stretch = 0;       ///< next increment of the load factor
  double dt = 0;            ///< next time step, s
  double volume = 0;        ///< of the cavity, mm^3
  double pressure_peak = 0; ///< running maximum, MPa
};

/// A converged step, as shown to the observer.
struct PathPoint {
  const PathProgress &progress;
  double dt;               ///< s
  double reference_volume; ///< V0, mm^3
  NewtonSolver::Outcome newton;
  double dissipated_share = 0; ///< viscous work of the step over all energy moved in it
  double kinetic_share = 0;    ///< kinetic over stored energy
};

enum class PathStatus { ended, diverged, step_limit, time_limit };

struct PathResult {
  PathStatus status = PathStatus::ended;
  std::string reason; ///< why the path ended, in words
};

/// Follows the equilibrium path: first the preload (gravity, loads, moved supports, initial pressure), then the
/// cavity's volume or pressure, with time steps chosen from the number of Newton iterations.
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
  struct Attempt {
    Step step;
    NewtonSolver::Target target;
    double stretch = 0; ///< of the load factor
  };
  bool preloading(const PathProgress &progress) const { return progress.load_factor < 1; }
  Attempt next(const PathProgress &progress) const;
  /// Takes one step; false after a cut.
  bool advance(PathProgress &progress, const Observer &observe, const Log &log, PathResult &result);
  void adapt(PathProgress &progress, int factorisations) const;
  std::string end_reached(const PathProgress &progress) const;
  double seconds() const;

  Equilibrium &equilibrium_;
  const Path &path_;
  MPI_Comm comm_;
  double reference_volume_, started_;
};

} // namespace ballonet::solver
