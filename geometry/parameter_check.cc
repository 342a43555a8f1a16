// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/parameter_check.h"
#include "geometry/cage_check.h"
#include "geometry/message.h"
#include <algorithm>

namespace ballonet::geometry
{

namespace
{

using Problems = std::vector<Problem>;

void check_list(Problems &problems, const char *key, const std::vector<double> &list, int count, bool one_for_all)
{
  const auto size = static_cast<int>(list.size());
  if (size != 0 && size != count && !(one_for_all && size == 1))
    problems.push_back({key, "ribs.count",
                        join(key, " has ", size, " values, ribs.count is ", count, ": give ",
                             one_for_all ? "one value for all or " : "", "one per rib")});
}

Problems check_lists(const Pebs &pebs)
{
  const Ribs &ribs = pebs.ribs;
  Problems problems;
  check_list(problems, "ribs.position", ribs.position, ribs.count, false);
  check_list(problems, "ribs.slope", ribs.slope, ribs.count, true);
  check_list(problems, "ribs.v_angle", ribs.v_angle, ribs.count, true);
  check_list(problems, "ribs.arc", ribs.arc, ribs.count, true);
  check_list(problems, "ribs.orientation", ribs.orientation, ribs.count, true);
  check_list(problems, "wall.rise", pebs.wall.rise, ribs.count, true);
  return problems;
}

void check_balloon_fits(Problems &problems, const Pebs &pebs, const RibPattern &pattern)
{
  const Balloon &balloon = pebs.balloon;
  if (balloon.diameter >= 2 * pebs.ribs.inner_radius)
    problems.push_back({"balloon.diameter", "ribs.inner_radius",
                        join("balloon.diameter ", balloon.diameter,
                             " mm does not fit into a cage of ribs.inner_radius ", pebs.ribs.inner_radius, " mm")});
  if (balloon.length >= pattern.height())
    problems.push_back(
        {"balloon.length", place_key(pebs.ribs),
         join("balloon.length ", balloon.length, " mm does not stay below the head, at ", pattern.height(), " mm")});
}

void append(Problems &problems, const Problems &more) { problems.insert(problems.end(), more.begin(), more.end()); }

bool all_zero(const std::vector<double> &list)
{
  return std::all_of(list.begin(), list.end(), [](double x) { return x == 0; });
}

} // namespace

std::vector<Problem> check(const Balloon &balloon)
{
  Problems problems;
  if (balloon.wall >= 0.45 * balloon.diameter)
    problems.push_back(
        {"balloon.wall", "balloon.diameter",
         join("balloon.wall ", balloon.wall, " mm fills a balloon.diameter of ", balloon.diameter, " mm")});
  if (balloon.length <= balloon.diameter)
    problems.push_back({"balloon.length", "balloon.diameter",
                        join("balloon.length ", balloon.length,
                             " mm leaves no tube below the dome of balloon.diameter ", balloon.diameter, " mm")});
  return problems;
}

std::vector<Problem> check(const Pebs &pebs)
{
  Problems problems = check_lists(pebs);
  if (!problems.empty())
    return problems;
  if (pebs.with_balloon)
    problems = check(pebs.balloon);
  const RibPattern pattern(pebs.ribs, pebs.wall);
  if (pebs.with_balloon)
    check_balloon_fits(problems, pebs, pattern);
  append(problems, check_cage(pebs, pattern));
  return problems;
}

std::vector<Problem> check(const MeshSizes &sizes)
{
  Problems problems;
  if (sizes.around_ring % 8 != 0)
    problems.push_back(
        {"mesh.around_ring", "", join("mesh.around_ring ", sizes.around_ring, " is not a multiple of 8")});
  if (sizes.balloon_around % 8 != 0)
    problems.push_back(
        {"mesh.balloon_around", "", join("mesh.balloon_around ", sizes.balloon_around, " is not a multiple of 8")});
  if (sizes.across_wall % 2 != 0)
    problems.push_back({"mesh.across_wall", "", join("mesh.across_wall ", sizes.across_wall, " is odd")});
  if (sizes.along_fold % 2 != 0)
    problems.push_back({"mesh.along_fold", "", join("mesh.along_fold ", sizes.along_fold, " is odd")});
  if (2 * sizes.across_wall + 8 > sizes.around_ring)
    problems.push_back(
        {"mesh.across_wall", "mesh.around_ring",
         join("mesh.around_ring ", sizes.around_ring, " leaves too few elements beside mesh.across_wall ",
              sizes.across_wall, " (at least twice that and 8 more)")});
  return problems;
}

std::vector<Problem> check(const Pebs &pebs, const MeshSizes &sizes)
{
  Problems problems = check(pebs);
  append(problems, check(sizes));
  if (sizes.symmetry && !all_zero(pebs.ribs.slope))
    problems.push_back(
        {"mesh.symmetry", "ribs.slope", "sloping ribs are not mirror-symmetric: mesh.symmetry must be false"});
  if (sizes.symmetry && !all_zero(pebs.ribs.orientation))
    problems.push_back(
        {"mesh.symmetry", "ribs.orientation", "turned ribs are not mirror-symmetric: mesh.symmetry must be false"});
  return problems;
}

} // namespace ballonet::geometry
