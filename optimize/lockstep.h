// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/ledger.h"
#include "optimize/optimizer.h"
#include <memory>
#include <string>
#include <vector>

namespace ballonet::optimize
{

/// Several runs of an algorithm side by side: each asks for one point, all points are evaluated as one batch, each gets
/// its answer. A run ends when its algorithm does or when it asks for a new design beyond the budget.
class Lockstep
{
public:
  /// Both must outlive this object.
  Lockstep(const DesignSpace &space, Ledger &ledger, Presentation presentation);

  /// Adds a run over the free coordinates of a point, starting there; the other coordinates are held.
  void add(const Algorithm &algorithm, OptimizerSettings settings, Point start, std::vector<std::size_t> free);

  /// Tells the presentation of a point evaluated before.
  void learn(const Point &point, const Assessment &assessment) { presentation_.learn(point, assessment); }

  /// Advances all runs until all have ended.
  void run();

  const Presentation &presentation() const { return presentation_; }

  /// Why the runs ended, in words, with how many of them for each reason.
  std::string stop_reason() const;

private:
  struct Run {
    std::unique_ptr<Optimizer> optimizer;
    Point point;                   // last asked for
    std::vector<std::size_t> free; // coordinates the algorithm works on
    std::string ended;             // why, empty as long as it goes on
  };

  bool ask(Run &run);
  std::vector<Run *> ask_all();
  void answer_all(const std::vector<Run *> &asking);

  const DesignSpace &space_;
  Ledger &ledger_;
  Presentation presentation_;
  std::vector<Run> runs_;
};

} // namespace ballonet::optimize
