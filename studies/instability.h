// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/instability_criteria.h"

namespace ballonet::studies
{

/// The word of a class: "interaction_failure", ...
std::string word_of(PathClass path_class);

/// Throws std::invalid_argument if there is no such class.
PathClass path_class_of(const std::string &word);

/// How a path ended.
struct PathEnd {
  bool numerical =
      false; ///< it stopped where the actuator does not: no equilibrium found, too many steps, no time left
  std::string reason;
};

/// What a path says about the stability of its actuator.
struct Judgement {
  PathClass path_class = PathClass::not_converged;
  std::string reason;              ///< in words
  std::string stage;               ///< reached at the end of the path, a word; empty if the path has no stages
  std::vector<Criterion> criteria; ///< of a path that is not_converged as far as it goes: they decide nothing
  std::vector<SnapThrough> snaps;  ///< likewise

  /// Distance from a class, see margin_of(); NaN for a path that is not_converged.
  double margin(PathClass other) const;

  /// The smallest of the margins of the three instabilities (interaction_failure, losing_control, overload).
  double margin() const;
};

/// Judges a path by its rows in history.csv and by nothing else. A path that ended before the pressure window did is
/// judged by what there is, and the reason says so. Leaves the stage to the caller.
Judgement judge_path(const std::vector<Row> &rows, const Judge &judge, const JudgedActuator &actuator,
                     const PathEnd &end);

} // namespace ballonet::studies
