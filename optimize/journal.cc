// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/journal.h"
#include <stdexcept>

namespace ballonet::optimize
{

Journal::Journal(const std::filesystem::path &path, LineFormat format) : file_(path), format_(std::move(format))
{
  std::size_t number = 0;
  for (const std::string &line : file_.lines_on_opening()) {
    ++number;
    try {
      Evaluation evaluation = format_.read(line);
      std::string hash = evaluation.hash;
      if (!evaluations_.emplace(std::move(hash), std::move(evaluation)).second)
        ++n_duplicates_;
    } catch (const std::invalid_argument &error) {
      throw std::invalid_argument(path.string() + ":" + std::to_string(number) + ": " + error.what());
    }
  }
}

const Evaluation *Journal::find(const std::string &hash) const
{
  const auto found = evaluations_.find(hash);
  return found == evaluations_.end() ? nullptr : &found->second;
}

void Journal::append(const Evaluation &evaluation)
{
  if (evaluation.hash.empty())
    throw std::logic_error("an evaluation without a hash");
  if (find(evaluation.hash) != nullptr)
    throw std::logic_error("evaluation " + evaluation.hash + " was computed twice");
  file_.append(format_.write(evaluation));
  evaluations_.emplace(evaluation.hash, evaluation);
}

} // namespace ballonet::optimize
