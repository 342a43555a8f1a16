// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/obstacle_gauge.h"
#include <cmath>

namespace ballonet::studies
{

std::string force_column(const solver::RigidBody &body) { return body.name + "_force_N"; }

ObstacleGauge::ObstacleGauge(const solver::Parameters &parameters, bool symmetric) : symmetric_(symmetric)
{
  const auto &pairs = parameters.contact_pairs;
  for (const solver::RigidBody &body : parameters.rigid_bodies)
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (pairs[i].primary == std::vector{body.name})
        obstacles_.push_back({force_column(body), i});
}

void ObstacleGauge::measure(const solver::PathPoint &point, const solver::Equilibrium &equilibrium, Row &row)
{
  if (obstacles_.empty())
    return;
  const auto contacts = equilibrium.contacts().summaries(point.progress.state);
  for (const auto &[column, pair] : obstacles_) {
    const solver::Vector3 &force = contacts[pair].secondary_force;
    row.emplace_back(column, symmetric_ ? 2 * std::hypot(force[0], force[2]) // y is cancelled by the mirror image
                                        : std::hypot(force[0], force[1], force[2]));
  }
}

} // namespace ballonet::studies
