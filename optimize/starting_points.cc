// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/starting_points.h"
#include <algorithm>
#include <cmath>

namespace ballonet::optimize
{

namespace
{
double distance(const Point &a, const Point &b)
{
  double square = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    square += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(square);
}
} // namespace

std::vector<Point> starting_order(std::vector<Candidate> candidates)
{
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate &a, const Candidate &b) { return is_better(a.assessment, b.assessment); });
  std::vector<Point> alone, crowded;
  for (auto candidate = candidates.begin(); candidate != candidates.end(); ++candidate) {
    const double dimension = static_cast<double>(candidate->point.size());
    const double spacing = std::pow(static_cast<double>(candidates.size()), -1 / dimension);
    const bool is_alone = std::none_of(candidates.begin(), candidate, [&](const Candidate &better) {
      return distance(better.point, candidate->point) < spacing;
    });
    (is_alone ? alone : crowded).push_back(candidate->point);
  }
  alone.insert(alone.end(), crowded.begin(), crowded.end());
  return alone;
}

std::vector<Point> moved_to(const Point &combination, const std::vector<std::size_t> &free, std::vector<Point> points)
{
  const auto moved = [&](const Point &point) {
    Point result = combination;
    for (const std::size_t i : free)
      result[i] = point[i];
    return result;
  };
  std::stable_partition(points.begin(), points.end(), [&](const Point &point) { return moved(point) == point; });
  std::transform(points.begin(), points.end(), points.begin(), moved);
  return points;
}

} // namespace ballonet::optimize
