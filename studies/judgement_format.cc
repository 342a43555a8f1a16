// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/judgement_format.h"
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

namespace ballonet::studies
{
namespace
{

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

double number_of(const Json &json)
{
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

Json json_of(const Criterion &criterion)
{
  return {{"name", criterion.name},           {"class", word_of(criterion.leads_to)}, {"what", criterion.what},
          {"value", number(criterion.value)}, {"limit", number(criterion.limit)},     {"unit", criterion.unit},
          {"at_most", criterion.at_most},     {"margin", number(criterion.margin)}};
}

Criterion criterion_of(const Json &json)
{
  return {json.at("name"),
          path_class_of(json.at("class")),
          json.at("what"),
          number_of(json.at("value")),
          number_of(json.at("limit")),
          json.at("unit"),
          json.at("at_most"),
          number_of(json.at("margin"))};
}

Json json_of(const SnapSide &side)
{
  return {{"pressure_kPa", number(side.pressure)},
          {"angle_deg", number(side.angle)},
          {"volume_mm3", number(side.volume)},
          {"bulge_mm", number(side.bulge)}};
}

SnapSide side_of(const Json &json)
{
  return {number_of(json.at("pressure_kPa")), number_of(json.at("angle_deg")), number_of(json.at("volume_mm3")),
          number_of(json.at("bulge_mm"))};
}

} // namespace

Json json_of(const Judgement &judgement)
{
  Json json = {{"class", word_of(judgement.path_class)},
               {"reason", judgement.reason},
               {"stage", judgement.stage},
               {"criteria", Json::array()},
               {"snap_throughs", Json::array()}};
  for (const Criterion &criterion : judgement.criteria)
    json["criteria"].push_back(json_of(criterion));
  for (const SnapThrough &snap : judgement.snaps)
    json["snap_throughs"].push_back(
        {{"before", json_of(snap.before)}, {"after", json_of(snap.after)}, {"recovered", snap.recovered}});
  return json;
}

Judgement judgement_of(const Json &json)
{
  Judgement judgement;
  judgement.path_class = path_class_of(json.at("class"));
  judgement.reason = json.at("reason");
  judgement.stage = json.at("stage");
  for (const Json &criterion : json.at("criteria"))
    judgement.criteria.push_back(criterion_of(criterion));
  for (const Json &snap : json.at("snap_throughs"))
    judgement.snaps.push_back({side_of(snap.at("before")), side_of(snap.at("after")), snap.at("recovered")});
  return judgement;
}

} // namespace ballonet::studies
