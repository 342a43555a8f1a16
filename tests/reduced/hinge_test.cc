// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/hinge.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver::reduced;

TEST_CASE("a semicircular corrugation")
{
  const Parameters parameters;
  const Hinge hinge = make_hinge(parameters);
  const double pi = std::numbers::pi, c = 1.4, bending = 180 * 0.512 / (12 * (1 - 0.2025));
  CHECK(hinge.fold_length == Approx(pi * c));
  CHECK(hinge.lever == Approx(8.4 + 2 * c / pi));
  CHECK(hinge.strip_stiffness == Approx(bending * 8.3 / (pi * c)));
  CHECK(8.3 / hinge.axial_stiffness == Approx((pi / 2 - 4 / pi) * c * c * c / bending + pi * c / 2 / (180 * 0.8)));
  CHECK(hinge.stiffness() == Approx(25.656398766).epsilon(1e-6));
  CHECK(hinge.lever == Approx(9.291267635).epsilon(1e-7));
  CHECK(hinge.axial_stiffness == Approx(83).epsilon(1e-3));
}

TEST_CASE("other rises are ellipses")
{
  const double table[][2] = {{0, 67}, {0.7, 47}, {1.0, 36}, {1.4, 26}, {2.0, 18}};
  for (const auto &[rise, stiffness] : table) {
    Parameters parameters;
    parameters.wall.rise = rise;
    CHECK(make_hinge(parameters).stiffness() == Approx(stiffness).margin(0.52));
  }
}

TEST_CASE("a plain strip has no offset, a flat one no curvature stiffness")
{
  Parameters parameters;
  parameters.wall.rise = 0;
  parameters.wall.curved = false;
  const Hinge hinge = make_hinge(parameters);
  CHECK(hinge.fold_length == Approx(2.8));
  CHECK(hinge.lever == Approx(8.4));
  CHECK(hinge.curvature_stiffness == 0);
  CHECK(hinge.axial_stiffness == Approx(180 * 0.8 * 8.3 / 2.8));
}
