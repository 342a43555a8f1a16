// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/problem.h"
#include <string>
#include <vector>

namespace ballonet::optimize
{

/// What an algorithm is told about a point: the value to minimize, and constraints that hold where they are <= 0.
struct Answer {
  double cost = 0;
  std::vector<double> constraints;
};

/// Turns assessments into answers. A usable evaluation is passed on as it is. A failed one has no value, yet algorithms
/// want one; the substitute is made here, is counted, is told to the algorithm only, and is never recorded:
///
/// * An algorithm that takes constraints gets one more constraint, "can be evaluated": -1 at usable designs, 1 + d at
///   failed ones, together with the worst cost and the worst violations seen so far.
/// * An algorithm without constraints gets cost = worst + (worst - best) d of the costs seen so far (d alone if they
///   are all equal), so that a failed design is never better than a usable one and failing less deeply is better.
///
/// d is the distance to the nearest usable design in the unit box, divided by its diagonal; 1 if there is none yet.
class Presentation
{
public:
  Presentation(std::size_t n_bounds, bool takes_constraints);

  /// Length of Answer::constraints.
  std::size_t n_constraints() const { return takes_constraints_ ? n_bounds_ + 1 : 0; }

  /// Takes note of an evaluation. Everything known is to be learned before the first answer is made.
  void learn(const Point &point, const Assessment &assessment);

  /// What to tell the algorithm about the design at a point.
  Answer answer(const Point &point, const Assessment &assessment);

  /// How many answers were substitutes so far.
  std::size_t n_substituted() const { return n_substituted_; }

  /// One sentence on the rule in use.
  std::string description() const;

private:
  double distance_to_usable(const Point &point) const;

  std::size_t n_bounds_;
  bool takes_constraints_;
  std::vector<Point> usable_;
  double best_cost_ = 0, worst_cost_ = 0;
  std::vector<double> worst_violations_;
  std::size_t n_substituted_ = 0;
};

} // namespace ballonet::optimize
