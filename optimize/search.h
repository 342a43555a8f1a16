// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/evaluator.h"
#include "optimize/result.h"
#include <optional>

namespace ballonet::optimize
{

/// How to search for the best design.
struct SearchOptions {
  std::string algorithm = "LN_COBYLA";
  int max_evaluations = 100; // different designs, replayed ones included
  int initial = 0;
  int starts = 1;
  int seed = 1;
  double initial_step = 0.2;
  double x_tolerance = 1e-3;
  double f_tolerance = 0;
  int population = 0;
  int enumeration_limit = 8;
  std::optional<Design> start; ///< a design to begin with; none: the middle of the space

  template <class Self, class Visitor>
  static void fields(Self &self, Visitor &v)
  {
    v.text("algorithm", self.algorithm, "derivative-free algorithm by NLopt's name");
    v.count("max_evaluations", self.max_evaluations, 1, 1000000,
            "the search ends after so many different designs, those replayed from a journal included");
    v.count("initial", self.initial, 0, 1000000,
            "size of the Latin hypercube evaluated first; its best are the starts");
    v.count("starts", self.starts, 1, 1000, "independent runs of the algorithm, evaluated together in batches");
    v.count("seed", self.seed, 0, 2147483647, "of the sample and of random algorithms; same seed, same search");
    v.quantity("initial_step", self.initial_step, "1", 1e-6, 1, "first step of local algorithms, share of the range");
    v.quantity("x_tolerance", self.x_tolerance, "1", 0, 1, "a run ends when its step is below this share of the range");
    v.quantity("f_tolerance", self.f_tolerance, "1", 0, 1,
               "a run ends when the objective changes by less than this share");
    v.count("population", self.population, 0, 1000000, "of population algorithms; 0: NLopt's choice");
    v.count("enumeration_limit", self.enumeration_limit, 1, 10000,
            "up to so many combinations of discrete variables, each combination gets runs of its own");
  }
};

/// Searches for the best design of a problem.
///
/// A Latin hypercube of `initial` designs comes first, then `starts` independent runs of the algorithm from its best
/// designs, no two of them close together (see starting_points.h). The runs go in lockstep: each asks for one point,
/// all points are evaluated as one batch in the calling thread, each gets its answer. The sequence of designs depends
/// on the problem, the options and the responses alone, never on timing or batch size, so a search repeated over a
/// journal repeats itself without computing anything.
///
/// Discrete variables: if the budget covers all combinations and nothing else varies, all are evaluated; if there are
/// at most enumeration_limit combinations and the budget gives each run five evaluations per free coordinate (and one
/// more), every combination gets its own runs over the continuous variables; otherwise the algorithm sees [0, 1] and
/// its points are rounded. The result says which.
///
/// Constraints: native, or by an augmented Lagrangian, or refused, see algorithm.h. Failures: see presentation.h.
///
/// on_finished is told of each evaluation when it is in the journal. Throws std::invalid_argument if problem and
/// options do not fit together.
Result search(const Problem &problem, const SearchOptions &options, Evaluator &evaluator,
              const OnFinished &on_finished = {});

/// Evaluates given designs (from sampling.h), without repetition, as one batch. Throws as search() does.
Result sample(const Problem &problem, const std::vector<Design> &designs, Evaluator &evaluator,
              const OnFinished &on_finished = {});

} // namespace ballonet::optimize
