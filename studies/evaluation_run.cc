// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/evaluation_run.h"
#include "geometry/content_hash.h"
#include "geometry/mesh_io.h"
#include "solver/history_file.h"
#include "solver/simulation.h"
#include "studies/field_files.h"
#include "studies/history_table.h"
#include "studies/path_responses.h"
#include <cstdio>
#include <fstream>
#include <optional>
#include <stdexcept>

namespace ballonet::studies
{
namespace
{

std::string hexadecimal(std::uint64_t number)
{
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(number));
  return text;
}

optimize::Status status_of(solver::PathStatus status)
{
  switch (status) {
  case solver::PathStatus::ended:
    return optimize::Status::ok;
  case solver::PathStatus::diverged:
    return optimize::Status::diverged;
  case solver::PathStatus::step_limit:
    return optimize::Status::step_limit;
  case solver::PathStatus::time_limit:
    return optimize::Status::time_limit;
  }
  throw std::logic_error("an unknown end of a path");
}

/// A simulation with its files. One per evaluation; every rank has one, the first rank of the group writes.
class Session
{
public:
  Session(const Study &study, const SimulationModel &model, std::filesystem::path folder, MPI_Comm communicator)
      : study_(study), folder_(std::move(folder)), mesh_(solver_mesh(model.mesh)),
        simulation_(model.parameters, mesh_, communicator), measurement_(study, model, communicator)
  {
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    simulation_.set_checkpoint(folder_ / "checkpoint.h5");
    if (simulation_.resume(folder_ / "checkpoint.h5"))
      take_up(read_history(folder_ / "history.csv"));
    MPI_Barrier(communicator); // everyone has read what the first rank is going to replace
    if (study.output.vtu)
      fields_.emplace(folder_, rows_, communicator);
    if (rank != 0)
      return;
    table_.emplace(folder_ / "history.csv", rows_);
    open_shapes(simulation_.progress().step);
    log_.open(folder_ / "log.txt", std::ios::app);
    if (!rows_.empty())
      log("goes on after step " + std::to_string(simulation_.progress().step));
  }

  solver::PathResult run(const std::function<void()> &between_steps)
  {
    const auto observe = [&](const solver::PathPoint &point) {
      moved_ = true;
      rows_.push_back(measurement_.measure(point, simulation_.equilibrium()));
      if (table_)
        table_->append(rows_.back());
      for (const solver::CriticalPoint &critical : point.critical_points)
        keep_critical_point(critical);
      if (point.progress.step % study_.output.shape_every == 0)
        keep_shape();
      between_steps();
      const bool there = value_of(rows_.back(), "bending_angle_deg") >= study_.judge.end_angle;
      return there ? std::string("judge.end_angle is reached") : std::string();
    };
    const auto result = simulation_.run(observe, [this](const std::string &line) { log(line); });
    if (moved_ && simulation_.progress().step % study_.output.shape_every != 0)
      keep_shape();
    log("end of the path: " + result.reason);
    return result;
  }

  const std::vector<Row> &rows() const { return rows_; }
  const std::vector<CriticalRecord> &critical_points() const { return critical_points_; }

  void log(const std::string &line)
  {
    if (log_.is_open())
      log_ << line << std::endl;
  }

private:
  /// A kill may leave a file of shapes that cannot be read: then they begin anew, the path does not.
  void open_shapes(int steps_done)
  {
    const std::string file = folder_ / "history.h5";
    try {
      shapes_.emplace(file, mesh_, "symmetry", steps_done > 0, steps_done);
    } catch (const std::runtime_error &) {
      shapes_.emplace(file, mesh_, "symmetry", false, 0);
    }
  }

  void keep_critical_point(const solver::CriticalPoint &point)
  {
    const CriticalRecord record = record_of(point, is_half() ? 2 : 1, simulation_.equilibrium().has_cavity());
    critical_points_.push_back(record);
    if (shapes_)
      shapes_->add_critical_point(record.kind, point.state, point.mode, record.facts);
  }

