// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/forward_model.h"
#include "studies/journal_format.h"
#include "studies/rank_groups.h"
#include "studies/results_directory.h"
#include <optional>

namespace ballonet::studies
{

/// The finite element simulation as a forward model. Rank 0 asks; a batch is spread over the groups of ranks, and every
/// group leaves its evaluations in their folders. Evaluations of other groups reach rank 0 between the steps of its
/// own.
class FemModel : public optimize::ForwardModel
{
public:
  /// All must outlive this object; `directory` is null on all ranks but 0.
  FemModel(const StudyFile &study, ResultsDirectory *directory, JournalFormat &format, const RankGroups &groups);

  /// On all ranks but 0: works on what rank 0 asks for until it is released.
  void serve();

  /// On rank 0, when no model is asked any more: lets the other ranks return from serve().
  static void release(const RankGroups &groups);

  std::vector<optimize::Evaluation> evaluate(const std::vector<optimize::Design> &designs,
                                             const optimize::OnFinished &on_finished) override;
  std::size_t batch_size() const override { return static_cast<std::size_t>(groups_.count()); }
  std::string content_hash(const optimize::Design &design) const override;

private:
  /// One design of a batch and the folder it is computed in.
  struct Task {
    int number = 0;
    std::string folder;
    optimize::Design design;
  };

  std::vector<Task> prepare(const std::vector<optimize::Design> &designs);
  std::optional<std::vector<Task>> share_tasks(std::vector<Task> tasks) const; // nothing: the end
  void work_on(const std::vector<Task> &tasks);
  optimize::Evaluation compute(const Task &task);
  void hand_over(const optimize::Evaluation &evaluation);
  void collect(bool wait);
  void accept(const std::string &line);

  const StudyFile &study_;
  ResultsDirectory *directory_;
  JournalFormat &format_;
  const RankGroups &groups_;
  const optimize::OnFinished *on_finished_ = nullptr; // of the batch at work, on rank 0
  std::vector<optimize::Evaluation> finished_;        // likewise
};

} // namespace ballonet::studies
