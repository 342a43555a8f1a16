// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/newton.h"
#include "solver/parameters.h"
#include "solver/regularisation.h"
#include <string>

namespace ballonet::solver
{

/// Where a path stands; all that is needed to go on from there.
struct PathProgress {
  State state;
  Stability stability; ///< of the last equilibrium
  Regularisation regularisation;
  int step = 0;              ///< converged steps
  int cuts = 0;              ///< rejected attempts
  int setbacks = 0;          ///< two more with every cut, one less with every step: grows when the path stands still
  int iterations = 0;        ///< Newton iterations of all attempts
  int factorisations = 0;    ///< of all attempts
  double stretch = 0;        ///< next increment of the load factor
  double dt = 0;             ///< next time step, s
  double arc_length = 0;     ///< of the next step along the path, mm; 0 before the first one
  double dissipation = 0;    ///< rate in the last step of the cavity's drive, N mm/s; 0 before
  double ceiling = infinity; ///< of the lengths: a step as long as one rejected lately is not tried again at once
  double volume = 0;         ///< of the cavity, mm^3
  double pressure_peak = 0;  ///< running maximum, MPa
};

/// Which step comes next and how long it is: what the control of a path means. First the preload (gravity, loads, moved
/// supports, initial pressure), then what the control drives, with lengths chosen from the cost of the step before.
class StepPlan
{
public:
  struct Attempt {
    Step step;
    NewtonSolver::Target target;
    double PathProgress::*length; ///< what it is measured by: stretch, dt or arc_length
    bool may_move = false;        ///< a static step that a step in motion can take the place of
  };

  /// `reference_volume`: of the cavity at rest, mm^3; zero without one. `feels_rates`: a motion meets forces that a
  /// static step does not know. Throws std::invalid_argument for a control that has nothing to drive.
  StepPlan(const Path &path, double reference_volume, bool feels_rates);

  void start(PathProgress &progress) const;
  Attempt next(const PathProgress &progress) const;
  /// A static step that keeps the volume, or else the pressure, of a state in motion.
  Attempt to_rest(const PathProgress &progress) const;
  /// After a step that needed so many factorisations and dissipated so much, N mm.
  void lengthen(PathProgress &progress, const Attempt &taken, int factorisations, double dissipated) const;
  /// After a rejected attempt; false when the next one would be shorter than allowed.
  bool shorten(PathProgress &progress, const Attempt &rejected) const;
  /// Why the path ends here, or an empty string.
  std::string end_reached(const PathProgress &progress) const;

private:
  bool has_cavity() const { return reference_volume_ > 0; }
  bool preloading(const PathProgress &progress) const;
  Attempt preload(const PathProgress &progress) const;
  Attempt along_arc(const PathProgress &progress) const;
  Attempt in_time(const PathProgress &progress) const;
  double snap_limit(PathProgress &progress, const Attempt &taken, double dissipated) const;

  const Path &path_;
  double reference_volume_;
  bool feels_rates_;
};

} // namespace ballonet::solver
