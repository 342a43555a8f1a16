// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/algorithm.h"
#include "optimize/coroutine.h"
#include "optimize/design.h"
#include "optimize/presentation.h"
#include <optional>
#include <string>

namespace ballonet::optimize
{

/// Settings of one run of an algorithm in the unit box.
struct OptimizerSettings {
  Point start;                   ///< where a local algorithm begins; its length is the number of variables, at least 1
  std::size_t n_constraints = 0; ///< length of Answer::constraints
  double constraint_tolerance = 0; ///< up to which the algorithm takes a constraint as kept
  double initial_step = 0.2;       ///< first step of a local algorithm, share of the range
  double x_tolerance = 0;          ///< ends when a step is below this share of the range; 0: not used
  double f_tolerance = 0;          ///< ends when the cost changes by less than this share; 0: not used
  int max_requests = 0;            ///< ends after so many points; 0: no limit
  int population = 0;              ///< of a population algorithm; 0: NLopt's own choice
  unsigned long seed = 1;          ///< of a random algorithm
};

/// One run of an NLopt algorithm that can be asked for its next point and told the answer.
class Optimizer
{
public:
  Optimizer(const Algorithm &algorithm, OptimizerSettings settings);

  /// The next point it wants to know about, nothing if it has ended. Tell the answer before asking again. Throws
  /// std::invalid_argument if NLopt refuses the settings.
  std::optional<Point> ask() { return coroutine_.resume(); }
  void tell(Answer answer) { coroutine_.answer(std::move(answer)); }

  /// Why it ended, in words; empty as long as it has not.
  const std::string &stop_reason() const { return stop_reason_; }

private:
  using Run = Coroutine<Point, Answer>;
  void run(const Run::Yield &yield);

  Algorithm algorithm_;
  OptimizerSettings settings_;
  std::string stop_reason_;
  Run coroutine_; // last: its thread works with the members above
};

} // namespace ballonet::optimize
