// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/measurement.h"

namespace ballonet::studies
{

/// step, time_s, control (V / V0, kPa or load factor, as the path is driven), load_factor, state (equilibrium or
/// moving).
class ControlGauge : public Gauge
{
public:
  explicit ControlGauge(solver::Control control) : control_(control) {}
  void measure(const solver::PathPoint &point, const solver::Equilibrium &, Row &row) override;

private:
  solver::Control control_;
};

/// pressure_kPa, volume_mm3, volume_ratio of the cavity; `copies` of the meshed part make up the whole.
class CavityGauge : public Gauge
{
public:
  explicit CavityGauge(int copies) : copies_(copies) {}
  void measure(const solver::PathPoint &point, const solver::Equilibrium &, Row &row) override;

private:
  int copies_;
};

/// How the step was found: negative_eigenvalues and, with a cavity, negative_eigenvalues_held_volume,
/// newton_iterations, factorisations and cuts since the last step, residual, penetration_mm, with augmented contact
/// mean_penetration_mm, dissipated_share, kinetic_share.
class NumericsGauge : public Gauge
{
public:
  void measure(const solver::PathPoint &point, const solver::Equilibrium &, Row &row) override;
  void go_on_after(const Row &) override { fresh_ = true; }

private:
  int cuts_ = 0, factorisations_ = 0;
  bool fresh_ = false; ///< the attempts before the next step are not known
};

} // namespace ballonet::studies
