// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/summary.h"
#include "studies/judgement_format.h"
#include "studies/paired_model.h"
#include "studies/version.h"
#include <cmath>
#include <nlohmann/json.hpp>

namespace ballonet::studies
{
namespace
{

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// Where the two models differ.
Json disagreements_of(const optimize::Evaluation &evaluation)
{
  Json json = Json::object();
  for (const Disagreement &d : disagreements(evaluation))
    json[d.response] = {{"fem", number(d.fem)}, {"reduced", number(d.reduced)}};
  return json;
}

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
    json["responses"][name] = number(value);
  if (const Judgement *judgement = format.judgement(best.hash))
    json["judgement"] = json_of(*judgement);
  if (study.study().method.model == ModelKind::both)
    json["disagreements"] = disagreements_of(best);
  return json;
}

Json counts_of(const optimize::Result &result)
{
  Json counts = Json::object();
  for (const auto &[status, count] : result.counts.by_status)
    counts[std::string(optimize::word_of(status))] = count;
  return counts;
}

Json classes_of(const optimize::Result &result, const JournalFormat &format)
{
  Json classes = Json::object();
  for (const optimize::Evaluation &evaluation : result.evaluations)
    if (const Judgement *judgement = format.judgement(evaluation.hash)) {
      const std::string word = word_of(judgement->path_class);
      classes[word] = classes.value(word, 0) + 1;
    }
  return classes;
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
  json["classes"] = classes_of(result, format);
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
