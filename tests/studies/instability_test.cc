// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/history_row.h"
#include "studies/instability.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace ballonet::studies;

namespace
{

using enum PathClass;

/// Ribs of 1.5 mm x 2 mm in a cage of 8 mm; the limit pressure lies at 0.56 of the window.
const JudgedActuator actuator = {8, 1.5, 2, 3.6, 0.0358};
const Judge defaults;

/// One state of a synthetic path; what a case is not about is harmless.
struct Point {
  double pressure, angle;
  double bulge = 0, localisation = 1, opening = 0.1, touched = 1, radial_ratio = 2.1;
  std::vector<double> gaps = {}; // empty: four alike

  Row row(std::size_t number) const
  {
    Row row = {{"step", static_cast<double>(number)},
               {"pressure_kPa", pressure},
               {"volume_mm3", 1000. * static_cast<double>(number)},
               {"bending_angle_deg", angle},
               {"radial_ratio", radial_ratio},
               {"max_bulge_mm", bulge},
               {"localisation_index", localisation},
               {"rib_contact_fraction", touched},
               {"rib_opening_mm", opening}};
    const auto openings = gaps.empty() ? std::vector<double>(4, angle / 4) : gaps;
    for (std::size_t k = 0; k < openings.size(); ++k)
      row.emplace_back("gap_0" + std::to_string(k + 1) + "_deg", openings[k]);
    return row;
  }
};

using Path = std::vector<Point>;

/// Droop, limit pressure, snap onto the ribs, steady bending to the end of the window.
Path stable_path()
{
  return {{5, -50, -4, 1, 0, 0, 1},          {30, -10, -3, 1, 0, 0, 1.3}, {36, 58, -1, 1, 0, 0, 1.6},
          {32, 150, 0.2, 4, 0.05, 0.5, 1.9}, {36, 190, 0.5, 1, 0.1},      {50, 210, 0.9, 1.1, 0.1},
          {64, 240, 1.2, 1.1, 0.2}};
}

Judgement judged(const Path &path, const PathEnd &end = {false, "path.pressure_max is reached"},
                 const Judge &judge = defaults, const JudgedActuator &about = actuator)
{
  std::vector<Row> rows;
  for (const Point &point : path)
    rows.push_back(point.row(rows.size()));
  return judge_path(rows, judge, about, end);
}

/// The stable path with a change to its last point.
template <class Change>
Path ending(const Change &change)
{
  Path path = stable_path();
  change(path.back());
  return path;
}

const Criterion &criterion(const Judgement &judgement, const std::string &name)
{
  return *std::find_if(judgement.criteria.begin(), judgement.criteria.end(),
                       [&](const Criterion &c) { return c.name == name; });
}

double margin(const Judgement &judgement, const std::string &name) { return criterion(judgement, name).margin; }

std::vector<double> gaps_of(double one, double others) { return {one, others, others, others}; }

} // namespace

TEST_CASE("a stable path far enough bent is normal, with its distance from every instability")
{
  const Judgement j = judged(stable_path());
  REQUIRE(j.path_class == normal);
  REQUIRE(margin(j, "bulge_limit") == Approx((3.5 - 1.2) / 3.5));
  REQUIRE(margin(j, "rib_opening") == Approx((0.1 - 0.2 / 8) / 0.1));
  REQUIRE(margin(j, "escape_bulge") == Approx((1.5 - 0.5) / 1.5));
  REQUIRE(margin(j, "participation") == Approx(1));
  REQUIRE(margin(j, "gap_ratio") == Approx(0.6));
  REQUIRE(margin(j, "angle_fall") == Approx(1));
  REQUIRE(margin(j, "droop_angle") == Approx((90. - 50) / 90));
  REQUIRE(margin(j, "overload_angle") == Approx((240. - 90) / 90));
  REQUIRE(margin(j, "overload_index") == Approx(1 - 0.0358 / 0.064));
  REQUIRE(margin(j, "overload_radius") == Approx((2.1 * 3.6 / 8 - 0.7) / 0.7));
  REQUIRE(margin(j, "normal_angle") == Approx((240. - 180) / 180));
  REQUIRE(j.margin(interaction_failure) == Approx((3.5 - 1.2) / 3.5)); // of 0.657, 0.75, 0.667 and the runaway's
  REQUIRE(j.margin(losing_control) == Approx((90. - 50) / 90));
  REQUIRE(j.margin(overload) == Approx((240. - 90) / 90)); // not overloaded in spite of small margins of the cause
  REQUIRE(j.margin(weak) == Approx((240. - 180) / 180));
  REQUIRE(j.margin() == j.margin(losing_control));
  REQUIRE_THAT(j.reason, Catch::Contains("240 deg at 64 kPa") && Catch::Contains("nearest losing_control"));
}

