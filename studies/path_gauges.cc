// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/path_gauges.h"
#include "studies/word_columns.h"
#include <algorithm>

namespace ballonet::studies
{
namespace
{

constexpr double kPa_per_MPa = 1e3;

double volume_ratio(const solver::PathPoint &point) { return point.progress.volume / point.reference_volume; }

} // namespace

void ControlGauge::measure(const solver::PathPoint &point, const solver::Equilibrium &, Row &row)
{
  const solver::PathProgress &progress = point.progress;
  row.emplace_back("step", progress.step);
  row.emplace_back("time_s", progress.state.time);
  if (control_ == solver::Control::volume)
    row.emplace_back("control", volume_ratio(point));
  else if (control_ == solver::Control::load)
    row.emplace_back("control", progress.state.load_factor);
  else if (control_ == solver::Control::release)
    row.emplace_back("control", progress.state.time);
  else
    row.emplace_back("control", kPa_per_MPa * progress.state.pressure);
  row.emplace_back("load_factor", progress.state.load_factor);
  row.emplace_back(state_column, point.at_rest);
}

void CavityGauge::measure(const solver::PathPoint &point, const solver::Equilibrium &, Row &row)
{
  row.emplace_back("pressure_kPa", kPa_per_MPa * point.progress.state.pressure);
  row.emplace_back("volume_mm3", copies_ * point.progress.volume);
  row.emplace_back("volume_ratio", volume_ratio(point));
}

void NumericsGauge::measure(const solver::PathPoint &point, const solver::Equilibrium &equilibrium, Row &row)
{
  const int cuts = fresh_ ? 0 : point.progress.cuts - cuts_;
  const int factorisations = fresh_ ? point.newton.factorisations : point.progress.factorisations - factorisations_;
  cuts_ = point.progress.cuts;
  factorisations_ = point.progress.factorisations;
  fresh_ = false;
  row.emplace_back("negative_eigenvalues", point.stability.negative_pivots);
  if (equilibrium.has_cavity())
    row.emplace_back("negative_eigenvalues_held_volume", point.stability.at_held_volume());
  row.emplace_back("newton_iterations", point.newton.iterations());
  row.emplace_back("factorisations", factorisations);
  row.emplace_back("cuts", cuts);
  row.emplace_back("residual", point.newton.residuals.back());
  if (const auto contacts = equilibrium.contacts().summaries(point.progress.state); !contacts.empty()) {
    double deepest = 0;
    for (const solver::ContactSummary &contact : contacts)
      deepest = std::max(deepest, contact.penetration);
    row.emplace_back("penetration_mm", deepest);
  }
  if (equilibrium.contacts().augmentation().n_shifts() > 0)
    row.emplace_back("mean_penetration_mm", point.newton.mean_penetration);
  row.emplace_back("dissipated_share", point.dissipated_share);
  row.emplace_back("kinetic_share", point.kinetic_share);
}

} // namespace ballonet::studies
