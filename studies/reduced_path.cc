// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/reduced_path.h"
#include "solver/reduced/history_row.h"
#include "solver/reduced/ramp_path.h"
#include "studies/history_table.h"
#include "studies/path_responses.h"
#include "studies/reduced_parameters.h"
#include "studies/stages.h"
#include <algorithm>
#include <stdexcept>

namespace ballonet::studies
{
namespace
{

using namespace solver::reduced;
using States = std::vector<solver::reduced::State>;

/// Gives a static path a row at an angle between two others.
void insert_row(States &states, const PebsModel &model, double angle)
{
  const auto after = std::find_if(states.begin(), states.end(), [&](const auto &s) { return s.angle >= angle; });
  if (after == states.begin() || after == states.end() || after->angle == angle)
    return;
  if (auto state = model.state_at(angle, *(after - 1))) {
    model.judge(*state, (after - 1)->stage);
    states.insert(after, std::move(*state));
  }
}

/// Gives it a row where its pressure first reaches `pressure`, found by bisection between two others.
void insert_pressure(States &states, const PebsModel &model, double pressure)
{
  const auto after = std::find_if(states.begin(), states.end(), [&](const auto &s) { return s.pressure >= pressure; });
  if (after == states.begin() || after == states.end())
    return;
  double below = (after - 1)->angle, above = after->angle;
  for (int i = 0; i < 40; ++i) {
    const double middle = (below + above) / 2;
    const auto state = model.state_at(middle, *(after - 1));
    (state && state->pressure < pressure ? below : above) = middle;
  }
  insert_row(states, model, above);
}

/// Gives a static path a first row next to zero pressure: its own first row may lie anywhere in the first step.
void insert_start(States &states, const PebsModel &model)
{
  if (states.empty() || states.front().angle <= model.natural_angle())
    return;
  double none = std::max(model.natural_angle(), states.front().angle - model.parameters().static_path.angle_step);
  auto start = states.front();
  for (int i = 0; i < 30; ++i) {
    const double middle = (none + start.angle) / 2;
    if (auto state = model.state_at(middle, start))
      start = std::move(*state);
    else
      none = middle;
  }
  if (start.angle < states.front().angle) {
    model.judge(start, solver::reduced::Stage::separation);
    states.insert(states.begin(), std::move(start));
  }
}

Path refined_static_path(const Study &study, const PebsModel &model)
{
  Path path = static_path(model);
  insert_start(path.rows, model);
  for (const Event &event : path.events)
    if (event.kind == EventKind::limit || event.kind == EventKind::rib_contact)
      insert_row(path.rows, model, event.angle);
  for (const double pressure : {study.judge.window_min, study.judge.window_max, study.path.pressure_max})
    insert_pressure(path.rows, model, pressure);
  return path;
}

double control_value(const Study &study, const Row &row)
{
  return value_of(row, study.path.control == solver::Control::volume ? "volume_ratio" : "pressure_kPa");
}

/// The history's row number `step`; `stages` has seen those before.
Row history_row_of(const Study &study, const PebsModel &model, const solver::reduced::State &state, std::size_t step,
                   StageTracker &stages)
{
  const Row measured = history_row(model, state);
  Row row = {{"step", static_cast<double>(step)}, {"control", control_value(study, measured)}};
  row.insert(row.end(), measured.begin(), measured.end());
  row.emplace_back(stage_column, static_cast<double>(stages.advance(row)));
  return row;
}

/// Why the path ends with a state, empty if it goes on.
std::string end_reached(const Study &study, const solver::reduced::State &state, const Row &row)
{
  if (state.bulge_ratio >= 1)
    return "the balloon runs out of the widest gap";
  if (value_of(row, "volume_ratio") >= study.path.volume_max)
    return "path.volume_max is reached";
  if (state.pressure >= study.path.pressure_max)
    return "path.pressure_max is reached";
  return {};
}

/// The rows up to the end, and why that is the end.
ReducedPath recorded(const Study &study, const PebsModel &model, const Path &path)
{
  ReducedPath result;
  StageTracker stages(stage_thresholds(study));
  result.status = optimize::Status::ok;
  for (const auto &state : path.rows) {
    result.rows.push_back(history_row_of(study, model, state, result.rows.size() + 1, stages));
    if (result.reason = end_reached(study, state, result.rows.back()); !result.reason.empty())
      return result;
  }
  if (path.ending != Ending::complete)
    return {optimize::Status::diverged, path.reason, std::move(result.rows)};
  if (path.rows.empty())
    return {optimize::Status::failed, "the actuator hangs beyond judge.end_angle", {}};
  const bool turned = path.rows.back().angle >= model.parameters().ramp.stop_angle * (1 - 1e-12);
  result.reason = turned ? "judge.end_angle is reached" : "path.pressure_max is reached";
  return result;
}

} // namespace

ReducedPath reduced_path(const Study &study)
{
  try {
    const PebsModel model(reduced_parameters(study));
    const bool ramp = study.path.control == solver::Control::ramp;
    return recorded(study, model, ramp ? ramp_path(model) : refined_static_path(study, model));
  } catch (const std::invalid_argument &e) {
    return {optimize::Status::failed, std::string("out of the reduced model's range: ") + e.what(), {}};
  } catch (const std::domain_error &e) {
    return {optimize::Status::diverged, e.what(), {}};
  }
}

EvaluationOutcome run_reduced_evaluation(const Study &study, const std::filesystem::path &folder)
{
  EvaluationOutcome outcome;
  const double start = MPI_Wtime();
  const ReducedPath path = reduced_path(study);
  HistoryTable(folder / "history.csv", path.rows);
  outcome.status = path.status;
  outcome.reason = path.reason;
  outcome.judgement = judgement_of(study, path.rows, path.status, path.reason);
  outcome.responses = responses_of(study, path.rows, path.status == optimize::Status::ok, outcome.judgement);
  std::ofstream log(folder / "log.txt");
  log << "reduced model, " << path.rows.size() << " rows\nend of the path: " << path.reason << "\n";
  if (outcome.judgement)
    log << "class: " << word_of(outcome.judgement->path_class) << ", " << outcome.judgement->reason << "\n";
  outcome.seconds = MPI_Wtime() - start;
  return outcome;
}

} // namespace ballonet::studies