TEST_CASE("each piece of evidence leads to its class and is named in the reason")
{
  struct Case {
    const char *about;
    Path path;
    PathClass path_class;
    const char *name, *words;
  };
  Path runaway = stable_path(), snap = stable_path(), fall = stable_path(), droop = stable_path();
  runaway[5] = {50, 210, 1.4, 3.5};
  runaway[6] = {48, 215, 1.6, 3.5};
  runaway.push_back({64, 240, 1.2});
  snap[4].bulge = 1.6;
  fall[5].angle = 184;
  droop[0].angle = -91;
  const Case cases[] = {
      {"bulge", ending([](Point &p) { p.bulge = 3.6; }), interaction_failure, "bulge_limit",
       "bulge of the balloon 3.6 mm, at most 3.5 mm"},
      {"runaway", runaway, interaction_failure, "localisation_index", "past a limit point 3.5, at most 3"},
      {"ribs", ending([](Point &p) { p.opening = 0.81; }), interaction_failure, "rib_opening", "0.101, at most 0.1"},
      {"snap", snap, interaction_failure, "escape_bulge", "behind a snap-through 1.6 mm, at most 1.5 mm"},
      {"participation", ending([](Point &p) {
         p.gaps = {140, 100, 0, 0};
       }),
       losing_control, "participation", "participation of the gaps 0.486, at least 0.5"},
      {"one gap", ending([](Point &p) { p.gaps = gaps_of(160, 26); }), losing_control, "gap_ratio",
       "widest gap over the mean 2.69, at most 2.5"},
      {"fall", fall, losing_control, "angle_fall", "fall of the angle after rib contact 6 deg, at most 5 deg"},
      {"droop", droop, losing_control, "droop_angle", "droop 91 deg, at most 90 deg"},
  };
  for (const Case &c : cases) {
    CAPTURE(c.about);
    const Judgement j = judged(c.path);
    CHECK(j.path_class == c.path_class);
    CHECK(margin(j, c.name) < 0);
    CHECK(j.margin(c.path_class) < 0);
    CHECK(j.margin() < 0);
    CHECK_THAT(j.reason, Catch::Contains(c.words));
  }
}

TEST_CASE("a balloon that does not inflate is overloaded, one that does is only weak")
{
  const Path stiff = {{5, -50, -4, 1, 0, 0, 1}, {40, -45, -4, 1, 0, 0, 1.1}, {64, -40, -3, 1, 0, 0, 1.3}};
  const JudgedActuator two_layers = {8, 1.5, 2, 3.6, 0.0774};
  const PathEnd end = {false, "path.pressure_max is reached"};
  Judgement j = judged(stiff, end, defaults, two_layers);
  REQUIRE(j.path_class == overload);
  REQUIRE(j.margin(overload) == Approx(1 - 0.0774 / 0.064)); // between the angle's -1.44 and the radius' -0.16
  REQUIRE_THAT(j.reason, Catch::Contains("bending angle -40 deg, at least 90 deg") &&
                             Catch::Contains("limit pressure of the balloon over the window's end 1.21, at most 1") &&
                             Catch::Contains("mean radius of the balloon over the cage's 0.585, at least 0.7"));
  REQUIRE(std::isnan(margin(j, "participation"))); // no rib was touched: there is nothing to participate in

  Path wide = stiff;
  wide.back().radial_ratio = 1.6;
  REQUIRE(judged(wide, end, defaults, two_layers).path_class == overload); // by the limit pressure alone
  REQUIRE(judged(stiff).path_class == overload);                           // by the radius alone
  j = judged(wide);
  REQUIRE(j.path_class == weak); // short for another reason
  REQUIRE_THAT(j.reason, Catch::StartsWith("bending angle -40 deg, at least 180 deg; nearest"));
  REQUIRE(j.margin(weak) == Approx((-40. - 180) / 180));
  REQUIRE(j.margin() > 0);

  wide.back().angle = 100; // bends, in spite of a limit pressure beyond the window
  REQUIRE(judged(wide, end, defaults, two_layers).path_class == weak);
}

