// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/lockstep.h"
#include <map>

namespace ballonet::optimize
{

Lockstep::Lockstep(const DesignSpace &space, Ledger &ledger, Presentation presentation)
    : space_(space), ledger_(ledger), presentation_(std::move(presentation))
{
}

void Lockstep::add(const Algorithm &algorithm, OptimizerSettings settings, Point start, std::vector<std::size_t> free)
{
  settings.start.clear();
  for (const std::size_t i : free)
    settings.start.push_back(start[i]);
  settings.n_constraints = presentation_.n_constraints();
  runs_.push_back({std::make_unique<Optimizer>(algorithm, std::move(settings)), std::move(start), std::move(free), ""});
}

void Lockstep::run()
{
  for (std::vector<Run *> asking = ask_all(); !asking.empty(); asking = ask_all())
    answer_all(asking);
}

std::vector<Lockstep::Run *> Lockstep::ask_all()
{
  std::vector<Run *> asking;
  for (Run &run : runs_)
    if (run.ended.empty() && ask(run))
      asking.push_back(&run);
  return asking;
}

bool Lockstep::ask(Run &run)
{
  const std::optional<Point> coordinates = run.optimizer->ask();
  if (!coordinates) {
    run.ended = run.optimizer->stop_reason();
    return false;
  }
  for (std::size_t i = 0; i < run.free.size(); ++i)
    run.point[run.free[i]] = (*coordinates)[i];
  if (!ledger_.reserve(space_.design_at(run.point)))
    run.ended = "the budget of " + std::to_string(ledger_.budget()) + " evaluations is spent";
  return run.ended.empty();
}

void Lockstep::answer_all(const std::vector<Run *> &asking)
{
  std::vector<Design> designs;
  for (const Run *run : asking)
    designs.push_back(space_.design_at(run->point));
  const std::vector<Assessment> assessments = ledger_.evaluate(designs);
  for (std::size_t i = 0; i < asking.size(); ++i)
    presentation_.learn(asking[i]->point, assessments[i]);
  for (std::size_t i = 0; i < asking.size(); ++i)
    asking[i]->optimizer->tell(presentation_.answer(asking[i]->point, assessments[i]));
}

std::string Lockstep::stop_reason() const
{
  std::map<std::string, std::size_t> counts;
  for (const Run &run : runs_)
    ++counts[run.ended];
  std::string text;
  for (const auto &[reason, n] : counts) {
    text += text.empty() ? "" : "; ";
    text +=
        counts.size() == 1 ? reason : reason + " (" + std::to_string(n) + " of " + std::to_string(runs_.size()) + ")";
  }
  return text;
}

} // namespace ballonet::optimize
