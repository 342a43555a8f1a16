// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/pebs_model.h"
#include "solver/reduced/root.h"
#include <algorithm>
#include <cmath>

namespace ballonet::solver::reduced
{
namespace
{

constexpr int max_iterations = 200;
constexpr double tolerance = 1e-10; // of k_b, from one iteration to the next

const Parameters &checked(const Parameters &parameters)
{
  check(parameters);
  return parameters;
}

} // namespace

PebsModel::PebsModel(const Parameters &parameters)
    : parameters_(checked(parameters)), hinge_(make_hinge(parameters)), tube_(parameters.balloon),
      chain_(parameters, hinge_, Load::with_balloon), gap_bulge_(parameters, hinge_.lever)
{
}

double PebsModel::stretch(double angle, double wall_lengthening) const
{
  return (parameters_.height() + hinge_.lever * angle + wall_lengthening) / tube_.length();
}

double PebsModel::wall_lengthening(double thrust) const
{
  return parameters_.ribs.count * std::max(thrust, 0.0) / hinge_.axial_stiffness;
}

double PebsModel::balloon_stiffness(double z, double b) const
{
  return tube_.bending_stiffness(z, b) * parameters_.ribs.count / tube_.length();
}

double PebsModel::natural_angle() const { return (tube_.length() - parameters_.height()) / hinge_.lever; }

/// From thrust and stretch to radius, pressures and k_b.
bool PebsModel::balance_tube(State &state) const
{
  const double cage = parameters_.ribs.inner_radius, z = state.axial_stretch;
  const double needed = state.thrust + tube_.reduced_force(z, cage); // of the contact, N
  state.touches_ribs = needed >= 0;
  const std::optional<double> b = state.touches_ribs ? cage : tube_.radius_at_thrust(z, state.thrust, cage);
  if (!b)
    return false;
  state.outer_radius = *b;
  state.contact_pressure = state.touches_ribs ? needed / (std::numbers::pi * cage * cage) : 0;
  state.pressure = tube_.pressure(z, *b) + state.contact_pressure;
  state.balloon_stiffness = balloon_stiffness(z, *b);
  return true;
}

/// Brings a state to the given angle by fixed point iteration over k_b, and over u_wall unless it is given.
bool PebsModel::settle(State &state, double angle, std::optional<double> given_lengthening) const
{
  state.angle = angle;
  for (int i = 0; i < max_iterations; ++i) {
    const double k_b = state.balloon_stiffness;
    auto held = chain_.hold(angle, hinge_.stiffness() + k_b, std::move(state.al));
    if (!held)
      return false;
    state.al = std::move(held->al);
    state.thrust = held->moment / hinge_.lever;
    state.axial_stretch = stretch(angle, given_lengthening.value_or(wall_lengthening(state.thrust)));
    if (state.axial_stretch <= 0 || !balance_tube(state))
      return false;
    if (std::abs(state.balloon_stiffness - k_b) <= tolerance * std::abs(k_b))
      return true;
  }
  return false;
}

State PebsModel::straight() const
{
  State state;
  state.al.assign(chain_.size(), 0.0);
  state.balloon_stiffness = balloon_stiffness(1, tube_.outer_radius_unloaded(1));
  return state;
}

std::optional<State> PebsModel::state_at(double angle) const { return state_at(angle, straight()); }

std::optional<State> PebsModel::state_at(double angle, const State &near) const
{
  State state = near;
  return settle(state, angle, {}) ? std::optional(std::move(state)) : std::nullopt;
}

std::optional<State> PebsModel::state_at_lengthening(double angle, double wall_lengthening, const State &near) const
{
  State state = near;
  return settle(state, angle, wall_lengthening) ? std::optional(std::move(state)) : std::nullopt;
}

void PebsModel::judge(State &state, Stage earlier) const
{
  const std::vector<double> th = state.gap_angle();
  const double widest = *std::max_element(th.begin(), th.end());
  state.bulge = state.outer_radius - parameters_.ribs.inner_radius;
  if (state.touches_ribs) {
    state.bulge_ratio = gap_bulge_.slip_ratio(state.pressure, state.axial_stretch, widest);
    state.bulge = gap_bulge_.slip_height(state.pressure, state.axial_stretch, widest);
  }
  Stage stage = Stage::separation;
  if (state.thrust > 0.02 * state.pressure * tube_.cross_section())
    stage = Stage::insufficient;
  if (state.touches_ribs)
    stage = state.bulge >= parameters_.ribs.thickness ? Stage::excessive : Stage::sufficient;
  state.stage = std::max(stage, earlier);
}

PebsModel::Forces PebsModel::forces_of(double thrust, bool touches_ribs) const
{
  const double moment = thrust * hinge_.lever;
  return {thrust, moment, moment / (parameters_.height() + parameters_.head.thickness), touches_ribs};
}

PebsModel::Forces PebsModel::confined_forces(double pressure, double angle) const
{
  const double z = stretch(angle, 0), cage = parameters_.ribs.inner_radius;
  return forces_of(tube_.thrust(z, cage, pressure - tube_.pressure(z, cage)), true);
}

PebsModel::Forces PebsModel::blocked_forces(double pressure, double angle) const
{
  const double z = stretch(angle, 0), cage = parameters_.ribs.inner_radius;
  if (pressure >= tube_.pressure(z, cage))
    return confined_forces(pressure, angle);
  const auto excess = [&](double b) { return tube_.pressure(z, b) - pressure; };
  const double b = find_root(excess, tube_.outer_radius_unloaded(z), cage);
  return forces_of(tube_.thrust(z, b, 0), false);
}

} // namespace ballonet::solver::reduced
