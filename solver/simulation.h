// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/path_follower.h"

namespace ballonet::solver
{

/// One simulation: a mesh, its materials, supports and loads, and the path it follows.
///
///   Simulation simulation(parameters, mesh, comm);
///   PathResult result = simulation.run(observe, log);
class Simulation
{
public:
  /// Throws std::invalid_argument on inconsistent input. The arguments must outlive this object.
  Simulation(const Parameters &parameters, const Mesh &mesh, MPI_Comm comm);

  const Equilibrium &equilibrium() const { return equilibrium_; }
  const PathProgress &progress() const { return progress_; }

  /// Where checkpoints are written (every path.checkpoint_every steps); none by default.
  void set_checkpoint(std::string file) { checkpoint_ = std::move(file); }
  /// Continues from a checkpoint written before; false when the file does not exist.
  bool resume(const std::string &file);

  PathResult run(const PathFollower::Observer &observe, const PathFollower::Log &log);

private:
  const Parameters &parameters_;
  MPI_Comm comm_;
  Equilibrium equilibrium_;
  PathFollower follower_;
  PathProgress progress_;
  std::string checkpoint_;
};

} // namespace ballonet::solver
