// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/instability_criteria.h"
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace ballonet::studies
{
namespace
{

using enum PathClass;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double margin_below(double value, double limit) { return (limit - value) / (limit > 0 ? limit : 1); }

Criterion at_most(const char *name, PathClass leads_to, const char *what, double value, double limit,
                  const char *unit = "")
{
  return {name, leads_to, what, value, limit, unit, true, margin_below(value, limit)};
}

Criterion at_least(const char *name, PathClass leads_to, const char *what, double value, double limit,
                   const char *unit = "")
{
  return {name, leads_to, what, value, limit, unit, false, -margin_below(value, limit)};
}

/// The largest of a number over a path, NaN without numbers.
template <class Number>
double largest(const std::vector<PathState> &path, const Number &number)
{
  double result = none;
  for (const PathState &state : path)
    result = std::fmax(result, number(state));
  return result;
}

/// (sum theta)^2 / (N sum theta^2): 1 if all gaps open alike, 1 / N if only one does.
double participation(const std::vector<double> &gaps)
{
  double sum = 0, squares = 0;
  for (const double gap : gaps) {
    sum += gap;
    squares += gap * gap;
  }
  return sum * sum / (static_cast<double>(gaps.size()) * squares);
}

double largest_over_mean(const std::vector<double> &gaps)
{
  if (gaps.empty())
    return none;
  const double mean = std::accumulate(gaps.begin(), gaps.end(), 0.) / static_cast<double>(gaps.size());
  return *std::max_element(gaps.begin(), gaps.end()) / mean;
}

/// Largest fall of the angle below its running maximum from the first state on that touches enough ribs.
double largest_fall(const std::vector<PathState> &path, double contact_share)
{
  double fall = none, highest = none;
  for (const PathState &state : path)
    if (!std::isnan(highest) || state.touched_share >= contact_share) {
      highest = std::fmax(highest, state.angle);
      fall = std::fmax(fall, highest - state.angle);
    }
  return fall;
}

/// The balloon runs out of the cage through few gaps: past a limit point, outside and localised, all three at once. Of
/// the states past a limit point the worst is taken, and of its two distances the larger.
Criterion runaway(const std::vector<PathState> &path, const Judge &judge, double escape)
{
  Criterion worst = at_most("localisation_index", interaction_failure,
                            "largest over mean bulge of the gaps past a limit point", none, judge.localisation_index);
  for (const PathState &state : path) {
    if (!state.past_limit)
      continue;
    const double margin =
        std::max(margin_below(state.localisation, judge.localisation_index), margin_below(state.bulge, escape));
    if (std::isnan(worst.margin) || margin < worst.margin) {
      worst.value = state.localisation;
      worst.margin = margin;
    }
  }
  return worst;
}

/// The largest bulge behind a snap-through that began with a balloon inside the cage.
double bulge_after_snap(const std::vector<SnapThrough> &snaps, double escape)
{
  double bulge = none;
  for (const SnapThrough &snap : snaps)
    if (snap.before.bulge <= escape)
      bulge = std::fmax(bulge, snap.after.bulge);
  return bulge;
}

std::vector<Criterion> interaction_criteria(const std::vector<PathState> &path, const std::vector<SnapThrough> &snaps,
                                            const Judge &judge, const JudgedActuator &actuator)
{
  const double escape = judge.escape_bulge * actuator.rib_thickness;
  const double outside = judge.bulge_limit * (actuator.rib_thickness + actuator.rib_width);
  const auto bulge = [](const PathState &state) { return state.bulge; };
  const auto opening = [&](const PathState &state) { return state.rib_opening / actuator.cage_radius; };
  return {at_most("bulge_limit", interaction_failure, "bulge of the balloon", largest(path, bulge), outside, "mm"),
          runaway(path, judge, escape),
          at_most("rib_opening", interaction_failure, "opening of a rib over the cage's radius", largest(path, opening),
                  judge.rib_opening),
          at_most("escape_bulge", interaction_failure, "bulge behind a snap-through", bulge_after_snap(snaps, escape),
                  escape, "mm")};
}

std::vector<Criterion> control_criteria(const std::vector<PathState> &path, const Judge &judge)
{
  const bool touches = largest(path, [](const PathState &state) { return state.touched_share; }) > 0;
  const auto widest = [&](const PathState &state) {
    return state.angle > judge.gap_ratio_angle ? largest_over_mean(state.gaps) : none;
  };
  const auto droop = [](const PathState &state) { return -state.angle; };
  return {
      at_least("participation", losing_control, "participation of the gaps",
               touches ? participation(path.back().gaps) : none, judge.participation),
      at_most("gap_ratio", losing_control, "widest gap over the mean", largest(path, widest), judge.gap_ratio),
      at_most("angle_fall", losing_control, "fall of the angle after rib contact",
              largest_fall(path, judge.contact_share), judge.angle_fall, "deg"),
      at_most("droop_angle", losing_control, "droop", std::fmax(0, largest(path, droop)), judge.droop_angle, "deg")};
}

std::vector<Criterion> inflation_criteria(const PathState &end, const Judge &judge, const JudgedActuator &actuator)
{
  const char *const angle = "bending angle";
  return {at_least("overload_angle", overload, angle, end.angle, judge.overload_angle, "deg"),
          at_most("overload_index", overload, "limit pressure of the balloon over the window's end",
                  actuator.limit_pressure / judge.window_max, judge.overload_index),
          at_least("overload_radius", overload, "mean radius of the balloon over the cage's",
                   end.radial_ratio * actuator.balloon_radius / actuator.cage_radius, judge.overload_radius),
          at_least("normal_angle", weak, angle, end.angle, judge.normal_angle, "deg")};
}

double margin_named(const std::vector<Criterion> &criteria, const std::string &name)
{
  for (const Criterion &criterion : criteria)
    if (criterion.name == name)
      return criterion.margin;
  return none;
}

} // namespace

double tube_limit_pressure(double shear_modulus, double wall, double radius)
{
  return 0.75 * shear_modulus * wall / (radius - wall / 2);
}

std::vector<Criterion> criteria_of(const std::vector<PathState> &path, const std::vector<SnapThrough> &snaps,
                                   const Judge &judge, const JudgedActuator &actuator)
{
  std::vector<Criterion> criteria = interaction_criteria(path, snaps, judge, actuator);
  for (const auto &more : {control_criteria(path, judge), inflation_criteria(path.back(), judge, actuator)})
    criteria.insert(criteria.end(), more.begin(), more.end());
  return criteria;
}

double margin_of(PathClass path_class, const std::vector<Criterion> &criteria)
{
  if (path_class == normal || path_class == not_converged)
    throw std::invalid_argument("no criterion leads to this class");
  if (path_class == overload) {
    const double cause = std::fmin(margin_named(criteria, "overload_index"), margin_named(criteria, "overload_radius"));
    return std::fmax(margin_named(criteria, "overload_angle"), cause);
  }
  double smallest = none;
  for (const Criterion &criterion : criteria)
    if (criterion.leads_to == path_class)
      smallest = std::fmin(smallest, criterion.margin);
  return smallest;
}

std::string words_of(const Criterion &criterion)
{
  return criterion.what + " " + rounded_text(criterion.value, criterion.unit) +
         (criterion.at_most ? ", at most " : ", at least ") + rounded_text(criterion.limit, criterion.unit);
}

std::string rounded_text(double number, const std::string &unit)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", number);
  return unit.empty() ? text : text + (" " + unit);
}

} // namespace ballonet::studies
