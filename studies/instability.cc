// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/instability.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ballonet::studies
{
namespace
{

using enum PathClass;

constexpr double kPa_per_MPa = 1e3;
constexpr std::array<const char *, 6> words = {
    "not_converged", "interaction_failure", "losing_control", "overload", "weak", "normal"};
constexpr std::array instabilities = {interaction_failure, losing_control, overload};

/// The first class the path is in.
PathClass class_of(const std::vector<Criterion> &criteria)
{
  for (const PathClass candidate : {interaction_failure, losing_control, overload, weak})
    if (margin_of(candidate, criteria) < 0)
      return candidate;
  return normal;
}

/// The criteria of its class that the path does not meet.
std::string evidence(const Judgement &judgement)
{
  std::string text;
  for (const Criterion &criterion : judgement.criteria)
    if (criterion.leads_to == judgement.path_class && criterion.margin < 0)
      text += (text.empty() ? "" : "; ") + words_of(criterion);
  return text;
}

/// The instability a stable path is nearest to.
std::string nearest(const Judgement &judgement)
{
  for (const PathClass other : instabilities)
    if (judgement.margin(other) == judgement.margin())
      return "nearest " + word_of(other) + ", margin " + rounded_text(judgement.margin());
  return "no instability could be judged";
}

std::string reason_of(const Judgement &judgement, const PathState &last, const Judge &judge, const PathEnd &end)
{
  const std::string state = rounded_text(last.angle, "deg") + " at " + rounded_text(last.pressure, "kPa");
  std::string text = judgement.path_class == normal ? state : evidence(judgement);
  if (judgement.path_class == normal || judgement.path_class == weak)
    text += "; " + nearest(judgement);
  if (last.pressure < kPa_per_MPa * judge.window_max)
    text += "; the path ends before the window, with " + state + ": " + end.reason;
  return text;
}

} // namespace

std::string word_of(PathClass path_class) { return words.at(static_cast<std::size_t>(path_class)); }

PathClass path_class_of(const std::string &word)
{
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end())
    throw std::invalid_argument("there is no class \"" + word + "\" of paths");
  return static_cast<PathClass>(found - words.begin());
}

double Judgement::margin(PathClass other) const
{
  return path_class == not_converged ? std::numeric_limits<double>::quiet_NaN() : margin_of(other, criteria);
}

double Judgement::margin() const
{
  double smallest = std::numeric_limits<double>::quiet_NaN();
  for (const PathClass other : instabilities)
    smallest = std::fmin(smallest, margin(other));
  return smallest;
}

Judgement judge_path(const std::vector<Row> &rows, const Judge &judge, const JudgedActuator &actuator,
                     const PathEnd &end)
{
  Judgement judgement;
  judgement.reason = end.reason;
  const auto path = judged_part(rows, judge);
  if (path.empty()) {
    judgement.reason += "; no state in the pressure window";
    return judgement;
  }
  judgement.snaps = snap_throughs(path, judge.snap_drop);
  judgement.criteria = criteria_of(path, judgement.snaps, judge, actuator);
  if (end.numerical)
    return judgement;
  judgement.path_class = class_of(judgement.criteria);
  judgement.reason = reason_of(judgement, path.back(), judge, end);
  return judgement;
}

} // namespace ballonet::studies
