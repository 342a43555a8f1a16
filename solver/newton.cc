// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/newton_iteration.h"

namespace ballonet::solver
{

NewtonSolver::NewtonSolver(LinearSystem &system, std::vector<VirtualWork *> works, std::vector<VirtualWork *> loads,
                           CavityWork *cavity, MPI_Comm comm, const Newton &parameters)
    : impl_(std::make_unique<Implementation>(system, std::move(works), std::move(loads), cavity, comm, parameters))
{
}

NewtonSolver::~NewtonSolver() = default;

NewtonSolver::Outcome NewtonSolver::solve(State &state, const Target &target)
{
  impl_->state = &state;
  impl_->target = target;
  if (!impl_->cavity && target.what == Prescribe::parameter)
    impl_->target.parameter = state.load_factor; // the loads are what the state says
  impl_->outcome = {};
  impl_->convex = false;
  impl_->system.scatter(state.displacement, impl_->u);
  petsc(VecCopy(impl_->u, impl_->start));
  impl_->go_along(target.direction);
  return impl_->run();
}

NewtonSolver::Outcome NewtonSolver::go_on(State &state)
{
  impl_->state = &state;
  impl_->outcome.converged = false;
  impl_->outcome.residuals.pop_back(); // the first one of what follows takes its place
  impl_->system.scatter(state.displacement, impl_->u);
  return impl_->run();
}

double NewtonSolver::volume(const State &state) const
{
  return impl_->cavity ? impl_->sum(impl_->cavity->volume(state)) : 0;
}

std::vector<double> NewtonSolver::load_force(const State &state) const
{
  std::vector<double> force(state.displacement.size());
  State copy = state;
  impl_->state = &copy;
  impl_->assemble_force();
  impl_->system.gather(impl_->free_force, force);
  return force;
}

double NewtonSolver::compliance(const State &state) const
{
  impl_->system.scatter(load_force(state), impl_->free_force);
  impl_->system.solve(impl_->free_force, impl_->response);
  return impl_->dot(impl_->free_force, impl_->response);
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
