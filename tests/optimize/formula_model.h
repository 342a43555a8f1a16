// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/forward_model.h"
#include "optimize/journal.h"
#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace ballonet::optimize
{

/// A forward model that is a formula, and counts what is asked of it.
class FormulaModel : public ForwardModel
{
public:
  using Formula = std::function<Evaluation(const Design &)>;

  explicit FormulaModel(Formula formula, std::size_t batch_size = 1) : formula_(std::move(formula)), size_(batch_size)
  {
  }

  std::vector<Evaluation> evaluate(const std::vector<Design> &designs, const OnFinished &on_finished) override
  {
    batches.push_back(designs.size());
    std::vector<Evaluation> evaluations;
    for (const Design &design : designs) {
      evaluations.push_back(formula_(design));
      evaluations.back().design = design;
      on_finished(evaluations.back());
      sequence.push_back(design);
    }
    return evaluations;
  }

  std::size_t batch_size() const override { return size_; }
  std::string content_hash(const Design &design) const override { return text_of(design); }

  /// Exact text of a design.
  static std::string text_of(const Design &design);

  std::vector<std::size_t> batches; ///< sizes, in order
  std::vector<Design> sequence;     ///< computed designs, in order

private:
  Formula formula_;
  std::size_t size_;
};

/// An ok evaluation.
Evaluation ok(std::map<std::string, double> responses);

/// A failed evaluation.
Evaluation failure(Status status, std::string reason);

/// Evaluations as tab-separated fields with hexadecimal numbers.
LineFormat tab_separated();

/// A folder that is removed with its contents at the end.
class TemporaryFolder
{
public:
  TemporaryFolder();
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder &) = delete;
  TemporaryFolder &operator=(const TemporaryFolder &) = delete;
  std::filesystem::path operator/(const std::string &name) const { return path_ / name; }

private:
  std::filesystem::path path_;
};

/// Two continuous variables x and y in [-2, 2].
DesignSpace square();

} // namespace ballonet::optimize
