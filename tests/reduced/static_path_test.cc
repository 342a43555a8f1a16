// SPDX-License-Identifier: LGPL-2.1-or-later
#include "reference_table.h"
#include "solver/reduced/pebs_path.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

using namespace ballonet::solver::reduced;
using reference::degree;
using reference::kPa;

namespace
{

double upright_pressure(const Parameters &parameters)
{
  const Path path = static_path(PebsModel(parameters));
  REQUIRE(path.ending == Ending::complete);
  REQUIRE(path.first(EventKind::upright));
  return path.first(EventKind::upright)->pressure;
}

} // namespace

// The table rounds its angles to 5e-4 deg, which is up to 2e-6 N and 5e-7 rad.
TEST_CASE("the static path with the reference's wall lengthening, to its printed digits")
{
  const PebsModel model{Parameters{}};
  State state = model.straight();
  double thrust_before = 0;
  for (const auto &row : reference::read_table("static_design.csv")) {
    const auto next =
        model.state_at_lengthening(row.at("tip_deg") * degree, model.wall_lengthening(thrust_before), state);
    REQUIRE(next);
    CHECK(next->pressure == Approx(row.at("P_kPa") * kPa).epsilon(1e-4));
    CHECK(next->outer_radius == Approx(row.at("b_mm")).epsilon(2e-5));
    CHECK(next->axial_stretch == Approx(row.at("lz")).margin(6e-5));
    CHECK(next->thrust == Approx(row.at("F_N")).epsilon(1e-4).margin(2e-6));
    CHECK(next->contact_pressure == Approx(row.at("q_kPa") * kPa).margin(1e-4 * kPa));
    CHECK(next->balloon_stiffness == Approx(row.at("k_balloon")).epsilon(5e-5));
    const auto th = next->gap_angle();
    const auto widest = std::max_element(th.begin(), th.end());
    CHECK(*widest == Approx(row.at("thmax_rad")).epsilon(2e-4).margin(5e-7));
    CHECK(static_cast<double>(widest - th.begin() + 1) == row.at("gap_of_max"));
    state = *next;
    thrust_before = state.thrust;
  }
}

TEST_CASE("the converged static path")
{
  const PebsModel model{Parameters{}};
  State state = model.straight();
  for (const auto &row : reference::read_table("static_design.csv")) {
    const auto next = model.state_at(row.at("tip_deg") * degree, state);
    REQUIRE(next);
    CHECK(next->pressure == Approx(row.at("P_kPa") * kPa).epsilon(2e-4));
    CHECK(next->outer_radius == Approx(row.at("b_mm")).epsilon(2e-4));
    CHECK(next->thrust == Approx(row.at("F_N")).epsilon(2e-4).margin(2e-6));
    CHECK(next->contact_pressure == Approx(row.at("q_kPa") * kPa).margin(6e-3 * kPa));
    state = *next;
  }
}

TEST_CASE("events, limit and stages of the default path")
{
  const Path path = static_path(PebsModel{Parameters{}});
  REQUIRE(path.ending == Ending::complete);
  CHECK(path.rows.back().angle / degree == Approx(270));
  CHECK(path.rows.front().pressure >= 0);
  CHECK(path.first(EventKind::upright)->pressure == Approx(32.93 * kPa).margin(0.03 * kPa));
  CHECK(path.first(EventKind::limit)->pressure == Approx(36.385 * kPa).margin(1e-3 * kPa));
  CHECK(path.first(EventKind::limit)->angle / degree == Approx(59).margin(1));
  CHECK(path.first(EventKind::rib_contact)->angle / degree == Approx(250.8).margin(0.2));
  CHECK(path.first(EventKind::head_contact)->angle < 0);
  CHECK(std::is_sorted(path.rows.begin(), path.rows.end(),
                       [](const State &a, const State &b) { return a.stage < b.stage; }));
  CHECK(path.rows.back().stage == Stage::sufficient);
  CHECK(path.rows.front().stage == Stage::separation);
}

TEST_CASE("the angle seen under slowly rising pressure jumps at the limit to the stop")
{
  const Path path = static_path(PebsModel{Parameters{}});
  CHECK(*path.angle_at(35.9 * kPa) / degree == Approx(31.3).margin(0.3));
  CHECK(*path.angle_at(64 * kPa) / degree == Approx(270));
  Path broken = path;
  broken.ending = Ending::no_equilibrium;
  CHECK_FALSE(broken.angle_at(64 * kPa));
}

