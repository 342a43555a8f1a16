// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reference_table.h"
#include "solver/reduced/history_row.h"
#include <catch2/catch.hpp>
#include <map>

using namespace ballonet::solver::reduced;
using reference::degree;

namespace
{

std::map<std::string, double> row_at(const PebsModel &model, double angle)
{
  State state = *model.state_at(angle);
  model.judge(state, Stage::separation);
  const auto row = history_row(model, state);
  return {row.begin(), row.end()};
}

} // namespace

TEST_CASE("a state in the columns of a history")
{
  const PebsModel model{Parameters{}};
  const auto row = row_at(model, 0.5);
  CHECK(row.size() == 18 + 20);
  CHECK(row.at("pressure_kPa") == Approx(35.78).margin(0.03));
  CHECK(row.at("bending_angle_deg") == Approx(0.5 / degree));
  CHECK(row.at("rib_contact_fraction") == 0);
  CHECK(row.at("max_bulge_mm") == Approx(row.at("radial_ratio") * 3.6 - 8));
  CHECK(row.at("volume_ratio") == Approx(row.at("volume_mm3") / (std::numbers::pi * 3.1 * 3.1 * 90)));
  double sum = 0;
  for (const auto &[name, value] : row)
    sum += name.starts_with("gap_") ? value : 0;
  CHECK(sum == Approx(row.at("bending_angle_deg")));
  CHECK(row.count("gap_01_deg") + row.count("gap_20_deg") == 2);
}

TEST_CASE("the tip lies on the axis of the straight actuator, and moves along a circle when it bends evenly")
{
  const PebsModel model{Parameters{}};
  State state = model.straight();
  auto row = history_row(model, state);
  std::map<std::string, double> at(row.begin(), row.end());
  CHECK(at.at("tip_x_mm") == Approx(0).margin(1e-12));
  CHECK(at.at("tip_z_mm") == Approx(20 * 4.8 + 1)); // middle of a head 2 mm thick
  for (std::size_t i = 0; i < state.al.size(); ++i)
    state.al[i] = degree * 4.5 * static_cast<double>(i + 1); // a right angle at the head
  row = history_row(model, state);
  at = {row.begin(), row.end()};
  const double radius = 4.8 / degree / 4.5, e = model.hinge().lever; // of the wall's bend, for small pitches
  CHECK(at.at("tip_x_mm") == Approx(-e - radius).margin(3.5));
  CHECK(at.at("tip_z_mm") == Approx(radius + e).margin(3.5));
}

TEST_CASE("on the ribs they open, and the widest gap bulges most")
{
  const PebsModel model{Parameters{}};
  const auto row = row_at(model, 300 * degree);
  CHECK(row.at("rib_contact_fraction") == 1);
  CHECK(row.at("rib_opening_mm") > 0);
  CHECK(row.at("max_bulge_mm") > 0);
  CHECK(row.at("localisation_index") > 1);
}
