// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/evaluator.h"
#include <algorithm>
#include <set>
#include <stdexcept>

namespace ballonet::optimize
{

Evaluator::Evaluator(ForwardModel &model, Journal *journal) : model_(model), journal_(journal) {}

std::vector<Evaluation> Evaluator::evaluate(const std::vector<Design> &designs, const OnFinished &on_finished)
{
  std::vector<std::string> hashes;
  std::set<std::string> pending;
  std::vector<Design> fresh;
  for (const Design &design : designs) {
    const std::string &hash = hashes.emplace_back(content_hash(design));
    if (asked_.count(hash))
      continue;
    if (journal_ && journal_->find(hash))
      replay(hash, on_finished);
    else if (pending.insert(hash).second)
      fresh.push_back(design);
  }
  const std::size_t size = std::max<std::size_t>(1, batch_size());
  for (std::size_t begin = 0; begin < fresh.size(); begin += size)
    compute({fresh.begin() + begin, fresh.begin() + std::min(begin + size, fresh.size())}, on_finished);

  std::vector<Evaluation> evaluations;
  for (const std::string &hash : hashes)
    evaluations.push_back(asked_.at(hash));
  return evaluations;
}

void Evaluator::replay(const std::string &hash, const OnFinished &on_finished)
{
  Evaluation evaluation = *journal_->find(hash);
  evaluation.replayed = true;
  ++n_replayed_;
  if (on_finished)
    on_finished(evaluation);
  asked_.emplace(hash, std::move(evaluation));
}

void Evaluator::compute(const std::vector<Design> &designs, const OnFinished &on_finished)
{
  const auto results =
      model_.evaluate(designs, [&](const Evaluation &evaluation) { accept(evaluation, designs, on_finished); });
  if (results.size() != designs.size())
    throw std::logic_error("the forward model returned " + std::to_string(results.size()) + " evaluations of " +
                           std::to_string(designs.size()) + " designs");
  for (const Design &design : designs)
    if (!asked_.count(content_hash(design)))
      throw std::logic_error("the forward model did not announce the evaluation of a design it was given");
}

void Evaluator::accept(Evaluation evaluation, const std::vector<Design> &batch, const OnFinished &on_finished)
{
  if (std::find(batch.begin(), batch.end(), evaluation.design) == batch.end())
    throw std::logic_error("the forward model announced a design it was not given");
  evaluation.hash = content_hash(evaluation.design);
  evaluation.replayed = false;
  if (asked_.count(evaluation.hash))
    throw std::logic_error("the forward model announced evaluation " + evaluation.hash + " twice");
  if (journal_)
    journal_->append(evaluation);
  ++n_computed_;
  const auto place = asked_.emplace(evaluation.hash, std::move(evaluation)).first;
  if (on_finished)
    on_finished(place->second);
}

} // namespace ballonet::optimize
