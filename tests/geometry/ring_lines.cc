// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/ring_lines.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using ballonet::geometry::RingLines;
using std::numbers::pi;

namespace
{

bool has_line(const RingLines &lines, double angle)
{
  for (int i = 0; i < lines.count(); ++i)
    if (std::abs(std::remainder(lines.angle(i) - angle, 2 * pi)) < 1e-9)
      return true;
  return false;
}

} // namespace

TEST_CASE("ring lines keep to the count, rise, and close after a full turn")
{
  const RingLines lines(24, {{0.3, 0.5, 4}, {2.5, 0.5, 4}}, {-2.0});
  REQUIRE(lines.count() == 24);
  CHECK(lines.angle(24) - lines.angle(0) == Approx(2 * pi));
  CHECK(lines.angle(-1) == Approx(lines.angle(23) - 2 * pi));
  for (int i = 0; i < 24; ++i) {
    CHECK(lines.angle(i + 1) > lines.angle(i));
    CHECK(lines.angle(i + 0.5) == Approx((lines.angle(i) + lines.angle(i + 1)) / 2));
  }
}

TEST_CASE("ring lines pass through window edges and stops")
{
  const RingLines lines(24, {{0.3, 0.5, 4}, {2.5, 0.5, 4}}, {-2.0});
  for (const double angle : {-0.2, 0.3, 0.8, 2.0, 2.5, 3.0, -2.0})
    CHECK(has_line(lines, angle));
  CHECK(lines.angle(1) - lines.angle(0) == Approx(0.25));
}

TEST_CASE("a symmetric ring has symmetric lines and one at the front")
{
  const double half_arc = GENERATE(100., 120., 150., 175.) * pi / 180;
  const RingLines lines(24, {{0, 0.494, 4}}, {-half_arc, half_arc});
  CHECK(has_line(lines, pi));
  for (int i = 0; i <= 12; ++i)
    CHECK(lines.angle(24 - i) == Approx(2 * pi - lines.angle(i)));
}
