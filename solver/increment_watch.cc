// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/increment_watch.h"
#include <algorithm>
#include <cmath>

namespace ballonet::solver
{

double IncrementWatch::trusted(std::span<const double> increment, double bearable)
{
  constexpr double growth = 2, shrink = 0.5;
  const auto largest = std::max_element(increment.begin(), increment.end(),
                                        [](double a, double b) { return std::abs(a) < std::abs(b); });
  largest_ = largest - increment.begin();
  const double size = std::abs(*largest);
  ++increments_;
  if (increments_ == 1)
    first_size_ = size;
  struggling_ = increments_ > 2 && size > shrink * last_size_;
  struggles_ += struggling_ && !held_back_;
  held_back_ = bearable < 1;
  const double fraction = std::min(bearable, size > growth * first_size_ ? growth * first_size_ / size : 1.);
  last_size_ = fraction * size;
  return fraction;
}

std::optional<std::string> IncrementWatch::reason_to_give_up() const
{
  if (small_steps_ >= 4)
    return "four iterations in a row could take less than 5 % of their step";
  if (struggles_ >= 12)
    return "the increments do not shrink";
  return {};
}

} // namespace ballonet::solver
