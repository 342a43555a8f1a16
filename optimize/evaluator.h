// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/forward_model.h"
#include "optimize/journal.h"
#include <unordered_map>

namespace ballonet::optimize
{

/// A forward model that computes nothing twice: it answers from what it has seen before and from a journal, hands only
/// what is new to the model behind it, in batches of the model's batch_size(), and puts every evaluation into the
/// journal the moment it is finished.
class Evaluator : public ForwardModel
{
public:
  /// Both must outlive the evaluator. Without a journal, evaluations are remembered by this object only.
  explicit Evaluator(ForwardModel &model, Journal *journal = nullptr);

  /// Designs may be repeated in the batch. on_finished is called once for each design not asked for before, when its
  /// evaluation is in the journal. Throws std::logic_error if the model announces or returns a design it was not
  /// given, or leaves one out.
  std::vector<Evaluation> evaluate(const std::vector<Design> &designs, const OnFinished &on_finished) override;

  std::size_t batch_size() const override { return model_.batch_size(); }
  std::string content_hash(const Design &design) const override { return model_.content_hash(design); }

  std::size_t n_computed() const { return n_computed_; } ///< designs computed by the model
  std::size_t n_replayed() const { return n_replayed_; } ///< designs taken from the journal

private:
  void replay(const std::string &hash, const OnFinished &on_finished);
  void compute(const std::vector<Design> &designs, const OnFinished &on_finished);
  void accept(Evaluation evaluation, const std::vector<Design> &batch, const OnFinished &on_finished);

  ForwardModel &model_;
  Journal *journal_;
  std::unordered_map<std::string, Evaluation> asked_;
  std::size_t n_computed_ = 0, n_replayed_ = 0;
};

} // namespace ballonet::optimize
