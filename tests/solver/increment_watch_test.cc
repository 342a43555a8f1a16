// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/increment_watch.h"
#include <catch2/catch.hpp>
#include <vector>

using ballonet::solver::IncrementWatch;

namespace
{

/// Fraction trusted of an increment whose largest component is `size`, all of it bearable and taken.
double next(IncrementWatch &watch, double size)
{
  const double fraction = watch.trusted(std::vector<double>{0.1 * size, -size}, 1);
  watch.taken(fraction);
  return fraction;
}

} // namespace

TEST_CASE("increments that shrink are trusted")
{
  IncrementWatch watch;
  for (const double size : {1., 0.9, 0.1, 1e-3}) {
    CHECK(next(watch, size) == 1);
    CHECK_FALSE(watch.struggling());
  }
}

TEST_CASE("an increment far beyond the first is cut down to twice its size")
{
  IncrementWatch watch;
  CHECK(next(watch, 1) == 1);
  CHECK(next(watch, 8) == Approx(0.25));
  CHECK(watch.trusted(std::vector<double>{8.}, 0.1) == Approx(0.1)); // less is bearable
}

TEST_CASE("increments that do not shrink are given up in the end")
{
  IncrementWatch watch;
  int increments = 0;
  for (; !watch.reason_to_give_up(); ++increments)
    next(watch, 1);
  CHECK(watch.struggling());
  CHECK(increments == 14); // the first two do not count
  CHECK_THAT(*watch.reason_to_give_up(), Catch::Contains("do not shrink"));
}

TEST_CASE("increments that were not all bearable need not shrink")
{
  IncrementWatch watch;
  for (int k = 0; k < 20; ++k) {
    watch.trusted(std::vector<double>{1.}, 0.5);
    watch.taken(0.5);
  }
  CHECK_FALSE(watch.reason_to_give_up());
}

TEST_CASE("small fractions in a row are given up, but not after a full one")
{
  IncrementWatch watch;
  for (const double fraction : {0.01, 0.01, 0.01, 1., 0.01, 0.01, 0.01})
    watch.taken(fraction);
  CHECK_FALSE(watch.reason_to_give_up());
  watch.taken(0.01);
  CHECK_THAT(*watch.reason_to_give_up(), Catch::Contains("less than 5 %"));
}
