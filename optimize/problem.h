// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/design.h"
#include "optimize/evaluation.h"
#include <optional>
#include <string>
#include <vector>

namespace ballonet::optimize
{

enum class Goal { minimize, maximize };

/// What is to be made as small or as large as possible.
struct Objective {
  std::string response;
  Goal goal = Goal::minimize;
  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.text("response", self.response, "name of the response");
    v.choice("goal", self.goal, {{"minimize", Goal::minimize}, {"maximize", Goal::maximize}}, "which way is better");
  }
};

/// A response that has to stay within bounds, in the units of the response; at least one bound is given.
struct Constraint {
  std::string response;
  std::optional<double> min, max;

  /// The change of the response that counts as a violation of 1: max - min, else the size of the bound, else 1.
  double scale() const;
};

/// What is varied, what is wanted, what has to hold.
struct Problem {
  DesignSpace space;
  std::optional<Objective> objective; ///< none: nothing is better than anything else (a plain sample)
  std::vector<Constraint> constraints;
  double tolerance = 1e-6; ///< scaled violation up to which a design counts as feasible
};

/// An evaluation as seen by a problem.
struct Assessment {
  bool usable = false;            ///< ok, and every response of the problem is a finite number
  std::string reason;             ///< why it is not usable
  double cost = 0;                ///< the objective, with its sign changed if it is to be maximized
  std::vector<double> violations; ///< scaled, one per bound, positive where the bound is broken
  double worst_violation = 0;     ///< the largest of them, at least 0
  bool feasible = false;          ///< usable and no violation above the tolerance
};

/// Throws std::invalid_argument if there is no variable, or a constraint has no bound, a bound that is not finite, or
/// min above max.
void check(const Problem &problem);

/// Number of constraint bounds, the length of Assessment::violations.
std::size_t n_bounds(const Problem &problem);

/// Throws std::invalid_argument if an ok evaluation lacks a response of the problem; the message lists those it has.
Assessment assess(const Problem &problem, const Evaluation &evaluation);

/// Whether a is better than b: usable before unusable, feasible before infeasible, then by cost if both are feasible
/// and by violation if neither is.
bool is_better(const Assessment &a, const Assessment &b);

} // namespace ballonet::optimize