TEST_CASE("the first of several classes counts")
{
  const JudgedActuator two_layers = {8, 1.5, 2, 3.6, 0.0774};
  const PathEnd end = {false, "path.pressure_max is reached"};
  Path path = {{5, -95, -4, 1, 0, 0, 1}, {64, -40, 4, 1, 0, 0, 1.3}}; // bulge, droop, overload and weak at once
  Judgement j = judged(path, end, defaults, two_layers);
  for (const PathClass c : {interaction_failure, losing_control, overload, weak})
    REQUIRE(j.margin(c) < 0);
  REQUIRE(j.path_class == interaction_failure);
  REQUIRE_THAT(j.reason, !Catch::Contains("droop"));
  path.back().bulge = 0;
  REQUIRE(judged(path, end, defaults, two_layers).path_class == losing_control);
  path.front().angle = -50;
  REQUIRE(judged(path, end, defaults, two_layers).path_class == overload);
  path.back().angle = 90;
  REQUIRE(judged(path, end, defaults, two_layers).path_class == weak);
  path.back().angle = 180;
  REQUIRE(judged(path, end, defaults, two_layers).path_class == normal);
  REQUIRE(judged(path, {true, "time"}, defaults, two_layers).path_class == not_converged);
}

TEST_CASE("at its threshold a path still meets a criterion")
{
  Path path = stable_path();
  path[0].angle = -90;
  path[4].bulge = 1.5;
  path[5].angle = 185;
  path[6].bulge = 3.5;
  path[6].opening = 0.8;
  path[6].gaps = gaps_of(180, 36); // 2.5 times the mean
  const Judgement j = judged(path);
  REQUIRE(j.path_class == normal);
  for (const char *name : {"bulge_limit", "rib_opening", "escape_bulge", "gap_ratio", "angle_fall", "droop_angle"}) {
    CAPTURE(name);
    REQUIRE(margin(j, name) == Approx(0).margin(1e-12));
  }
  REQUIRE(judged(ending([](Point &p) { p.gaps = {3, 2, -1, 2}; })).margin(losing_control) == Approx(0).margin(1e-12));
}

TEST_CASE("a path that stopped for a numerical reason is not_converged, whatever it shows")
{
  const PathEnd stopped = {true, "no equilibrium at the smallest step"};
  for (const Path &path : {stable_path(), ending([](Point &p) { p.bulge = 9; }), Path{{5, -50}}, Path{}}) {
    const Judgement j = judged(path, stopped);
    REQUIRE(j.path_class == not_converged);
    REQUIRE_THAT(j.reason, Catch::StartsWith(stopped.reason));
    REQUIRE(std::isnan(j.margin()));
    REQUIRE(std::isnan(j.margin(interaction_failure)));
  }
  REQUIRE(margin(judged(stable_path(), stopped), "droop_angle") > 0); // as far as it goes
}

TEST_CASE("only the pressure window is judged")
{
  Path path = stable_path();
  path.push_back({64, 250, 9});
  path.push_back({80, 20, 9});
  REQUIRE(judged(path).path_class == normal); // what comes behind the first state at 64 kPa is not seen
  path = stable_path();
  path[0].angle = -120;
  Judge judge;
  judge.window_min = 0.02;
  REQUIRE(judged(path).path_class == losing_control);
  REQUIRE(judged(path, {}, judge).path_class == normal);
  judge.window_min = judge.window_max = 0.1;
  const Judgement nothing = judged(path, {false, "end"}, judge);
  REQUIRE(nothing.path_class == not_converged);
  REQUIRE_THAT(nothing.reason, Catch::Contains("no state in the pressure window"));
  path = stable_path();
  path.pop_back();
  const Judgement shorter = judged(path, {false, "judge.end_angle is reached"});
  REQUIRE(shorter.path_class == normal);
  REQUIRE_THAT(shorter.reason, Catch::Contains("ends before the window") && Catch::Contains("judge.end_angle"));
}

TEST_CASE("runaway needs a limit point, a balloon outside the cage and few gaps at once")
{
  const auto with = [](double pressure, double bulge, double localisation) {
    Path path = stable_path();
    path[6] = {pressure, 215, bulge, localisation};
    path.push_back({64, 240, 0.4}); // back at 50 kPa it is inside
    return judged(path);
  };
  REQUIRE(with(48, 1.6, 3.5).path_class == interaction_failure);
  REQUIRE(with(51, 1.6, 3.5).path_class == normal);   // the pressure rises
  REQUIRE(with(49.5, 1.6, 3.5).path_class == normal); // falls by 1 % only
  REQUIRE(with(48, 1.4, 3.5).path_class == normal);   // inside
  REQUIRE(with(48, 1.6, 2.5).path_class == normal);   // through many gaps
  REQUIRE(margin(with(48, 1.6, 3.6), "localisation_index") == Approx(std::max(-0.2, -0.1 / 1.5)));
  REQUIRE(margin(with(48, 1.2, 3.6), "localisation_index") == Approx(0.2));
  const Path rising = {{5, -50, 0}, {64, 200, 0}};
  REQUIRE(std::isnan(margin(judged(rising), "localisation_index")));
}