TEST_CASE("the pressure at 0 deg follows C10, not the backbone")
{
  const double table[][2] = {{0.12, 24.8}, {0.14, 28.9}, {0.16, 32.9}, {0.18, 37.0}};
  for (const auto &[c10, pressure] : table) {
    Parameters parameters;
    parameters.balloon.c10 = c10;
    CHECK(upright_pressure(parameters) == Approx(pressure * kPa).margin(0.12 * kPa));
  }
  for (double modulus : {160.0, 200.0, 280.0}) {
    Parameters parameters;
    parameters.wall.youngs_modulus = modulus;
    CHECK(upright_pressure(parameters) == Approx(32.9 * kPa).margin(0.1 * kPa));
  }
}

TEST_CASE("sensitivity of the limit and of the pressure at 270 deg, by 10 % each way")
{
  const auto pressures = [](const std::function<double &(Parameters &)> &value, double factor, double limit,
                            double end) {
    Parameters parameters;
    value(parameters) *= factor;
    const Path path = static_path(PebsModel(parameters));
    REQUIRE(path.first(EventKind::limit));
    CHECK(path.first(EventKind::limit)->pressure == Approx(limit * kPa).margin(0.07 * kPa));
    CHECK(path.rows.back().pressure == Approx(end * kPa).margin(0.07 * kPa));
  };
  const auto thickness = [](Parameters &p) -> double & { return p.wall.thickness; };
  const auto radius = [](Parameters &p) -> double & { return p.ribs.inner_radius; };
  const auto rise = [](Parameters &p) -> double & { return p.wall.rise; };
  const auto wall = [](Parameters &p) -> double & { return p.balloon.wall; };
  const auto diameter = [](Parameters &p) -> double & { return p.balloon.diameter; };
  const auto length = [](Parameters &p) -> double & { return p.balloon.length; };
  pressures(thickness, 0.9, 36.3, 31.3);
  pressures(thickness, 1.1, 36.5, 33.2);
  pressures(radius, 0.9, 36.5, 38.8);
  pressures(radius, 1.1, 36.3, 29.6);
  pressures(rise, 0.9, 36.4, 32.5);
  pressures(rise, 1.1, 36.4, 31.9);
  pressures(wall, 0.9, 32.5, 29.4);
  pressures(wall, 1.1, 40.3, 34.9);
  pressures(diameter, 0.9, 40.8, 34.1);
  pressures(diameter, 1.1, 32.9, 35.1);
  pressures(length, 0.9, 36.0, 35.4);
  pressures(length, 1.1, 36.8, 33.1);
}

TEST_CASE("a stiff hinge reaches the ribs at a smaller angle and its pressure rises after")
{
  Parameters parameters;
  parameters.wall.youngs_modulus *= 207 / 25.656; // k = 207 N mm/rad
  const Path path = static_path(PebsModel(parameters));
  REQUIRE(path.first(EventKind::rib_contact));
  CHECK(path.first(EventKind::rib_contact)->angle / degree == Approx(140).margin(5));
  CHECK(path.rows.back().pressure == Approx(55 * kPa).margin(1.5 * kPa));
}

TEST_CASE("answers that need no path")
{
  const Answers result = answers(PebsModel{Parameters{}});
  CHECK(result.overload_index == Approx(0.56).margin(0.005));
  CHECK(*result.backbone_droop / degree == Approx(-39.2).margin(0.05));
  CHECK(*result.droop / degree == Approx(-51.7).margin(0.05));
  CHECK(result.free_limit.pressure == Approx(35.88 * kPa).margin(0.01 * kPa));
  CHECK(participation_number({0.1, 0.2, 0.3}) == Approx(1));
  CHECK(participation_number({0.3, 0.3, 0.3}) == Approx(1.0 / 3));
}

TEST_CASE("a cage whose head is already past the stop is a failure with a reason")
{
  Parameters parameters;
  parameters.static_path.stop_angle = 0;
  parameters.balloon.length = 120;
  const Path path = static_path(PebsModel(parameters));
  CHECK(path.ending == Ending::no_equilibrium);
  CHECK_FALSE(path.reason.empty());
  CHECK(path.rows.empty());
}

TEST_CASE("wrong parameters are refused by name")
{
  using Catch::Matchers::Contains;
  Parameters parameters;
  parameters.ribs.gap = -1;
  CHECK_THROWS_WITH(PebsModel(parameters), Contains("ribs.gap"));
  parameters = {};
  parameters.balloon.c10 = std::nan("");
  CHECK_THROWS_WITH(PebsModel(parameters), Contains("balloon.c10"));
  parameters = {};
  parameters.balloon.diameter = 16;
  CHECK_THROWS_WITH(PebsModel(parameters), Contains("balloon.diameter"));
}
