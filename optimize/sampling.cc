// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/sampling.h"
#include <numeric>
#include <random>
#include <set>
#include <stdexcept>

namespace ballonet::optimize
{

namespace
{
/// Uniform in [0, 1) from the upper 53 bits: std::uniform_real_distribution differs between libraries.
double uniform(std::mt19937_64 &engine) { return static_cast<double>(engine() >> 11) * 0x1p-53; }

/// Random permutation of 0 ... n - 1 (Fisher-Yates): std::shuffle differs between libraries.
std::vector<std::size_t> permutation(std::size_t n, std::mt19937_64 &engine)
{
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  for (std::size_t i = n; i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(uniform(engine) * static_cast<double>(i))]);
  return order;
}

std::vector<double> coordinates_of_levels(const DesignSpace &space, std::size_t i, std::size_t n_levels)
{
  std::vector<double> coordinates;
  for (std::size_t choice = 0; choice < space.n_choices(i); ++choice)
    coordinates.push_back(space.choice_coordinate(i, choice));
  if (space.is_discrete(i))
    return coordinates;
  if (n_levels == 0)
    throw std::invalid_argument("variable '" + space.variable(i).key + "': a grid needs at least one level");
  if (n_levels == 1)
    return {0.5};
  for (std::size_t level = 0; level < n_levels; ++level)
    coordinates.push_back(static_cast<double>(level) / static_cast<double>(n_levels - 1));
  return coordinates;
}
} // namespace

std::vector<Point> latin_hypercube(std::size_t n, std::size_t dimension, std::uint64_t seed)
{
  std::mt19937_64 engine(seed);
  std::vector<Point> points(n, Point(dimension));
  for (std::size_t i = 0; i < dimension; ++i) {
    const std::vector<std::size_t> interval = permutation(n, engine);
    for (std::size_t p = 0; p < n; ++p)
      points[p][i] = (static_cast<double>(interval[p]) + uniform(engine)) / static_cast<double>(n);
  }
  return points;
}

std::vector<Point> full_factorial(const DesignSpace &space, const std::vector<std::size_t> &levels)
{
  if (levels.size() != space.size())
    throw std::invalid_argument("a grid needs one number of levels per variable");
  std::vector<Point> points = {Point()};
  for (std::size_t i = 0; i < space.size(); ++i) {
    std::vector<Point> longer;
    for (const Point &point : points)
      for (const double coordinate : coordinates_of_levels(space, i, levels[i])) {
        longer.push_back(point);
        longer.back().push_back(coordinate);
      }
    points = std::move(longer);
  }
  return points;
}

std::vector<Design> designs_at(const DesignSpace &space, const std::vector<Point> &points)
{
  std::vector<Design> designs;
  std::set<Design> seen;
  for (const Point &point : points)
    if (Design design = space.design_at(point); seen.insert(design).second)
      designs.push_back(std::move(design));
  return designs;
}

} // namespace ballonet::optimize
