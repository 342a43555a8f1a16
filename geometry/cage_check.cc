// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/cage_check.h"
#include "geometry/message.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ballonet::geometry
{

namespace
{

using Problems = std::vector<Problem>;
using std::numbers::pi;

constexpr double degree = pi / 180;
constexpr double smallest_gap = 0.1;       ///< mm between neighbouring ribs
constexpr double fold_margin = 1.05;       ///< smallest fold radius over half the wall's thickness
constexpr double land_margin = 5 * degree; ///< between a land and the end of its rib or the next land

/// Which list bends the ribs' edges, for the message of ribs that meet.
std::string edge_key(const Ribs &ribs)
{
  const auto any = [](const std::vector<double> &list) {
    return std::any_of(list.begin(), list.end(), [](double x) { return x != 0; });
  };
  if (any(ribs.slope))
    return "ribs.slope";
  return any(ribs.v_angle) ? "ribs.v_angle" : "ribs.width";
}

/// Smallest axial distance between a rib and what lies below it, over all angles.
double smallest_distance(const RibPattern &pattern, int rib)
{
  double smallest = pattern.height();
  for (int i = 0; i < 360; ++i) {
    const double angle = i * degree, below_chi = angle - (rib > 0 ? pattern.orientation(rib - 1) : 0);
    const double below = rib > 0 ? pattern.upper(rib - 1, below_chi) : 0;
    smallest = std::min(smallest, pattern.lower(rib, angle - pattern.orientation(rib)) - below);
  }
  return smallest;
}

void check_rib_distances(Problems &problems, const Pebs &pebs, const RibPattern &pattern)
{
  const std::string edge = edge_key(pebs.ribs), place = place_key(pebs.ribs);
  for (int rib = 0; rib < pattern.count(); ++rib) {
    const double distance = smallest_distance(pattern, rib);
    if (distance >= smallest_gap)
      continue;
    const std::string below = rib > 0 ? join("rib ", rib) : "the base";
    problems.push_back({edge, place,
                        join("rib ", rib + 1, " overlaps ", below, " or comes too close: their smallest distance is ",
                             distance, " mm, below ", smallest_gap, " mm (", edge, ", ", place, ")")});
    return;
  }
}

/// The fold must not bend sharper than its thickness allows, neither in the middle of the wall nor at its edges.
void check_folds(Problems &problems, const Pebs &pebs, const RibPattern &pattern)
{
  const double thickness = pebs.wall.thickness, smallest = fold_margin * thickness / 2;
  for (int gap = 0; gap < pattern.count(); ++gap)
    for (const double eta : {-1., 0., 1.}) {
      const double radius = pattern.corrugation(gap, eta).smallest_radius();
      if (radius >= smallest)
        continue;
      const double rise = list_value(pebs.wall.rise, gap, 0),
                   width = pattern.strip_end(gap, eta) - pattern.strip_start(gap, eta);
      problems.push_back({"wall.thickness", rise < width / 2 ? "wall.rise" : place_key(pebs.ribs),
                          join("the corrugation in gap ", gap + 1, " (", width, " mm, wall.rise ", rise,
                               " mm) bends with a radius of ", radius, " mm; a wall.thickness of ", thickness,
                               " mm needs ", smallest, " mm")});
      return;
    }
}

void check_wall(Problems &problems, const Pebs &pebs, const RibPattern &pattern)
{
  const Wall &wall = pebs.wall;
  if (wall.thickness > 0.95 * pebs.ribs.thickness)
    problems.push_back({"wall.thickness", "ribs.thickness",
                        join("wall.thickness ", wall.thickness, " mm must stay below 0.95 of ribs.thickness ",
                             pebs.ribs.thickness, " mm")});
  if (pattern.half_window() > pi / 2)
    problems.push_back({"wall.width", "ribs.inner_radius",
                        join("wall.width ", wall.width, " mm is more than half the ring of ribs.inner_radius ",
                             pebs.ribs.inner_radius, " mm")});
}

void check_arcs(Problems &problems, const RibPattern &pattern)
{
  for (int rib = 0; rib < pattern.count(); ++rib) {
    const double half = pattern.half_arc(rib), land = pattern.half_window();
    if (half > pi - 1e-9 || (half >= land + land_margin && half <= pi - land_margin))
      continue;
    problems.push_back({"ribs.arc", "wall.width",
                        join("rib ", rib + 1, ": ribs.arc ", 2 * half / degree, " deg must exceed the wall land of ",
                             2 * land / degree, " deg by 10 deg, and be 360 deg or at most 350 deg")});
    return;
  }
}

/// A second land, turned by `turn` from the first, must not overlap it and must lie on the rib.
void check_second_land(Problems &problems, const Pebs &pebs, const RibPattern &pattern, int rib, double turn)
{
  const double half_arc = pattern.half_arc(rib), land = pattern.half_window();
  if (turn < 2 * land + land_margin)
    problems.push_back({"ribs.orientation", "wall.width",
                        join("from rib ", rib + 1, " to the next the orientation turns by ", turn / degree,
                             " deg: too much to twist the wall, too little for a second land beside one of wall.width ",
                             pebs.wall.width, " mm")});
  else if (half_arc < pi - 1e-9 && turn + land > half_arc)
    problems.push_back(
        {"ribs.orientation", "ribs.arc",
         join("rib ", rib + 1, " ends before the land of the wall above it, turned by ", turn / degree, " deg")});
}

void check_orientations(Problems &problems, const Pebs &pebs, const RibPattern &pattern)
{
  const std::size_t before = problems.size();
  for (int rib = 0; rib + 1 < pattern.count() && problems.size() == before; ++rib)
    if (pattern.has_second_land(rib))
      check_second_land(problems, pebs, pattern, rib,
                        std::abs(wrap_angle(pattern.orientation(rib + 1) - pattern.orientation(rib))));
}

} // namespace

const char *place_key(const Ribs &ribs) { return ribs.position.empty() ? "ribs.gap" : "ribs.position"; }

std::vector<Problem> check_cage(const Pebs &pebs, const RibPattern &pattern)
{
  Problems problems;
  check_rib_distances(problems, pebs, pattern);
  if (problems.empty())
    check_folds(problems, pebs, pattern);
  check_wall(problems, pebs, pattern);
  check_arcs(problems, pattern);
  check_orientations(problems, pebs, pattern);
  return problems;
}

} // namespace ballonet::geometry
