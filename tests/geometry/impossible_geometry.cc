// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/parameter_check.h"
#include "tests/geometry/built_mesh.h"
#include <functional>

using namespace ballonet::geometry;

namespace
{

struct Case {
  const char *name;
  std::function<void(Pebs &)> change;
  const char *key_a, *key_b;
};

const std::vector<Case> cases = {
    {"balloon as wide as the cage", [](Pebs &p) { p.balloon.diameter = 16; }, "balloon.diameter", "ribs.inner_radius"},
    {"balloon longer than the cage", [](Pebs &p) { p.balloon.length = 96; }, "balloon.length", "ribs.gap"},
    {"balloon shorter than its dome", [](Pebs &p) { p.balloon.length = 7; }, "balloon.length", "balloon.diameter"},
    {"solid balloon", [](Pebs &p) { p.balloon.wall = 3.6; }, "balloon.wall", "balloon.diameter"},
    {"wall too thick for its fold", [](Pebs &p) { p.wall.thickness = 1.3; }, "wall.thickness", "ribs.gap"},
    {"flat fold too sharp", [](Pebs &p) { p.wall.valley_share = 0.2, p.wall.rise = {1.2}; }, "wall.thickness",
     "wall.rise"},
    {"wall as thick as the ribs", [](Pebs &p) { p.ribs.thickness = 0.8; }, "wall.thickness", "ribs.thickness"},
    {"wall wider than half the ring", [](Pebs &p) { p.wall.width = 30; }, "wall.width", "ribs.inner_radius"},
    {"positions overlap",
     [](Pebs &p) {
       p.ribs.count = 2, p.ribs.position = {50, 51};
       p.balloon.length = 20;
     },
     "ribs.width", "ribs.position"},
    {"slope runs into the base", [](Pebs &p) { p.ribs.slope = {30}; }, "ribs.slope", "ribs.gap"},
    {"V runs into the head", [](Pebs &p) { p.ribs.v_angle = {20}; }, "ribs.v_angle", "ribs.gap"},
    {"arc smaller than the land", [](Pebs &p) { p.ribs.arc = {60}; }, "ribs.arc", "wall.width"},
    {"orientation between twist and second land",
     [](Pebs &p) {
       p.ribs.count = 2, p.ribs.orientation = {0, 45};
       p.balloon.length = 8;
     },
     "ribs.orientation", "wall.width"},
    {"second land beyond the rib's end",
     [](Pebs &p) {
       p.ribs.count = 2, p.ribs.orientation = {0, 150};
       p.ribs.arc = {240};
       p.balloon.length = 8;
     },
     "ribs.orientation", "ribs.arc"},
    {"list of the wrong length",
     [](Pebs &p) {
       p.ribs.slope = {0, 0};
     },
     "ribs.slope", "ribs.count"},
};

} // namespace

TEST_CASE("impossible geometry is an answer that names the two parameters")
{
  for (const Case &c : cases) {
    INFO(c.name);
    Pebs pebs;
    c.change(pebs);
    const auto problems = check(pebs);
    REQUIRE_FALSE(problems.empty());
    CHECK(problems.front().key_a == c.key_a);
    CHECK(problems.front().key_b == c.key_b);
    CHECK(problems.front().message.find_first_of("0123456789") != std::string::npos);
    const auto result = build_mesh(pebs, full_model());
    const auto *failure = std::get_if<MeshFailure>(&result);
    REQUIRE(failure != nullptr);
    CHECK(failure->reason == problems.front().message);
  }
}

TEST_CASE("the default is possible") { CHECK(check(Pebs{}, MeshSizes{}).empty()); }

TEST_CASE("a half model of a design without mirror symmetry is refused")
{
  Pebs sloped, turned;
  sloped.ribs.slope = {5};
  turned.ribs.orientation = {10};
  CHECK(check(sloped).empty());
  CHECK(check(sloped, MeshSizes{}).front().key_b == "ribs.slope");
  CHECK(check(turned, MeshSizes{}).front().key_b == "ribs.orientation");
  CHECK(check(sloped, full_model()).empty());
}

TEST_CASE("element counts that do not fit are refused")
{
  const auto refused = [](auto change) {
    MeshSizes sizes;
    change(sizes);
    const auto problems = check(sizes);
    return problems.empty() ? std::string() : problems.front().key_a;
  };
  CHECK(refused([](MeshSizes &s) { s.around_ring = 20; }) == "mesh.around_ring");
  CHECK(refused([](MeshSizes &s) { s.balloon_around = 12; }) == "mesh.balloon_around");
  CHECK(refused([](MeshSizes &s) { s.across_wall = 3; }) == "mesh.across_wall");
  CHECK(refused([](MeshSizes &s) { s.along_fold = 9; }) == "mesh.along_fold");
  CHECK(refused([](MeshSizes &s) { s.across_wall = 12; }) == "mesh.across_wall");
}
