// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "optimize/design.h"
#include <cstdint>
#include <vector>

namespace ballonet::optimize
{

/// Latin hypercube in the unit box: in every coordinate, each of n equal intervals holds exactly one of the n points,
/// at a random place in it. The same seed gives the same points with every compiler and library.
/// M. D. McKay, R. J. Beckman, W. J. Conover, Technometrics 21 (1979) 239-245.
std::vector<Point> latin_hypercube(std::size_t n, std::size_t dimension, std::uint64_t seed);

/// Every combination of a number of levels per variable, the last variable running fastest. Levels of a continuous
/// variable are equidistant and include both ends (a single level is the middle); a discrete variable takes all its
/// choices, whatever its entry in levels. Throws std::invalid_argument if the length of levels is not the number of
/// variables or the level of a continuous variable is 0.
std::vector<Point> full_factorial(const DesignSpace &space, const std::vector<std::size_t> &levels);

/// The designs at the points, in order, without repetition.
std::vector<Design> designs_at(const DesignSpace &space, const std::vector<Point> &points);

} // namespace ballonet::optimize
