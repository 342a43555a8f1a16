// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/gap_bulge.h"
#include <cmath>
#include <limits>

namespace ballonet::solver::reduced
{

GapBulge::GapBulge(const Parameters &parameters, double lever)
    : mu_(2 * parameters.balloon.c10), thickness_(parameters.balloon.wall),
      middle_radius_((parameters.balloon.diameter - parameters.balloon.wall) / 2), gap_(parameters.ribs.gap),
      pitch_(parameters.pitch()), cage_radius_(parameters.ribs.inner_radius), lever_(lever)
{
}

double GapBulge::front_gap(double th) const { return gap_ + (lever_ + cage_radius_) * th; }

double GapBulge::front_stretch(double z, double th) const
{
  return z * (1 + cage_radius_ * th / (pitch_ + lever_ * th));
}

GapBulge::Wall GapBulge::wall(double r, double z_f) const
{
  // The middle of the wall, whose current thickness is t / (lt z_f): lt R = r - t / (2 lt z_f).
  const double R = middle_radius_, lt = (r + std::sqrt(r * r - 2 * R * thickness_ / z_f)) / (2 * R);
  return {mu_ * thickness_ / (R * z_f) * (1 - 1 / (std::pow(lt, 4) * z_f * z_f)),
          mu_ * thickness_ / lt * (z_f - 1 / (lt * lt * z_f * z_f * z_f))};
}

double GapBulge::slip_ratio(double pressure, double z, double th) const
{
  const Wall front = wall(cage_radius_, front_stretch(z, th));
  return front_gap(th) * (pressure - front.hoop_pressure) / (2 * front.tension);
}

double GapBulge::slip_height(double pressure, double z, double th) const
{
  const double chi = slip_ratio(pressure, z, th);
  if (chi >= 1)
    return std::numeric_limits<double>::infinity();
  return chi <= 0 ? 0 : front_gap(th) / 2 * std::tan(std::asin(chi) / 2);
}

double GapBulge::runaway_pressure(double z, double th) const
{
  const Wall front = wall(cage_radius_, front_stretch(z, th));
  return front.hoop_pressure + 2 * front.tension / front_gap(th);
}

double GapBulge::slip_pressure(double height, double z, double th) const
{
  if (height >= front_gap(th) / 2)
    return runaway_pressure(z, th);
  const Wall front = wall(cage_radius_, front_stretch(z, th));
  const double phi = 2 * std::atan(2 * height / front_gap(th));
  return front.hoop_pressure + 2 * front.tension * std::sin(phi) / front_gap(th);
}

double GapBulge::stick_pressure(double height, double z, double th) const
{
  const double phi = 2 * std::atan(2 * height / front_gap(th));
  const double lengthening = phi > 0 ? phi / std::sin(phi) : 1;
  const Wall apex = wall(cage_radius_ + height, front_stretch(z, th) * lengthening);
  return apex.hoop_pressure + 2 * apex.tension * std::sin(phi) / front_gap(th);
}

} // namespace ballonet::solver::reduced
