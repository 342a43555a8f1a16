// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/path_responses.h"
#include "studies/response_names.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace ballonet::studies
{

double angle_at_pressure(const std::vector<Row> &rows, double pressure_kPa)
{
  for (const Row &row : rows) // the first row at or above is the first whose running maximum is
    if (value_of(row, "pressure_kPa") >= pressure_kPa)
      return value_of(row, "bending_angle_deg");
  return std::numeric_limits<double>::quiet_NaN();
}

std::map<std::string, double> responses_of(const Study &study, const std::vector<Row> &rows, bool complete,
                                           const std::optional<Judgement> &judgement)
{
  std::map<std::string, double> responses;
  if (rows.empty())
    return responses;
  for (const std::string &column : history_columns(study)) {
    double largest = -std::numeric_limits<double>::infinity(), smallest = -largest;
    for (const Row &row : rows) {
      largest = std::max(largest, value_of(row, column));
      smallest = std::min(smallest, value_of(row, column));
    }
    responses[column] = value_of(rows.back(), column);
    responses[column + "_max"] = largest;
    responses[column + "_min"] = smallest;
  }
  if (study.actuator.kind == ActuatorKind::pebs && study.actuator.pebs.with_balloon) {
    double &angle = responses["window_angle_deg"];
    angle = angle_at_pressure(rows, 1e3 * study.judge.window_max);
    if (std::isnan(angle) && complete)
      angle = value_of(rows.back(), "bending_angle_deg");
  }
  if (judgement)
    responses.merge(margins_of(*judgement));
  return responses;
}

} // namespace ballonet::studies
