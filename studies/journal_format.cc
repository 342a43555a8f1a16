// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/journal_format.h"
#include "studies/judgement_format.h"
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace ballonet::studies
{
namespace
{

using Json = nlohmann::ordered_json;

optimize::Evaluation evaluation_of(const Json &json, const optimize::DesignSpace &space)
{
  optimize::Evaluation evaluation;
  evaluation.hash = json.at("hash");
  for (std::size_t i = 0; i < space.size(); ++i)
    evaluation.design.push_back(json.at("design").at(space.variable(i).key));
  evaluation.status = optimize::status_of(json.at("status").get<std::string>());
  evaluation.reason = json.at("reason");
  for (const auto &[name, value] : json.at("responses").items())
    evaluation.responses[name] = value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
  evaluation.seconds = json.at("seconds");
  return evaluation;
}

Json json_of(const CriticalRecord &point)
{
  Json json = {{"kind", point.kind}};
  for (const auto &[name, value] : point.facts)
    json[name] = value;
  return json;
}

CriticalRecord critical_record_of(const Json &json)
{
  CriticalRecord point = {json.at("kind"), {}};
  for (const auto &[name, value] : json.items())
    if (value.is_number())
      point.facts[name] = value;
  return point;
}

} // namespace

std::string JournalFormat::write(const optimize::Evaluation &evaluation) const
{
  const Origin &from = origin(evaluation.hash);
  Json json = {{"id", from.number}, {"hash", evaluation.hash}, {"design", Json::object()}, {"units", Json::object()}};
  for (std::size_t i = 0; i < space_.size(); ++i) {
    json["design"][space_.variable(i).key] = evaluation.design.at(i);
    json["units"][space_.variable(i).key] = space_.variable(i).unit;
  }
  json["status"] = optimize::word_of(evaluation.status);
  json["reason"] = evaluation.reason;
  json["responses"] = Json::object();
  for (const auto &[name, value] : evaluation.responses)
    json["responses"][name] = std::isfinite(value) ? Json(value) : Json(nullptr);
  json["seconds"] = evaluation.seconds;
  json["mesh_hash"] = from.mesh_hash;
  if (const Judgement *judged = judgement(evaluation.hash))
    json["judgement"] = json_of(*judged);
  if (const auto points = critical_points_.find(evaluation.hash); points != critical_points_.end())
    for (const CriticalRecord &point : points->second)
      json["critical_points"].push_back(json_of(point));
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

optimize::Evaluation JournalFormat::read(const std::string &line)
{
  try {
    const Json json = Json::parse(line);
    optimize::Evaluation evaluation = evaluation_of(json, space_);
    set_origin(evaluation.hash, {json.at("id").get<int>(), json.at("mesh_hash").get<std::string>()});
    if (json.contains("judgement"))
      set_judgement(evaluation.hash, judgement_of(json.at("judgement")));
    std::vector<CriticalRecord> points;
    for (const Json &point : json.value("critical_points", Json::array()))
      points.push_back(critical_record_of(point));
    set_critical_points(evaluation.hash, std::move(points));
    return evaluation;
  } catch (const Json::exception &e) {
    throw std::invalid_argument(std::string("not an evaluation of this study: ") + e.what());
  }
}

const Judgement *JournalFormat::judgement(const std::string &hash) const
{
  const auto found = judgements_.find(hash);
  return found == judgements_.end() ? nullptr : &found->second;
}

optimize::LineFormat JournalFormat::line_format()
{
  return {[this](const optimize::Evaluation &evaluation) { return write(evaluation); },
          [this](const std::string &line) { return read(line); }};
}

} // namespace ballonet::studies