  /// Whether the mesh is one half of the actuator.
  bool is_half() const { return study_.actuator.kind != ActuatorKind::mesh && study_.mesh.symmetry; }

  /// Writes the present shape; all ranks take part.
  void keep_shape()
  {
    const solver::PathProgress &progress = simulation_.progress();
    const auto stresses = simulation_.equilibrium().stresses(progress.state);
    if (fields_)
      fields_->add(progress.step, progress.state, stresses, simulation_.equilibrium());
    if (!shapes_)
      return;
    std::map<std::string, double> facts = {
        {"step", progress.step}, {"time", progress.state.time}, {"symmetry", is_half()}};
    for (const auto &[name, value] : rows_.back())
      if (name == "pressure_kPa" || name == "bending_angle_deg")
        facts[name] = value;
    shapes_->add(progress.step, progress.state, stresses, facts);
  }

  /// Keeps the rows up to the checkpoint.
  void take_up(const std::vector<Row> &rows)
  {
    for (const Row &row : rows)
      if (value_of(row, "step") <= simulation_.progress().step)
        rows_.push_back(row);
    if (!rows_.empty())
      measurement_.go_on_after(rows_.back());
    critical_points_ = read_critical_points(folder_ / "history.h5", simulation_.progress().step);
  }

  const Study &study_;
  std::filesystem::path folder_;
  solver::Mesh mesh_;
  solver::Simulation simulation_;
  Measurement measurement_;
  std::vector<Row> rows_;
  std::vector<CriticalRecord> critical_points_;
  bool moved_ = false; // a step was taken in this session
  std::optional<FieldFiles> fields_;
  std::optional<HistoryTable> table_;         // of the writing rank
  std::optional<solver::HistoryFile> shapes_; // likewise
  std::ofstream log_;                         // likewise
};

void write_mesh(const geometry::Mesh &mesh, const std::filesystem::path &folder, MPI_Comm communicator)
{
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  if (rank == 0)
    if (const auto failure = geometry::write_msh(mesh, folder / "mesh.msh"))
      throw std::runtime_error(failure->reason);
}

} // namespace

optimize::Evaluation recorded_evaluation(JournalFormat &format, const std::string &hash, const optimize::Design &design,
                                         int number, const EvaluationOutcome &outcome)
{
  format.set_origin(hash, {number, outcome.mesh_hash});
  if (outcome.judgement)
    format.set_judgement(hash, *outcome.judgement);
  format.set_critical_points(hash, outcome.critical_points);
  return {hash, design, outcome.status, outcome.reason, outcome.responses, outcome.seconds, false};
}

EvaluationOutcome run_evaluation(const Study &study, const std::filesystem::path &folder, MPI_Comm communicator,
                                 const std::function<void()> &between_steps)
{
  EvaluationOutcome outcome;
  const double start = MPI_Wtime();
  const auto built = build_model(study);
  if (const auto *failure = std::get_if<geometry::MeshFailure>(&built)) {
    outcome.status = optimize::Status::mesh_failed;
    outcome.reason = failure->reason;
  } else {
    const auto &model = std::get<SimulationModel>(built);
    outcome.mesh_hash = hexadecimal(geometry::content_hash(model.mesh));
    write_mesh(model.mesh, folder, communicator);
    Session session(study, model, folder, communicator);
    const solver::PathResult result = session.run(between_steps);
    outcome.status = status_of(result.status);
    outcome.reason = result.reason;
    outcome.critical_points = session.critical_points();
    outcome.judgement = judgement_of(study, session.rows(), outcome.status, outcome.reason);
    outcome.responses = responses_of(study, session.rows(), outcome.status == optimize::Status::ok, outcome.judgement);
    if (outcome.judgement)
      session.log("class: " + word_of(outcome.judgement->path_class) + ", " + outcome.judgement->reason);
  }
  outcome.seconds = MPI_Wtime() - start;
  MPI_Bcast(&outcome.seconds, 1, MPI_DOUBLE, 0, communicator);
  return outcome;
}

} // namespace ballonet::studies
