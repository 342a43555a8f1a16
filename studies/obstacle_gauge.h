// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/measurement.h"

namespace ballonet::studies
{

/// How hard an actuator presses on its rigid bodies: columns NAME_force_N, size of the sum of all contact forces on
/// each of them, friction included; those of the whole actuator also in a half model.
class ObstacleGauge : public Gauge
{
public:
  ObstacleGauge(const solver::Parameters &parameters, bool symmetric);
  void measure(const solver::PathPoint &point, const solver::Equilibrium &equilibrium, Row &row) override;

private:
  struct Obstacle {
    std::string column;
    std::size_t pair; ///< contact pair
  };
  std::vector<Obstacle> obstacles_;
  bool symmetric_;
};

/// The column of a rigid body.
std::string force_column(const solver::RigidBody &body);

} // namespace ballonet::studies
