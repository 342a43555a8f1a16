// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/summary.h"
#include "studies/version.h"
#include <cmath>
#include <nlohmann/json.hpp>

namespace ballonet::studies
{
namespace
{

using Json = nlohmann::ordered_json;

Json best_of(const optimize::Result &result, const StudyFile &study, const JournalFormat &format)
{
  if (!result.best)
    return nullptr;
  const optimize::Evaluation &best = *result.best;
  Json json = {{"id", format.origin(best.hash).number},
               {"hash", best.hash},
               {"design", Json::object()},
               {"responses", Json::object()},
               {"feasible", result.feasible}};
  for (std::size_t i = 0; i < study.space().size(); ++i)
    json["design"][study.space().variable(i).key] = best.design.at(i);
  for (const auto &[name, value] : best.responses)
    json["responses"][name] = std::isfinite(value) ? Json(value) : Json(nullptr);
  return json;
}

Json counts_of(const optimize::Result &result)
{
  Json counts = Json::object();
  for (const auto &[status, count] : result.counts.by_status)
    counts[std::string(optimize::word_of(status))] = count;
  return counts;
}

} // namespace

std::string summary_text(const Summary &summary, const StudyFile &file, const JournalFormat &format)
{
  const Study &study = file.study();
  const optimize::Result &result = summary.result;
  Json json = {{"study", study.title.name},
               {"question", study.title.question},
               {"status", summary.status},
               {"reason", summary.reason},
               {"best", best_of(result, file, format)}};
  if (study.objective)
    json["objective"] = {{"response", study.objective->response},
                         {"goal", study.objective->goal == optimize::Goal::maximize ? "maximize" : "minimize"}};
  json["counts"] = counts_of(result);
  json["evaluations"] = result.counts.total;
  json["replayed"] = result.counts.replayed;
  json["unusable"] = result.counts.unusable;
  json["substituted"] = result.counts.substituted;
  json["discrete_treatment"] = result.discrete_treatment;
  json["failure_treatment"] = result.failure_treatment;
  json["wall_seconds"] = summary.wall_seconds;
  json["version"] = version_text();
  json["commit"] = commit_text();
  json["ranks"] = summary.ranks;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace ballonet::studies
