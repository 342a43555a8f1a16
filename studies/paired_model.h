// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/fem_model.h"

namespace ballonet::studies
{

/// The simulation with the reduced model beside it. An evaluation is that of the simulation, with its status and
/// judgement; it has the responses of the reduced model too, with reduced_ before their names, also where the
/// simulation failed. The reduced model's files are in `reduced/` of the evaluation's folder.
class PairedModel : public optimize::ForwardModel
{
public:
  /// As for FemModel on rank 0; the other ranks serve an FemModel.
  PairedModel(const StudyFile &study, ResultsDirectory &directory, JournalFormat &format, const RankGroups &groups);

  std::vector<optimize::Evaluation> evaluate(const std::vector<optimize::Design> &designs,
                                             const optimize::OnFinished &on_finished) override;
  std::size_t batch_size() const override { return fem_.batch_size(); }
  std::string content_hash(const optimize::Design &design) const override { return fem_.content_hash(design); }

private:
  optimize::Evaluation with_reduced(optimize::Evaluation evaluation) const;

  const StudyFile &study_;
  const ResultsDirectory &directory_;
  const JournalFormat &format_;
  FemModel fem_;
};

/// A response both models have, with different values.
struct Disagreement {
  std::string response;
  double fem = 0, reduced = 0; ///< not a number: this model has none
};

/// The responses of an evaluation by both models that are further apart than `share` of the larger one.
std::vector<Disagreement> disagreements(const optimize::Evaluation &evaluation, double share = 0.05);

} // namespace ballonet::studies
