// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/pebs_path.h"
#include "solver/reduced/path_events.h"
#include <cmath>
#include <numeric>

namespace ballonet::solver::reduced
{
namespace
{

double degrees(double angle) { return angle * 180 / std::numbers::pi; }

/// The first state with a pressure of zero or more, looking upwards from the balloon's own length.
std::optional<State> first_state(const PebsModel &model)
{
  const StaticPath &path = model.parameters().static_path;
  for (double angle = model.natural_angle(); angle < path.stop_angle; angle += path.angle_step)
    if (auto state = model.state_at(angle))
      return state;
  return {};
}

/// Continues at equal angles; the last step ends at the stop.
void follow(const PebsModel &model, Path &path)
{
  const StaticPath &control = model.parameters().static_path;
  while (path.rows.back().angle < control.stop_angle * (1 - 1e-12)) {
    const State &last = path.rows.back();
    const double angle = std::min(last.angle + control.angle_step, control.stop_angle);
    auto state = model.state_at(angle, last);
    if (!state) {
      path.ending = Ending::no_equilibrium;
      path.reason = "no equilibrium found at " + std::to_string(degrees(angle)) + " deg";
      return;
    }
    model.judge(*state, last.stage);
    path.rows.push_back(std::move(*state));
  }
}

} // namespace

Answers answers(const PebsModel &model, double window)
{
  const Parameters &p = model.parameters();
  const double k = model.hinge().stiffness();
  const RibChain backbone(p, model.hinge(), Load::backbone);
  Answers result;
  result.hinge_stiffness = k;
  result.lever = model.hinge().lever;
  result.self_weight_number = self_weight_number(backbone, k, p.gravity);
  result.overload_index = 3 * p.balloon.c10 * p.balloon.wall / ((p.balloon.diameter - p.balloon.wall) * window);
  result.free_limit = model.tube().limit();
  if (const auto al = backbone.droop(k))
    result.backbone_droop = al->back();
  if (const auto al = model.chain().droop(k))
    result.droop = al->back();
  return result;
}

double participation_number(const Angles &al)
{
  const std::vector<double> th = gap_angles(al);
  const double sum = std::accumulate(th.begin(), th.end(), 0.0);
  return sum * sum / (static_cast<double>(th.size()) * std::inner_product(th.begin(), th.end(), th.begin(), 0.0));
}

Path static_path(const PebsModel &model)
{
  Path path;
  const RibChain backbone(model.parameters(), model.hinge(), Load::backbone);
  if (!backbone.droop(model.hinge().stiffness())) {
    path.ending = Ending::no_droop;
    path.reason = "no stable droop of the backbone";
    return path;
  }
  if (auto first = first_state(model)) {
    model.judge(*first, Stage::separation);
    path.rows.push_back(std::move(*first));
    follow(model, path);
  } else {
    path.ending = Ending::no_equilibrium;
    path.reason = "no equilibrium at zero pressure below the stop";
  }
  path.events = find_events(path.rows, model, PathKind::quasi_static);
  return path;
}

std::optional<Event> Path::first(EventKind kind) const
{
  for (const Event &event : events)
    if (event.kind == kind)
      return event;
  return {};
}

std::optional<double> Path::angle_at(double pressure) const
{
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].pressure < pressure)
      continue;
    if (i == 0)
      return rows[0].angle;
    const State &a = rows[i - 1], &b = rows[i]; // every row before lies below
    return a.angle + (b.angle - a.angle) * (pressure - a.pressure) / (b.pressure - a.pressure);
  }
  return ending == Ending::complete && !rows.empty() ? std::optional(rows.back().angle) : std::nullopt;
}

} // namespace ballonet::solver::reduced
