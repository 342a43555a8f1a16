// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/results_file.h"
#include "solver/hdf5_file.h"
#include "studies/atomic_file.h"
#include "studies/history_table.h"
#include "studies/word_columns.h"
#include <cmath>
#include <limits>

namespace ballonet::studies
{
namespace
{

using optimize::Evaluation;
using solver::Hdf5File;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void write_columns(Hdf5File &file, const std::string &group, const std::vector<Row> &rows)
{
  for (std::size_t i = 0; !rows.empty() && i < rows.front().size(); ++i) {
    const std::string &name = rows.front()[i].first;
    std::vector<double> values;
    for (const Row &row : rows)
      values.push_back(row[i].second);
    file.write(group + "/" + name, values);
    if (!words_of(name).empty())
      file.write_attribute(group + "/" + name, "words", all_words_of(name));
  }
}

void write_evaluation(Hdf5File &file, const std::filesystem::path &folder, const Evaluation &evaluation,
                      const optimize::DesignSpace &space, const JournalFormat &format)
{
  const std::string group = "/evaluations/" + folder.filename().string();
  file.create_group(group);
  file.write_attribute(group, "status", std::string(optimize::word_of(evaluation.status)));
  file.write_attribute(group, "reason", evaluation.reason);
  file.write_attribute(group, "hash", evaluation.hash);
  if (const Judgement *judgement = format.judgement(evaluation.hash))
    file.write_attribute(group, "class", word_of(judgement->path_class));
  for (std::size_t i = 0; i < space.size(); ++i)
    file.write_attribute(group, space.variable(i).key, evaluation.design.at(i));
  write_columns(file, group, read_history(folder / "history.csv"));
}

double objective_of(const Study &study, const Evaluation &evaluation)
{
  if (!study.objective || evaluation.status != optimize::Status::ok)
    return none;
  const auto found = evaluation.responses.find(study.objective->response);
  return found == evaluation.responses.end() ? none : found->second;
}

void write_convergence(Hdf5File &file, const Study &study, const optimize::Result &result, const JournalFormat &format)
{
  std::vector<int> numbers, feasible;
  std::vector<double> objectives, best;
  for (std::size_t i = 0; i < result.evaluations.size(); ++i) {
    const bool judged = i < result.history.size(); // there is no history without an objective
    numbers.push_back(format.origin(result.evaluations[i].hash).number);
    objectives.push_back(objective_of(study, result.evaluations[i]));
    best.push_back(judged ? result.history[i].objective : none);
    feasible.push_back(judged && result.history[i].feasible);
  }
  file.create_group("/convergence");
  file.write("/convergence/evaluation", numbers);
  file.write("/convergence/objective", objectives);
  file.write("/convergence/best_so_far", best);
  file.write("/convergence/feasible", feasible);
}

} // namespace

void write_results_file(const ResultsDirectory &directory, const StudyFile &study, const optimize::Result &result,
                        const JournalFormat &format)
{
  const auto target = directory.path() / "results.h5", unfinished = directory.path() / "results.h5.new";
  {
    Hdf5File file(unfinished.string(), Hdf5File::Mode::create);
    file.create_group("/evaluations");
    for (std::size_t i = 0; i < study.space().size(); ++i)
      file.write_attribute("/evaluations", study.space().variable(i).key, study.space().variable(i).unit);
    for (const Evaluation &evaluation : result.evaluations)
      write_evaluation(file, directory.folder(format.origin(evaluation.hash).number), evaluation, study.space(),
                       format);
    write_convergence(file, study.study(), result, format);
    file.flush();
  }
  move_into_place(unfinished, target);
}

} // namespace ballonet::studies
