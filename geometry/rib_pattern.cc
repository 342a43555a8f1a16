// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/rib_pattern.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ballonet::geometry
{

namespace
{

using std::numbers::pi;
constexpr double degree = pi / 180;

} // namespace

double list_value(const std::vector<double> &list, int index, double fallback)
{
  if (list.empty())
    return fallback;
  return list.size() == 1 ? list.front() : list.at(static_cast<std::size_t>(index));
}

double wrap_angle(double angle)
{
  const double turned = std::remainder(angle, 2 * pi);
  return turned <= -pi ? turned + 2 * pi : turned;
}

Point cylinder_point(double radius, double angle, double height)
{
  return {-radius * std::cos(angle), radius * std::sin(angle), height};
}

RibPattern::RibPattern(const Ribs &ribs, const Wall &wall) : ribs_(ribs), wall_(wall) {}

double RibPattern::centre(int rib) const
{
  if (ribs_.position.empty())
    return (rib + 1) * (ribs_.gap + ribs_.width) - ribs_.width / 2;
  return ribs_.position.at(static_cast<std::size_t>(rib));
}

double RibPattern::height() const { return centre(count() - 1) + ribs_.width / 2; }

double RibPattern::offset(int rib, double chi) const
{
  if (rib == count() - 1)
    return 0;
  const double tilt = ribs_.inner_radius * std::tan(degree * list_value(ribs_.slope, rib, 0)) * std::sin(chi);
  const double arm = std::max(std::abs(wrap_angle(chi)) - half_window(), 0.);
  return tilt + ribs_.inner_radius * std::tan(degree * list_value(ribs_.v_angle, rib, 0)) * arm;
}

double RibPattern::lower(int rib, double chi) const { return centre(rib) - ribs_.width / 2 + offset(rib, chi); }

double RibPattern::upper(int rib, double chi) const { return centre(rib) + ribs_.width / 2 + offset(rib, chi); }

double RibPattern::orientation(int rib) const { return degree * list_value(ribs_.orientation, rib, 0); }

double RibPattern::half_arc(int rib) const { return degree * list_value(ribs_.arc, rib, 360) / 2; }

bool RibPattern::twists(int gap) const
{
  if (gap == 0)
    return false;
  const double turn = std::abs(wrap_angle(orientation(gap) - orientation(gap - 1)));
  return turn * wall_radius() <=
         Corrugation(lower(gap, 0) - upper(gap - 1, 0), list_value(wall_.rise, gap, 0), wall_.valley_share).length();
}

double RibPattern::strip_foot(int gap) const { return twists(gap) ? orientation(gap - 1) : orientation(gap); }

bool RibPattern::has_second_land(int rib) const { return rib + 1 < count() && !twists(rib + 1); }

double RibPattern::strip_start(int gap, double eta) const
{
  return gap == 0 ? 0 : upper(gap - 1, strip_foot(gap) + eta * half_window() - orientation(gap - 1));
}

double RibPattern::strip_end(int gap, double eta) const { return lower(gap, eta * half_window()); }

Corrugation RibPattern::corrugation(int gap, double eta) const
{
  return {strip_end(gap, eta) - strip_start(gap, eta), list_value(wall_.rise, gap, 0), wall_.valley_share};
}

} // namespace ballonet::geometry
