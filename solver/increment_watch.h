// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <optional>
#include <span>
#include <string>

namespace ballonet::solver
{

/// Watches how the increments of one Newton solve shrink: tells when the iteration struggles, how much of an increment
/// to trust, and when to give up. Sizes are largest components, mm.
class IncrementWatch
{
public:
  /// The fraction of the next increment to trust, at most `bearable`: an increment far beyond the first one comes from
  /// a tangent that is nearly singular and is cut down.
  double trusted(std::span<const double> increment, double bearable);

  /// Index of the largest component of that increment.
  std::size_t largest() const { return largest_; }

  /// Tells which fraction of that increment has been taken in the end.
  void taken(double fraction) { small_steps_ = fraction < 0.05 ? small_steps_ + 1 : 0; }

  /// From the third increment on: it is not much smaller than what was trusted of the one before.
  bool struggling() const { return struggling_; }

  std::optional<std::string> reason_to_give_up() const;

private:
  double first_size_ = 0, last_size_ = 0;
  std::size_t largest_ = 0;
  int increments_ = 0;
  bool struggling_ = false, held_back_ = false; ///< the latter: not all of the last increment was bearable
  int struggles_ = 0;   ///< increments that did not shrink although all of the one before was bearable
  int small_steps_ = 0; ///< in a row
};

} // namespace ballonet::solver
