// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/journal.h"
#include "studies/atomic_file.h"
#include "studies/commands.h"
#include "studies/dry_run.h"
#include "studies/paired_model.h"
#include "studies/reduced_model.h"
#include "studies/report.h"
#include "studies/results_file.h"
#include "studies/study_run.h"
#include "studies/summary.h"
#include <iomanip>
#include <memory>

namespace ballonet::studies
{
namespace
{

std::filesystem::path directory_of(const Invocation &invocation)
{
  if (!invocation.directory.empty())
    return invocation.directory;
  return std::filesystem::path("results") / std::filesystem::path(invocation.study).stem();
}

RankGroups groups_of(const Study &study, const Invocation &invocation)
{
  int ranks = 1;
  MPI_Comm_size(invocation.communicator, &ranks);
  if (study.parallel.ranks_per_evaluation > ranks)
    throw InputError({invocation.study}, "parallel.ranks_per_evaluation",
                     std::to_string(study.parallel.ranks_per_evaluation), "at most the number of ranks",
                     "started with " + std::to_string(ranks) + " rank(s)");
  return RankGroups(invocation.communicator, study.parallel.ranks_per_evaluation);
}

/// What rank 0 does: everything but the simulations of other groups.
class Run
{
public:
  Run(const StudyFile &study, const std::filesystem::path &path, const RankGroups &groups, std::ostream &out)
      : study_(study), out_(out), start_(MPI_Wtime()), ranks_(size_of(groups.all())), format_(study.space()),
        directory_(path, study, ranks_), journal_(directory_.journal(), format_.line_format()),
        model_(make_model(groups)), evaluator_(*model_, &journal_)
  {
  }

  ExitCode run()
  {
    Summary summary;
    summary.ranks = ranks_;
    write(summary);
    summary.result = run_method(study_, evaluator_, [this](const auto &evaluation) { print(evaluation); });
    const bool found = has_result(study_.study(), summary.result);
    summary.status = found ? "done" : "no_result";
    summary.reason = summary.result.stop_reason;
    write(summary);
    keep_numbers(summary.result);
    out_ << summary.status << ": " << summary.reason << "\n" << directory_.path().string() << std::endl;
    make_report(directory_.path(), out_);
    return found ? done : no_result;
  }

private:
  static int size_of(MPI_Comm communicator)
  {
    int size = 1;
    MPI_Comm_size(communicator, &size);
    return size;
  }

  /// The other ranks wait for an FemModel; without one they are let go at the end.
  std::unique_ptr<optimize::ForwardModel> make_model(const RankGroups &groups)
  {
    if (study_.study().method.model == ModelKind::reduced)
      return std::make_unique<ReducedModel>(study_, directory_, format_);
    if (study_.study().method.model == ModelKind::both)
      return std::make_unique<PairedModel>(study_, directory_, format_, groups);
    return std::make_unique<FemModel>(study_, &directory_, format_, groups);
  }

  void write(Summary &summary) const
  {
    summary.wall_seconds = MPI_Wtime() - start_;
    write_atomically(directory_.path() / "summary.json", summary_text(summary, study_, format_));
  }

  /// results.h5 repeats what is in the journal and the histories: a run is not lost with it.
  void keep_numbers(const optimize::Result &result) const
  {
    try {
      write_results_file(directory_, study_, result, format_);
    } catch (const std::exception &e) {
      out_ << "no new results.h5: " << e.what() << std::endl;
    }
  }

  void print(const optimize::Evaluation &evaluation) const
  {
    out_ << "evaluation " << std::setw(4) << format_.origin(evaluation.hash).number << "  "
         << optimize::word_of(evaluation.status) << (evaluation.replayed ? "  (from the journal)" : "");
    if (study_.study().objective)
      if (const auto value = evaluation.responses.find(study_.study().objective->response);
          value != evaluation.responses.end())
        out_ << "  " << value->first << " = " << value->second;
    out_ << "  " << std::setprecision(3) << evaluation.seconds << " s  " << evaluation.reason << std::endl;
  }

  const StudyFile &study_;
  std::ostream &out_;
  double start_;
  int ranks_;
  JournalFormat format_;
  ResultsDirectory directory_;
  optimize::Journal journal_;
  std::unique_ptr<optimize::ForwardModel> model_;
  optimize::Evaluator evaluator_;
};

/// Lets the other ranks go and tells them the exit code.
void finish(int &code, const RankGroups &groups)
{
  if (groups.rank() == 0)
    FemModel::release(groups);
  MPI_Bcast(&code, 1, MPI_INT, 0, groups.all());
}

/// The same exit code on every rank, also when rank 0 fails.
ExitCode run_on_all(const StudyFile &study, const std::filesystem::path &path, const RankGroups &groups,
                    std::ostream &out)
{
  int code = internal_error;
  if (groups.rank() != 0) {
    JournalFormat format(study.space());
    FemModel(study, nullptr, format, groups).serve();
  } else {
    try {
      code = Run(study, path, groups, out).run();
    } catch (...) {
      finish(code, groups);
      throw;
    }
  }
  finish(code, groups);
  return static_cast<ExitCode>(code);
}

} // namespace

ExitCode run_command(const Invocation &invocation)
{
  const StudyFile study = StudyFile::open(invocation.study, invocation.overrides);
  const auto groups = groups_of(study.study(), invocation);
  const auto path = directory_of(invocation);
  if (invocation.dry_run)
    return print_dry_run(study, groups, invocation.out) ? done : no_result;
  ResultsDirectory::check(path, study, invocation.resume);
  MPI_Barrier(invocation.communicator); // all ranks have looked before rank 0 writes
  return run_on_all(study, path, groups, invocation.out);
}

} // namespace ballonet::studies