TEST_CASE("snap-throughs are recorded with the states before and behind, at the same pressure")
{
  Path path = {{5, 0},           {36, 58, -1},   {30, 150, 0.2}, {34, 180, 0.4}, {38, 200, 0.8},
               {37.5, 201, 0.8}, {40, 205, 0.9}, {35, 220, 1},   {38, 230, 1.1}};
  const Judgement j = judged(path, {false, "judge.end_angle is reached"});
  REQUIRE(j.snaps.size() == 2); // the dip to 37.5 is none
  REQUIRE(j.snaps[0].recovered);
  REQUIRE(j.snaps[0].before == SnapSide{36, 58, 1000, -1});
  const SnapSide &after = j.snaps[0].after; // half way between 34 and 38 kPa
  REQUIRE(after.pressure == 36);
  REQUIRE(after.angle == Approx(190));
  REQUIRE(after.volume == Approx(3500));
  REQUIRE(after.bulge == Approx(0.6));
  REQUIRE_FALSE(j.snaps[1].recovered);
  REQUIRE(j.snaps[1].before == SnapSide{40, 205, 6000, 0.9});
  REQUIRE(j.snaps[1].after == SnapSide{38, 230, 8000, 1.1});
  Judge judge;
  judge.snap_drop = 0.01;
  REQUIRE(judged(path, {}, judge).snaps.size() == 3);
  REQUIRE(judged({{-1, 0}, {-2, 0}, {-1, 0}}).snaps.empty());
}

TEST_CASE("a snap-through that begins outside the cage carries nothing out of it")
{
  Path path = {{5, -50, -4}, {36, 150, 1.6}, {30, 160, 1.8}, {64, 200, 1.9}};
  const Judgement j = judged(path);
  REQUIRE(j.snaps.size() == 1);
  REQUIRE(std::isnan(margin(j, "escape_bulge")));
  REQUIRE(j.path_class == normal);
}

TEST_CASE("what a history does not hold is not judged")
{
  std::vector<Row> rows = {Point{5, -50}.row(0), Point{64, 200}.row(1)};
  for (Row &row : rows)
    std::erase_if(row, [](const auto &cell) {
      return cell.first == "localisation_index" || cell.first == "rib_opening_mm" || cell.first.starts_with("gap_");
    });
  const Judgement j = judge_path(rows, defaults, actuator, {});
  REQUIRE(j.path_class == normal);
  for (const char *name : {"localisation_index", "rib_opening", "participation", "gap_ratio"})
    REQUIRE(std::isnan(margin(j, name)));
}

TEST_CASE("moving a threshold moves the boundary of its class")
{
  Judge judge;
  judge.bulge_limit = 0.3;
  REQUIRE(judged(stable_path(), {}, judge).path_class == interaction_failure);
  judge = {};
  judge.normal_angle = 241;
  REQUIRE(judged(stable_path(), {}, judge).path_class == weak);
  judge = {};
  judge.participation = 0; // a limit of zero counts as one
  REQUIRE(margin(judged(stable_path(), {}, judge), "participation") == Approx(1));
}

TEST_CASE("the limit pressure of the default balloon is that of the thin tube")
{
  REQUIRE(tube_limit_pressure(0.32, 0.5, 3.6) == Approx(0.0358).epsilon(1e-3));
  REQUIRE(tube_limit_pressure(0.32, 1.0, 3.6) == Approx(0.0774).epsilon(1e-3));
}

TEST_CASE("classes have words")
{
  for (const PathClass c : {not_converged, interaction_failure, losing_control, overload, weak, normal})
    REQUIRE(path_class_of(word_of(c)) == c);
  REQUIRE(word_of(losing_control) == "losing_control");
  REQUIRE_THROWS_AS(path_class_of("unheard"), std::invalid_argument);
  REQUIRE_THROWS_AS(margin_of(normal, {}), std::invalid_argument);
}
