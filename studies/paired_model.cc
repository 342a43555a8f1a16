// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/paired_model.h"
#include "studies/reduced_path.h"
#include "studies/response_names.h"
#include <algorithm>
#include <cmath>

namespace ballonet::studies
{
namespace
{

/// Whether two responses differ; two that are not finite are alike.
bool differ(double a, double b, double share)
{
  if (!std::isfinite(a) || !std::isfinite(b))
    return std::isfinite(a) != std::isfinite(b);
  constexpr double round_off = 1e-6; // in the response's unit: what is not there
  return std::abs(a - b) > std::max(round_off, share * std::max(std::abs(a), std::abs(b)));
}

} // namespace

PairedModel::PairedModel(const StudyFile &study, ResultsDirectory &directory, JournalFormat &format,
                         const RankGroups &groups)
    : study_(study), directory_(directory), format_(format), fem_(study, &directory, format, groups)
{
}

std::vector<optimize::Evaluation> PairedModel::evaluate(const std::vector<optimize::Design> &designs,
                                                        const optimize::OnFinished &on_finished)
{
  std::map<optimize::Design, optimize::Evaluation> finished;
  fem_.evaluate(designs, [&](const optimize::Evaluation &evaluation) {
    on_finished(finished.emplace(evaluation.design, with_reduced(evaluation)).first->second);
  });
  std::vector<optimize::Evaluation> result;
  for (const optimize::Design &design : designs)
    result.push_back(finished.at(design));
  return result;
}

optimize::Evaluation PairedModel::with_reduced(optimize::Evaluation evaluation) const
{
  Study study = study_.with(evaluation.design);
  study.method.model = ModelKind::reduced;
  const auto folder = directory_.folder(format_.origin(evaluation.hash).number) / "reduced";
  std::filesystem::create_directories(folder);
  const EvaluationOutcome outcome = run_reduced_evaluation(study, folder);
  for (const auto &[name, value] : outcome.responses)
    evaluation.responses[reduced_prefix + name] = value;
  evaluation.seconds += outcome.seconds;
  return evaluation;
}

std::vector<Disagreement> disagreements(const optimize::Evaluation &evaluation, double share)
{
  std::vector<Disagreement> found;
  for (const auto &[name, value] : evaluation.responses)
    if (const auto reduced = evaluation.responses.find(reduced_prefix + name);
        reduced != evaluation.responses.end() && differ(value, reduced->second, share))
      found.push_back({name, value, reduced->second});
  return found;
}

} // namespace ballonet::studies
