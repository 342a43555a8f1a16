// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/corrugation.h"
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

using ballonet::geometry::Corrugation;
using ballonet::geometry::FoldPoint;

TEST_CASE("a corrugation with rise = gap / 2 is as long as a semicircle")
{
  const Corrugation fold(2.8, 1.4, 0.4);
  CHECK(fold.length() == Approx(std::numbers::pi * 1.4));
  CHECK(fold.smallest_radius() == Approx(0.56));
  CHECK(fold.at(0.5).height == Approx(1.4));
  CHECK(fold.at(0.5).axial == Approx(1.4));
}

TEST_CASE("corrugations start and end on the wall, along the axis, with the crest at the rise")
{
  const double gap = GENERATE(1.2, 2.8, 9.0), rise = GENERATE(0.3, 0.9, 2.0), share = GENERATE(0.3, 0.5);
  const Corrugation fold(gap, rise, share);
  const FoldPoint start = fold.at(0), crest = fold.at(0.5), end = fold.at(1);
  CHECK(start.axial == Approx(0).margin(1e-12));
  CHECK(end.axial == Approx(gap));
  for (const FoldPoint &foot : {start, end}) {
    CHECK(foot.height == Approx(0).margin(1e-12));
    CHECK(foot.normal_height == Approx(1));
  }
  CHECK(crest.height == Approx(rise));
  CHECK(crest.axial == Approx(gap / 2));
}

TEST_CASE("the normal of a corrugation is perpendicular to it and the arc length is even")
{
  const Corrugation fold(2.8, GENERATE(0.4, 1.4, 2.2), 0.4);
  const double h = 1e-5;
  for (double s = 0.013; s < 1; s += 0.0731) {
    const FoldPoint before = fold.at(s - h), here = fold.at(s), after = fold.at(s + h);
    const double axial = (after.axial - before.axial) / (2 * h), height = (after.height - before.height) / (2 * h);
    CHECK(std::hypot(axial, height) == Approx(fold.length()).epsilon(1e-6));
    CHECK(axial * here.normal_axial + height * here.normal_height == Approx(0).margin(1e-3));
    CHECK(axial * here.normal_height - height * here.normal_axial > 0);
  }
}

TEST_CASE("without a rise the wall is plain")
{
  const Corrugation plain(2.8, 0, 0.4);
  CHECK(plain.length() == 2.8);
  CHECK(plain.at(0.25).axial == Approx(0.7));
  CHECK(plain.at(0.75).height == 0);
  CHECK(std::isinf(plain.smallest_radius()));
}
