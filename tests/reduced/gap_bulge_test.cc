// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reference_table.h"
#include "solver/reduced/gap_bulge.h"
#include "solver/reduced/pebs_model.h"
#include <catch2/catch.hpp>
#include <cmath>

using namespace ballonet::solver::reduced;
using reference::degree;
using reference::kPa;

namespace
{

PebsModel with_gap_ratio(double ratio)
{
  Parameters parameters;
  parameters.ribs.width = 4.8 / (1 + ratio);
  parameters.ribs.gap = 4.8 - parameters.ribs.width;
  return PebsModel(parameters);
}

} // namespace

TEST_CASE("opening pressures: the slipping bulge passes the ribs' outer radius, or runs out")
{
  struct Case {
    double ratio, pressure[3], runaway[3]; // at 0, 140 and 270 deg, evenly bent; 0: not given
  };
  const Case cases[] = {{0.5, {121, 83.8, 62.6}, {121, 85.0, 70.7}}, {1.0, {95.4, 71.9, 55.2}, {0, 75.3, 64.8}},
                        {1.4, {88.0, 67.2, 52.2}, {0, 71.7, 62.4}},  {1.9, {83.1, 63.6, 49.9}, {0, 69.0, 60.6}},
                        {2.5, {79.5, 61.1, 48.2}, {0, 67.0, 59.2}},  {4.0, {75.0, 57.8, 46.1}, {0, 64.5, 57.4}}};
  const double angles[] = {0, 140 * degree, 270 * degree};
  for (const Case &c : cases) {
    const PebsModel model = with_gap_ratio(c.ratio);
    for (int i = 0; i < 3; ++i) {
      const double z = model.stretch(angles[i], 0), th = angles[i] / 20;
      const double margin = (i == 0 ? 0.5 : 0.36) * kPa; // bent, the table has a stretch about 0.02 larger
      CHECK(model.gap_bulge().slip_pressure(1.5, z, th) == Approx(c.pressure[i] * kPa).margin(margin));
      if (c.runaway[i] > 0)
        CHECK(model.gap_bulge().runaway_pressure(z, th) == Approx(c.runaway[i] * kPa).margin(margin));
    }
  }
}

TEST_CASE("single-gap angles at which the balloon runs out")
{
  const PebsModel model{Parameters{}};
  const double z = model.stretch(200 * degree, 0);
  const double table[][2] = {{40, 44}, {45, 32}, {50, 24}, {55, 19}, {64, 12}};
  for (const auto &[pressure, angle] : table) {
    CHECK(model.gap_bulge().slip_ratio(pressure * kPa, z, (angle - 1) * degree) < 1);
    CHECK(model.gap_bulge().slip_ratio(pressure * kPa, z, (angle + 1) * degree) > 1);
  }
}

TEST_CASE("a sticking balloon passes the ribs earlier than a slipping one")
{
  const PebsModel model = with_gap_ratio(1.9);
  const double z = model.stretch(140 * degree, 0), th = 7 * degree;
  CHECK(model.gap_bulge().stick_pressure(1.5, z, th) == Approx(60.2 * kPa).margin(0.6 * kPa)); // 59.7 here
  CHECK(model.gap_bulge().stick_pressure(1.5, z, th) < model.gap_bulge().slip_pressure(1.5, z, th));
}

TEST_CASE("height and pressure of the slipping bulge belong together")
{
  const PebsModel model{Parameters{}};
  const GapBulge &bulge = model.gap_bulge();
  const double z = 1.3, th = 0.1;
  for (double height : {0.2, 1.0, 1.8})
    CHECK(bulge.slip_height(bulge.slip_pressure(height, z, th), z, th) == Approx(height));
  CHECK(bulge.slip_height(bulge.slip_pressure(0, z, th) - 1 * kPa, z, th) == 0);
  CHECK(std::isinf(bulge.slip_height(bulge.runaway_pressure(z, th) * 1.001, z, th)));
  // A shallow arc: d = g_f chi / 4.
  const double chi = bulge.slip_ratio(bulge.slip_pressure(0.01, z, th), z, th);
  CHECK(0.01 == Approx(bulge.front_gap(th) * chi / 4).epsilon(1e-4));
}
