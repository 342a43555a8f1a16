// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/design.h"
#include "optimize/problem.h"
#include <vector>

namespace ballonet::optimize
{

/// A design with its place in the unit box and how the problem sees it.
struct Candidate {
  Point point;
  Assessment assessment;
};

/// Sorts candidates into the order in which runs should start from them: first those with no better candidate within
/// n^(-1/dimension) of them, the mean spacing of n points in the unit box, then the others; both best first. So two
/// runs do not descend into the same valley as long as another is known. The rule of multi-level single linkage: A. H.
/// G. Rinnooy Kan, G. T. Timmer, Math. Programming 39 (1987) 57-78.
std::vector<Point> starting_order(std::vector<Candidate> candidates);

/// The points with all coordinates but the free ones replaced by those of a combination. Points that have them already
/// come first.
std::vector<Point> moved_to(const Point &combination, const std::vector<std::size_t> &free, std::vector<Point> points);

} // namespace ballonet::optimize
