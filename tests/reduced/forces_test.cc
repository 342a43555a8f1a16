// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reference_table.h"
#include "solver/reduced/pebs_model.h"
#include "solver/reduced/rib_ring.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver::reduced;
using reference::kPa;

TEST_CASE("blocked straight with the ribs touched: thrust, base moment and tip force")
{
  const PebsModel model{Parameters{}};
  const double table[][4] = {
      {36, 3.9, 36, 0.37}, {45, 5.7, 53, 0.54}, {55, 7.7, 72, 0.73}, {64, 9.6, 89, 0.91}, {80, 12.8, 119, 1.21}};
  for (const auto &[pressure, thrust, moment, tip] : table) {
    const auto forces = model.confined_forces(pressure * kPa, 0);
    CHECK(forces.thrust == Approx(thrust).margin(0.06));
    CHECK(forces.base_moment == Approx(moment).margin(0.6));
    CHECK(forces.tip_force == Approx(tip).margin(0.006));
  }
}

TEST_CASE("blocked forces are continuous where the balloon reaches the ribs")
{
  const PebsModel model{Parameters{}};
  const double touch = model.tube().pressure(96.0 / 90, 8);
  CHECK(touch == Approx(43.6 * kPa).margin(0.1 * kPa));
  const auto before = model.blocked_forces(touch * (1 - 1e-7), 0), after = model.blocked_forces(touch * (1 + 1e-7), 0);
  CHECK_FALSE(before.touches_ribs);
  CHECK(after.touches_ribs);
  CHECK(before.thrust == Approx(after.thrust).epsilon(1e-3));
  CHECK(model.blocked_forces(36 * kPa, 0).thrust < model.confined_forces(36 * kPa, 0).thrust);
  CHECK(model.blocked_forces(55 * kPa, 0).thrust == Approx(model.confined_forces(55 * kPa, 0).thrust));
}

TEST_CASE("an upright head is pushed from the pressure on at which the balloon is as long as the cage")
{
  const PebsModel model{Parameters{}};
  CHECK(model.blocked_forces(32.46 * kPa, 0).thrust == Approx(0).margin(2e-3));
  CHECK(model.blocked_forces(33.0 * kPa, 0).thrust > 0.01);
}

TEST_CASE("rib rings: the modulus at which they open by 10 %")
{
  Parameters parameters;
  parameters.wall.youngs_modulus = 4.6;
  CHECK(ring_growth(parameters, 33 * kPa) / 8 == Approx(0.10).epsilon(0.01));
  parameters.wall.youngs_modulus = 180;
  CHECK(ring_growth(parameters, 33 * kPa) / 8 == Approx(0.003).margin(5e-4));
}
