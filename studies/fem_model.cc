// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/fem_model.h"
#include "studies/commands.h"
#include "studies/content_hash.h"
#include "studies/evaluation_run.h"
#include <algorithm>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace ballonet::studies
{
namespace
{

constexpr int evaluation_tag = 1;

/// Sends a text from rank 0 to all.
void broadcast(std::string &text, MPI_Comm communicator)
{
  auto size = static_cast<unsigned long long>(text.size());
  MPI_Bcast(&size, 1, MPI_UNSIGNED_LONG_LONG, 0, communicator);
  text.resize(size);
  MPI_Bcast(text.data(), static_cast<int>(size), MPI_CHAR, 0, communicator);
}

/// A bug or a full disk in one simulation must not stop the others. In a group of several ranks it may have hit one of
/// them only, and the others would wait for it for ever: then everything ends; what is in the journal stays.
EvaluationOutcome guarded(const RankGroups &groups, const std::function<EvaluationOutcome()> &run)
{
  try {
    return run();
  } catch (const std::exception &e) {
    int size = 1;
    MPI_Comm_size(groups.group(), &size);
    if (size > 1) {
      std::cerr << "ballonet: internal error: " << e.what() << std::endl;
      MPI_Abort(groups.all(), internal_error);
    }
    EvaluationOutcome outcome;
    outcome.reason = std::string("internal error: ") + e.what();
    return outcome;
  }
}

} // namespace

FemModel::FemModel(const StudyFile &study, ResultsDirectory *directory, JournalFormat &format, const RankGroups &groups)
    : study_(study), directory_(directory), format_(format), groups_(groups)
{
}

void FemModel::release(const RankGroups &groups)
{
  std::string nothing;
  broadcast(nothing, groups.all());
}

std::string FemModel::content_hash(const optimize::Design &design) const
{
  return studies::content_hash(study_.with(design));
}

std::vector<FemModel::Task> FemModel::prepare(const std::vector<optimize::Design> &designs)
{
  std::vector<Task> tasks;
  for (const optimize::Design &design : designs) {
    const Study study = study_.with(design);
    const std::string hash = studies::content_hash(study);
    const int number = directory_->number_of(hash);
    directory_->begin(number, hash, study);
    tasks.push_back({number, directory_->folder(number).string(), design});
  }
  return tasks;
}

std::optional<std::vector<FemModel::Task>> FemModel::share_tasks(std::vector<Task> tasks) const
{
  nlohmann::json json = nlohmann::json::array();
  for (const Task &task : tasks)
    json.push_back({{"number", task.number}, {"folder", task.folder}, {"design", task.design}});
  std::string text = groups_.rank() == 0 ? json.dump() : "";
  broadcast(text, groups_.all());
  if (text.empty())
    return {};
  tasks.clear();
  for (const auto &task : nlohmann::json::parse(text))
    tasks.push_back({task.at("number"), task.at("folder"), task.at("design")});
  return tasks;
}

void FemModel::serve()
{
  while (const auto tasks = share_tasks({}))
    work_on(*tasks);
}

std::vector<optimize::Evaluation> FemModel::evaluate(const std::vector<optimize::Design> &designs,
                                                     const optimize::OnFinished &on_finished)
{
  finished_.clear();
  on_finished_ = &on_finished;
  work_on(*share_tasks(prepare(designs)));
  while (finished_.size() < designs.size())
    collect(true);
  std::vector<optimize::Evaluation> result;
  for (const optimize::Design &design : designs)
    result.push_back(
        *std::find_if(finished_.begin(), finished_.end(), [&](const auto &e) { return e.design == design; }));
  return result;
}

void FemModel::work_on(const std::vector<Task> &tasks)
{
  const auto first = static_cast<std::size_t>(groups_.index());
  if (groups_.group() != MPI_COMM_NULL)
    for (std::size_t i = first; i < tasks.size(); i += batch_size())
      hand_over(compute(tasks[i]));
}

optimize::Evaluation FemModel::compute(const Task &task)
{
  const Study study = study_.with(task.design);
  const EvaluationOutcome outcome =
      guarded(groups_, [&] { return run_evaluation(study, task.folder, groups_.group(), [this] { collect(false); }); });
  return recorded_evaluation(format_, studies::content_hash(study), task.design, task.number, outcome);
}

void FemModel::hand_over(const optimize::Evaluation &evaluation)
{
  if (!groups_.is_leader())
    return;
  const std::string line = format_.write(evaluation);
  if (groups_.rank() == 0)
    accept(line);
  else
    MPI_Send(line.data(), static_cast<int>(line.size()), MPI_CHAR, 0, evaluation_tag, groups_.all());
}

void FemModel::collect(bool wait)
{
  if (groups_.rank() != 0)
    return;
  int there = 1;
  MPI_Status status;
  if (wait)
    MPI_Probe(MPI_ANY_SOURCE, evaluation_tag, groups_.all(), &status);
  else
    MPI_Iprobe(MPI_ANY_SOURCE, evaluation_tag, groups_.all(), &there, &status);
  if (!there)
    return;
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  std::string line(static_cast<std::size_t>(size), ' ');
  MPI_Recv(line.data(), size, MPI_CHAR, status.MPI_SOURCE, evaluation_tag, groups_.all(), MPI_STATUS_IGNORE);
  accept(line);
}

void FemModel::accept(const std::string &line)
{
  finished_.push_back(format_.read(line));
  (*on_finished_)(finished_.back());
}

} // namespace ballonet::studies
