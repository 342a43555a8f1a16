// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

namespace ballonet::optimize
{

/// How an algorithm takes inequality constraints.
enum class Constraints {
  native,    ///< itself
  augmented, ///< inside an augmented Lagrangian (NLopt's AUGLAG)
  refused    ///< not at all: global searches would be restarted for every change of the multipliers
};

/// A derivative-free algorithm of NLopt.
struct Algorithm {
  std::string name;              ///< NLopt's, without "NLOPT_": "LN_COBYLA"
  Constraints constraints;       ///< how it takes them
  std::size_t min_variables = 1; ///< it cannot work on fewer
  bool is_global() const { return name[0] == 'G'; }
};

/// All algorithms that can be asked for. NEWUOA is left out: it does not come to an end when it is stopped from
/// outside, and BOBYQA, by the same author, replaces it.
const std::vector<Algorithm> &algorithms();

/// The algorithm of a name, with or without "NLOPT_", in any case. Throws std::invalid_argument if there is none; the
/// message lists those there are and the nearest.
const Algorithm &algorithm_named(const std::string &name);

/// Throws std::invalid_argument, naming algorithms that can, if this one cannot work on so many variables and
/// constraints.
void check(const Algorithm &algorithm, std::size_t n_variables, std::size_t n_constraints);

} // namespace ballonet::optimize
