// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/virtual_work.h"

namespace ballonet::tests
{

/// Takes what a contribution assembles and does nothing with it.
class NoAssembly : public solver::Assembly
{
public:
  double sum = 0;
  int blocks = 0; ///< tangents received
  void add_residual(std::span<const solver::Node>, std::span<const double> values) override { sum += values[0]; }
  void add_tangent(std::span<const solver::Node>, std::span<const double> values) override
  {
    sum += values[0], ++blocks;
  }
};

} // namespace ballonet::tests
