// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/evaluation.h"
#include <functional>
#include <string>
#include <vector>

namespace ballonet::optimize
{

/// Told of each evaluation as soon as it is finished.
using OnFinished = std::function<void(const Evaluation &)>;

/// What turns designs into responses: a simulation, a reduced model, a formula. Always called from one thread.
class ForwardModel
{
public:
  virtual ~ForwardModel() = default;

  /// Evaluates a batch of designs (all different) and returns their evaluations in the same order. Calls on_finished
  /// once per design, in any order, in the calling thread, as soon as the design is finished: what has been announced
  /// is safe if the process is killed before the batch ends. Fills everything of an Evaluation but hash and replayed.
  /// A design that cannot be computed is an Evaluation with its status, not an exception.
  virtual std::vector<Evaluation> evaluate(const std::vector<Design> &designs, const OnFinished &on_finished) = 0;

  /// How many designs it can work on at once; at least 1. Larger batches are allowed.
  virtual std::size_t batch_size() const = 0;

  /// Hash of all resolved inputs of the evaluation of a design: equal if and only if the results would be equal.
  virtual std::string content_hash(const Design &design) const = 0;
};

} // namespace ballonet::optimize
