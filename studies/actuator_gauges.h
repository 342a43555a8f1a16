// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/measurement.h"
#include "studies/pebs_measures.h"
#include <set>

namespace ballonet::studies
{

/// axial_ratio, radial_ratio, balloon_stress_max_MPa of a balloon alone.
class BalloonShapeGauge : public Gauge
{
public:
  BalloonShapeGauge(const SimulationModel &model, bool symmetric);
  void measure(const solver::PathPoint &point, const solver::Equilibrium &equilibrium, Row &row) override;

private:
  const SimulationModel &model_;
  BalloonGauge balloon_;
};

/// The columns of a PEBS: angles, tip, forces, balloon, stresses, bulge, contact, gaps. Forces are those of the whole
/// actuator, also in a half model.
class PebsShapeGauge : public Gauge
{
public:
  PebsShapeGauge(const SimulationModel &model, bool symmetric, double rib_arc_share, MPI_Comm communicator);
  void measure(const solver::PathPoint &point, const solver::Equilibrium &equilibrium, Row &row) override;
  void go_on_after(const Row &row) override { angle_ = value_of(row, "bending_angle_deg"); }

private:
  struct Touch {
    double head_force = 0;   ///< N, normal force between balloon and head disc
    double rib_fraction = 0; ///< share of ribs touched
  };
  Touch touch(const solver::State &state, const solver::Equilibrium &equilibrium) const;
  double tip_force(const solver::State &state, const solver::Equilibrium &equilibrium) const;

  const SimulationModel &model_;
  PebsGauge gauge_;
  double copies_; ///< of the meshed part that make up the whole
  double rib_arc_share_;
  MPI_Comm communicator_;
  std::vector<std::uint32_t> head_top_;
  std::set<std::pair<std::uint32_t, std::uint32_t>> head_faces_;
  std::vector<std::vector<std::uint32_t>> rib_cells_;
  double angle_ = 0; ///< last bending angle, deg
};

} // namespace ballonet::studies
