// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/simulation.h"
#include "solver/checkpoint.h"

namespace ballonet::solver
{

Simulation::Simulation(const Parameters &parameters, const Mesh &mesh, MPI_Comm comm)
    : parameters_(parameters), comm_(comm), equilibrium_(parameters, mesh, comm),
      follower_(equilibrium_, parameters.path, comm), progress_(follower_.start())
{
}

bool Simulation::resume(const std::string &file) { return read_checkpoint(file, progress_); }

PathResult Simulation::run(const PathFollower::Observer &observe, const PathFollower::Log &log)
{
  int rank;
  MPI_Comm_rank(comm_, &rank);
  const auto watch = [&](const PathPoint &point) {
    const auto reason = observe(point);
    if (!checkpoint_.empty() && rank == 0 && progress_.step % parameters_.path.checkpoint_every == 0)
      write_checkpoint(checkpoint_, progress_);
    return reason;
  };
  return follower_.run(progress_, watch, log);
}

} // namespace ballonet::solver
