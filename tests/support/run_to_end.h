// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/simulation.h"
#include <catch2/catch.hpp>

namespace ballonet::tests
{

/// Follows the whole path; a test whose path does not come to its end fails with the reason.
inline void run_to_end(solver::Simulation &simulation)
{
  const auto result = simulation.run([](const solver::PathPoint &) { return ""; }, [](const std::string &) {});
  INFO(result.reason);
  REQUIRE(result.status == solver::PathStatus::ended);
}

} // namespace ballonet::tests
