// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reference_table.h"
#include "solver/reduced/ramp_path.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace ballonet::solver::reduced;
using reference::degree;
using reference::kPa;

namespace
{

/// The run of the reference table, a row every 8 ms.
Parameters reference_run()
{
  Parameters parameters;
  parameters.ramp.duration = 0.5121;
  parameters.ramp.stop_angle = 10;
  parameters.ramp.steps_per_row = 80;
  return parameters;
}

double largest_gap_deviation(const State &state, const reference::Row &row)
{
  double largest = 0;
  const auto th = state.gap_angle();
  for (std::size_t i = 0; i < th.size(); ++i)
    largest = std::max(largest, std::abs(th[i] / degree - row.at("gap" + std::to_string(i + 1) + "_deg")));
  return largest;
}

} // namespace

TEST_CASE("the first step of the ramp, to the printed digits")
{
  const Path path = ramp_path(PebsModel(reference_run()));
  const auto row = reference::read_table("ramp_80kPa_per_s.csv").front();
  const State &state = path.rows.front();
  CHECK(state.time == Approx(row.at("t_s")));
  CHECK(state.outer_radius == Approx(row.at("b_mm")).margin(6e-5));
  CHECK(state.axial_stretch == Approx(row.at("lz")).margin(6e-6));
  CHECK(state.thrust == Approx(row.at("F_N")).margin(6e-6));
  CHECK(state.contact_pressure == Approx(row.at("q_kPa") * kPa).margin(1e-4 * kPa));
  CHECK(largest_gap_deviation(state, row) < 6e-5);
}

TEST_CASE("the ramp of 80 kPa/s against the reference trajectory")
{
  const Path path = ramp_path(PebsModel(reference_run()));
  const auto table = reference::read_table("ramp_80kPa_per_s.csv");
  REQUIRE(path.ending == Ending::complete);
  REQUIRE(path.rows.size() == table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto &row = table[i];
    const State &state = path.rows[i];
    CHECK(state.time == Approx(row.at("t_s")));
    CHECK(state.pressure == Approx(row.at("P_kPa") * kPa));
    CHECK(state.angle / degree == Approx(row.at("tip_deg")).margin(0.03)); // of -52 to 290
    CHECK(state.outer_radius == Approx(row.at("b_mm")).epsilon(1e-4));
    CHECK(state.axial_stretch == Approx(row.at("lz")).epsilon(1e-4));
    CHECK(state.thrust == Approx(row.at("F_N")).margin(1e-3));
    CHECK(largest_gap_deviation(state, row) < 0.02); // of up to 30
  }
}

TEST_CASE("gaps open at the top first: local, then global bending")
{
  const Path path = ramp_path(PebsModel{Parameters{}});
  REQUIRE(path.ending == Ending::complete);
  const auto share = [](const State &state) { return (state.al[19] - state.al[13]) / state.al[19]; };
  const auto at = [&](double angle) {
    return *std::find_if(path.rows.begin(), path.rows.end(),
                         [&](const State &s) { return s.pressure > 0.03 && s.angle >= angle * degree; });
  };
  CHECK(at(140).pressure == Approx(39.7 * kPa).margin(0.1 * kPa));
  CHECK(at(270).pressure == Approx(40.8 * kPa).margin(0.1 * kPa));
  CHECK(share(at(70)) == Approx(0.83).margin(0.02));
  CHECK(share(at(140)) == Approx(0.84).margin(0.02));
  CHECK(share(at(270)) == Approx(0.54).margin(0.02));
  CHECK(at(140).al[1] / 2 / degree == Approx(-3.4).margin(0.15));
  CHECK(participation_number(at(140).al) == Approx(0.36).margin(0.02));
}

TEST_CASE("the path ends at the stop")
{
  const Path path = ramp_path(PebsModel{Parameters{}});
  CHECK(path.rows.back().angle / degree == Approx(270).margin(9));
  CHECK(path.first(EventKind::rib_contact));
  CHECK_FALSE(path.first(EventKind::limit));
}

TEST_CASE("a time step too long for the motion is a failure with a reason")
{
  Parameters parameters;
  parameters.ramp.step = 0.02;
  parameters.ramp.duration = 20;
  const Path path = ramp_path(PebsModel(parameters));
  CHECK(path.ending == Ending::diverged);
  CHECK_FALSE(path.reason.empty());
}
