// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/forward_model.h"
#include "studies/journal_format.h"
#include "studies/results_directory.h"

namespace ballonet::studies
{

/// The reduced model of a PEBS as a forward model. It leaves the same record of a design as the simulation, in the same
/// places, without mesh and fields. Rank 0 computes alone: a design takes milliseconds.
class ReducedModel : public optimize::ForwardModel
{
public:
  /// All must outlive this object.
  ReducedModel(const StudyFile &study, ResultsDirectory &directory, JournalFormat &format);

  std::vector<optimize::Evaluation> evaluate(const std::vector<optimize::Design> &designs,
                                             const optimize::OnFinished &on_finished) override;
  std::size_t batch_size() const override { return 1; }
  std::string content_hash(const optimize::Design &design) const override;

private:
  optimize::Evaluation compute(const optimize::Design &design);

  const StudyFile &study_;
  ResultsDirectory &directory_;
  JournalFormat &format_;
};

} // namespace ballonet::studies
