// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/path_events.h"
#include "solver/reduced/root.h"
#include <algorithm>
#include <limits>

namespace ballonet::solver::reduced
{
namespace
{

Event event_of(EventKind kind, const State &state) { return {kind, state.pressure, state.angle}; }

/// The limit near row i, whose pressure is above its neighbours'.
Event refined_limit(const std::vector<State> &rows, std::size_t i, const PebsModel &model)
{
  const auto pressure = [&](double angle) {
    const auto state = model.state_at(angle, rows[i]);
    return state ? state->pressure : -std::numeric_limits<double>::infinity();
  };
  const double angle = find_maximum(pressure, rows[i - 1].angle, rows[i + 1].angle);
  const auto state = model.state_at(angle, rows[i]);
  return event_of(EventKind::limit, state ? *state : rows[i]);
}

/// First contact between row i - 1, before, and row i, by bisection.
Event refined_contact(const std::vector<State> &rows, std::size_t i, const PebsModel &model)
{
  State touching = rows[i];
  double free_angle = rows[i - 1].angle;
  for (int n = 0; n < 25; ++n) {
    const double angle = (free_angle + touching.angle) / 2;
    const auto state = model.state_at(angle, touching);
    if (state && state->touches_ribs)
      touching = *state;
    else
      free_angle = angle;
  }
  return event_of(EventKind::rib_contact, touching);
}

/// Where the head angle passes zero between two rows.
Event passing_upright(const State &a, const State &b)
{
  const double share = -a.angle / (b.angle - a.angle);
  return {EventKind::upright, a.pressure + share * (b.pressure - a.pressure), 0};
}

bool is_new(const std::vector<Event> &events, EventKind kind)
{
  return std::none_of(events.begin(), events.end(), [&](const Event &e) { return e.kind == kind; });
}

} // namespace

std::string word_of(EventKind kind)
{
  switch (kind) {
  case EventKind::head_contact:
    return "head_contact";
  case EventKind::upright:
    return "upright";
  case EventKind::limit:
    return "limit";
  case EventKind::rib_contact:
    return "rib_contact";
  case EventKind::bulged:
    return "bulged";
  case EventKind::ran_out:
    return "ran_out";
  }
  return {};
}

std::vector<Event> find_events(const std::vector<State> &rows, const PebsModel &model, PathKind kind)
{
  const bool is_static = kind == PathKind::quasi_static;
  std::vector<Event> events;
  const auto once = [&](EventKind event, bool happens, const auto &make) {
    if (happens && is_new(events, event))
      events.push_back(make());
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const State &row = rows[i];
    const auto here = [&](EventKind event) { return [&row, event] { return event_of(event, row); }; };
    once(EventKind::head_contact, row.stage > Stage::separation, here(EventKind::head_contact));
    once(EventKind::upright, i > 0 && rows[i - 1].angle < 0 && row.angle >= 0,
         [&] { return passing_upright(rows[i - 1], row); });
    once(EventKind::rib_contact, row.touches_ribs,
         [&] { return is_static && i > 0 ? refined_contact(rows, i, model) : event_of(EventKind::rib_contact, row); });
    once(EventKind::bulged, row.bulge >= model.parameters().ribs.thickness, here(EventKind::bulged));
    once(EventKind::ran_out, row.bulge_ratio >= 1, here(EventKind::ran_out));
    const bool is_top =
        i > 0 && i + 1 < rows.size() && row.pressure > rows[i - 1].pressure && row.pressure >= rows[i + 1].pressure;
    if (is_static && is_top)
      events.push_back(refined_limit(rows, i, model));
  }
  return events;
}

} // namespace ballonet::solver::reduced
