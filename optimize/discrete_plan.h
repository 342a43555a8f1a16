// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/design.h"
#include <string>
#include <vector>

namespace ballonet::optimize
{

/// How integers and lists of values are searched.
enum class DiscreteTreatment {
  none,       ///< there are none
  exhaustive, ///< nothing else varies and every combination is evaluated
  enumerated, ///< every combination gets its own runs over the continuous variables
  rounded     ///< the algorithm sees [0, 1], its points are rounded to the nearest choice
};

/// Which coordinates the algorithm works on and at which values the others are held.
struct DiscretePlan {
  DiscreteTreatment treatment = DiscreteTreatment::none;
  std::vector<std::size_t> free;   ///< coordinates the algorithm works on
  std::vector<Point> combinations; ///< one point for each set of runs; only the coordinates that are not free count
  std::string description;         ///< the treatment in words, with the numbers that decided
};

/// Chooses the treatment. Exhaustive if nothing is continuous and the budget covers all combinations; enumerated if
/// there are at most `limit` combinations and the budget gives each of its `starts` runs at least five evaluations per
/// continuous variable and one more (with less, a local algorithm has no time to move); else rounded.
DiscretePlan plan_discrete(const DesignSpace &space, std::size_t limit, std::size_t starts, std::size_t budget);

} // namespace ballonet::optimize
