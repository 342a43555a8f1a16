// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/measurement.h"

namespace ballonet::studies
{

/// The [[response]] blocks of a problem, one column each, in N, mm, MPa and mm^3 of the mesh as it is.
class ResponseGauge : public Gauge
{
public:
  /// Throws std::invalid_argument for a surface, body or pair that does not exist.
  explicit ResponseGauge(const SimulationModel &model);
  void measure(const solver::PathPoint &point, const solver::Equilibrium &equilibrium, Row &row) override;

private:
  struct Target {
    solver::Response response;
    std::vector<std::uint32_t> nodes; ///< of displacement, position and reaction
    std::size_t pair = 0;             ///< of contact_force
  };
  double value(const Target &target, const solver::PathPoint &point, const solver::Equilibrium &equilibrium) const;

  const SimulationModel &model_;
  std::vector<Target> targets_;
};

} // namespace ballonet::studies
