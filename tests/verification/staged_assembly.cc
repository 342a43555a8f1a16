// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/verification/staged_assembly.h"
#include "tests/support/reaction.h"
#include <catch2/catch.hpp>

namespace ballonet::tests
{

using namespace solver;

StagedAssembly::StagedAssembly(const Mesh &mesh, Parameters start) : parameters(std::move(start)), mesh_(mesh)
{
  const std::vector<double> zeros(3 * mesh.nodes.size());
  state = {zeros, zeros, zeros, {}, 0, 0};
}

void StagedAssembly::step(double dt)
{
  equilibrium_.reset(); // it refers to the parameters of its stage
  present_ = parameters;
  equilibrium_ = std::make_unique<Equilibrium>(present_, mesh_, MPI_COMM_SELF);
  const auto outcome = equilibrium_->solve(state, {.dt = dt}, {});
  INFO(outcome.reason << ", last residual " << outcome.residuals.back());
  REQUIRE(outcome.converged);
  REQUIRE(equilibrium_->contacts().objection(state) == "");
  state.time += dt;
}

Vector3 StagedAssembly::force_on(const std::string &surface) const
{
  return reaction(mesh_, *equilibrium_, state, surface);
}

Vector3 StagedAssembly::displacement_of(const std::string &surface) const
{
  const auto nodes = surface_nodes(mesh_, surface);
  Vector3 mean = {};
  for (const auto node : nodes)
    for (int d = 0; d < 3; ++d)
      mean[d] += state.displacement[3 * node + d] / nodes.size();
  return mean;
}

} // namespace ballonet::tests
