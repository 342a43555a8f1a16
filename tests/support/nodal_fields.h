// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/parameters.h"
#include "solver/types.h"
#include <algorithm>
#include <cmath>
#include <random>
#include <span>

/// Fields with three values per node, and sums over them.
namespace ballonet::tests
{

inline std::vector<double> random_field(std::size_t size, double scale, unsigned seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> value(-scale, scale);
  std::vector<double> field(size);
  for (double &v : field)
    v = value(generator);
  return field;
}

/// Infinity for fields of different sizes.
inline double largest_difference(std::span<const double> a, std::span<const double> b)
{
  double largest = a.size() == b.size() ? 0 : solver::infinity;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
    largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

inline solver::State moved(solver::State state, std::span<const double> by, double fraction)
{
  for (std::size_t i = 0; i < by.size(); ++i)
    state.displacement[i] += fraction * by[i];
  return state;
}

inline double dot(std::span<const double> a, std::span<const double> b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += a[i] * b[i];
  return sum;
}

inline double norm(std::span<const double> a) { return std::sqrt(dot(a, a)); }

} // namespace ballonet::tests
