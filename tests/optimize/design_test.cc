// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/design.h"
#include <catch2/catch.hpp>
#include <limits>

using namespace ballonet::optimize;
using Catch::Matchers::Contains;

namespace
{
Variable between(double min, double max) { return {.key = "v", .min = min, .max = max}; }
} // namespace

TEST_CASE("continuous variables scale both ways without loss")
{
  const DesignSpace space({between(4.5, 11.7)});
  CHECK(space.design_at({0}) == Design{4.5});
  CHECK(space.design_at({1}) == Design{11.7});
  CHECK(space.design_at({-1e-9}) == Design{4.5});
  CHECK(space.design_at({1 + 1e-9}) == Design{11.7});
  for (int i = 0; i <= 1000; ++i) {
    const Design design = space.design_at({i / 1000.0});
    CHECK(space.design_at(space.point_of(design)) == design);
  }
  CHECK(space.design_at(space.point_of({7.2})) == Design{7.2});
}

TEST_CASE("discrete choices share the unit interval equally")
{
  const Variable count = {.key = "v", .min = 3, .max = 5, .integer = true},
                 material = {.key = "w", .values = {0.8, 0.2}};
  const DesignSpace space({count, material});
  CHECK(space.n_combinations() == 6);
  CHECK(space.design_at({0, 0}) == Design{3, 0.8});
  CHECK(space.design_at({0.34, 0.49}) == Design{4, 0.8});
  CHECK(space.design_at({0.999, 0.5}) == Design{5, 0.2});
  CHECK(space.design_at({1, 1}) == Design{5, 0.2});
  CHECK(space.point_of({4, 0.2}) == Point{0.5, 0.75});
  CHECK_THROWS_WITH(space.point_of({3.5, 0.2}), Contains("'v'") && Contains("3.5"));
}

TEST_CASE("wrong variables are refused with their name")
{
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto make = [](const Variable &variable) { return DesignSpace({variable}); };
  CHECK_THROWS_WITH(make(between(2, 1)), Contains("'v'") && Contains("below"));
  CHECK_THROWS_WITH(make(between(1, 1)), Contains("below"));
  CHECK_THROWS_WITH(make(between(nan, 1)), Contains("finite"));
  CHECK_THROWS_WITH(make(between(0, infinity)), Contains("finite"));
  Variable variable = between(0.5, 3);
  variable.integer = true;
  CHECK_THROWS_WITH(make(variable), Contains("whole"));
  variable.values = {1, 2, 1};
  CHECK_THROWS_WITH(make(variable), Contains("twice"));
  variable.values = {1, nan};
  CHECK_THROWS_WITH(make(variable), Contains("finite"));
  CHECK_THROWS_WITH(DesignSpace({between(0, 1), between(0, 1)}), Contains("twice"));
  CHECK_THROWS_WITH(make(Variable()), Contains("key"));
  const DesignSpace space({between(0, 1)});
  CHECK_THROWS_WITH(space.point_of({nan}), Contains("'v'"));
  CHECK_THROWS_AS(space.point_of({0.5, 0.5}), std::invalid_argument);
}
