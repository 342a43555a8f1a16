// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>

namespace ballonet::tests
{

/// A measured number beside the one it should be.
struct Comparison {
  enum class Kind {
    relative, ///< |measured / expected - 1| <= tolerance
    absolute, ///< |measured - expected| <= tolerance
    at_least  ///< measured >= expected; no tolerance
  };
  std::string what;   ///< verification case and quantity
  std::string source; ///< where the expected number comes from
  double expected = 0, measured = 0, tolerance = 0;
  std::string unit = "1";
  Kind kind = Kind::relative;

  double error() const;
  bool holds() const;
};

/// Checks the comparison. When the environment variable BALLONET_VERIFICATION_OUT names a file, rank 0 also appends it
/// there as one line of JSON: doc/verification.md is made of these lines.
void compare(const Comparison &);

} // namespace ballonet::tests
