// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <cmath>

namespace ballonet::solver::reduced
{

/// Root of a continuous function between `low` and `high`, where its signs must differ; by false position with the
/// Illinois rule, bisecting now and then. Accurate to rounding.
template <class Function>
double find_root(const Function &f, double low, double high)
{
  double f_low = f(low), f_high = f(high);
  for (int i = 0; i < 200 && f_low != 0 && f_high != 0; ++i) {
    const bool bisect = i % 8 == 7;
    const double x = bisect ? (low + high) / 2 : (low * f_high - high * f_low) / (f_high - f_low);
    const double f_x = f(x);
    if (f_x == 0 || std::abs(high - low) <= 1e-15 * (std::abs(low) + std::abs(high)))
      return x;
    if ((f_x > 0) == (f_high > 0)) {
      high = x, f_high = f_x, f_low /= bisect ? 1 : 2;
    } else {
      low = x, f_low = f_x, f_high /= bisect ? 1 : 2;
    }
  }
  return std::abs(f_low) < std::abs(f_high) ? low : high;
}

/// Where a function with a single maximum between `low` and `high` has it; by golden section, to 1e-6 of the interval:
/// the maximum itself to 1e-12.
template <class Function>
double find_maximum(const Function &f, double low, double high)
{
  constexpr double golden = 0.6180339887498949;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double f_a = f(a), f_b = f(b);
  for (int i = 0; i < 29; ++i)
    if (f_a > f_b) {
      high = b, b = a, f_b = f_a, a = high - golden * (high - low), f_a = f(a);
    } else {
      low = a, a = b, f_a = f_b, b = low + golden * (high - low), f_b = f(b);
    }
  return (low + high) / 2;
}

} // namespace ballonet::solver::reduced
