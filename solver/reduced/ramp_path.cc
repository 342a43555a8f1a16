// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/ramp_path.h"
#include "solver/reduced/chain_inertia.h"
#include "solver/reduced/path_events.h"
#include <algorithm>
#include <cmath>

namespace ballonet::solver::reduced
{
namespace
{

/// The actuator in motion.
class Motion
{
public:
  Motion(const PebsModel &model, Angles rest)
      : model_(model), control_(model.parameters().ramp), velocity_(rest.size(), 0.0), lever_(model.hinge().lever)
  {
    state_.al = std::move(rest);
    state_.outer_radius = 1.001 * model.parameters().balloon.diameter / 2;
  }

  const State &state() const { return state_; }

  /// One time step.
  void advance()
  {
    state_.pressure = control_.pressure_rate * n_steps_ * control_.step;
    state_.axial_stretch = model_.stretch(state_.al.back(), 0);
    inflate();
    swing();
    state_.angle = state_.al.back();
    state_.time = ++n_steps_ * control_.step;
  }

  /// False once the last step has turned a unit further than a time step can follow, or a value is not finite.
  bool is_sound() const
  {
    constexpr double largest_turn = 0.2; // rad; the fastest snap of the default actuator makes 0.015
    return std::all_of(velocity_.begin(), velocity_.end(),
                       [&](double v) { return std::abs(v) * control_.step <= largest_turn; }) &&
           std::isfinite(state_.outer_radius) && model_.stretch(state_.angle, 0) > 0;
  }

private:
  void inflate()
  {
    const double z = state_.axial_stretch, cage = model_.parameters().ribs.inner_radius;
    constexpr int n_substeps = 4;
    const double mobility = control_.radial_mobility * control_.step / n_substeps;
    double &b = state_.outer_radius;
    for (int i = 0; i < n_substeps; ++i) {
      const double unbalanced = state_.pressure - model_.tube().pressure(z, b);
      b += mobility * unbalanced / (1 + mobility * model_.tube().pressure_per_radius(z, b));
      b = std::min(b, cage);
    }
    state_.touches_ribs = b >= cage;
    state_.contact_pressure = state_.pressure - model_.tube().pressure(z, b);
    state_.thrust = std::max(0.0, model_.tube().thrust(z, b, state_.touches_ribs ? state_.contact_pressure : 0));
    state_.balloon_stiffness = model_.balloon_stiffness(z, b);
  }

  void swing()
  {
    const RibChain &chain = model_.chain();
    const std::size_t n = chain.size();
    Inertia moving = inertia(chain, state_.al, velocity_);
    std::vector<double> force = chain.residual(state_.al, model_.hinge().stiffness() + state_.balloon_stiffness);
    for (std::size_t i = 0; i < n; ++i)
      force[i] = -force[i] - moving.velocity[i];
    force.back() += state_.thrust * lever_;
    damp(moving.mass, force);
    const std::vector<double> acceleration = solve_positive(moving.mass, std::move(force));
    for (std::size_t i = 0; i < n; ++i) {
      velocity_[i] += control_.step * acceleration[i];
      state_.al[i] += control_.step * velocity_[i];
    }
  }

  /// Takes C v from the forces and makes M + dt C of M.
  void damp(SymmetricMatrix &M, std::vector<double> &force) const
  {
    const std::size_t n = force.size();
    const double c = control_.hinge_damping * model_.hinge().stiffness(), dt = control_.step;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const double hinges = i == j ? (i + 1 < n ? 2 * c : c) : i == j + 1 ? -c : 0;
        const double C = control_.mass_damping * M(i, j) + hinges;
        force[i] -= C * velocity_[j];
        force[j] -= i == j ? 0 : C * velocity_[i];
        M(i, j) += dt * C;
      }
  }

  const PebsModel &model_;
  const Ramp &control_;
  State state_;
  std::vector<double> velocity_; // rad/s
  double lever_;
  int n_steps_ = 0;
};

void add_row(Path &path, const PebsModel &model, State state)
{
  model.judge(state, path.rows.empty() ? Stage::separation : path.rows.back().stage);
  path.rows.push_back(std::move(state));
}

} // namespace

Path ramp_path(const PebsModel &model)
{
  const Ramp &control = model.parameters().ramp;
  Path path;
  auto rest = model.chain().droop(model.hinge().stiffness());
  if (!rest) {
    path.ending = Ending::no_droop;
    path.reason = "no stable droop of the backbone with the balloon";
    return path;
  }
  Motion motion(model, std::move(*rest));
  const long n_steps = std::lround(std::ceil(control.duration / control.step - 1e-6));
  for (long i = 0; i < n_steps && motion.state().angle < control.stop_angle; ++i) {
    motion.advance();
    if (!motion.is_sound()) {
      path.ending = Ending::diverged;
      path.reason = "the motion diverged at " + std::to_string(motion.state().time) + " s";
      break;
    }
    if (i % control.steps_per_row == 0 || i + 1 == n_steps || motion.state().angle >= control.stop_angle)
      add_row(path, model, motion.state());
  }
  path.events = find_events(path.rows, model, PathKind::ramp);
  return path;
}

} // namespace ballonet::solver::reduced
