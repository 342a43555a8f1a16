// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/reduced_model.h"
#include "studies/content_hash.h"
#include "studies/reduced_path.h"

namespace ballonet::studies
{

ReducedModel::ReducedModel(const StudyFile &study, ResultsDirectory &directory, JournalFormat &format)
    : study_(study), directory_(directory), format_(format)
{
}

std::string ReducedModel::content_hash(const optimize::Design &design) const
{
  return studies::content_hash(study_.with(design));
}

std::vector<optimize::Evaluation> ReducedModel::evaluate(const std::vector<optimize::Design> &designs,
                                                         const optimize::OnFinished &on_finished)
{
  std::vector<optimize::Evaluation> evaluations;
  for (const optimize::Design &design : designs) {
    evaluations.push_back(compute(design));
    on_finished(evaluations.back());
  }
  return evaluations;
}

optimize::Evaluation ReducedModel::compute(const optimize::Design &design)
{
  const Study study = study_.with(design);
  const std::string hash = studies::content_hash(study);
  const int number = directory_.number_of(hash);
  directory_.begin(number, hash, study);
  return recorded_evaluation(format_, hash, design, number, run_reduced_evaluation(study, directory_.folder(number)));
}

} // namespace ballonet::studies
