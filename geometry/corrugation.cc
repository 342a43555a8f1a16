// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/corrugation.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace ballonet::geometry
{

Corrugation::Corrugation(double gap, double rise, double valley_share) : gap_(gap), half_length_(gap / 2)
{
  if (rise <= 1e-9 * gap)
    return;
  angle_ = std::min(2 * std::atan(2 * rise / gap), std::numbers::pi / 2);
  flank_ = std::max(rise - gap / 2, 0.);
  const double radii = gap / 2 / std::sin(angle_);
  valley_ = valley_share * radii;
  crest_ = radii - valley_;
  half_length_ = radii * angle_ + flank_;
}

double Corrugation::smallest_radius() const
{
  return angle_ > 0 ? std::min(valley_, crest_) : std::numeric_limits<double>::infinity();
}

FoldPoint Corrugation::at(double fraction) const
{
  const double arc_length = fraction * length();
  if (arc_length <= half_length_)
    return first_half(arc_length);
  const FoldPoint mirrored = first_half(length() - arc_length);
  return {gap_ - mirrored.axial, mirrored.height, -mirrored.normal_axial, mirrored.normal_height};
}

FoldPoint Corrugation::first_half(double arc_length) const
{
  if (angle_ == 0)
    return {arc_length, 0, 0, 1};
  const double on_valley = std::min(arc_length, valley_ * angle_);
  const double on_flank = std::clamp(arc_length - valley_ * angle_, 0., flank_);
  const double on_crest = std::max(arc_length - valley_ * angle_ - flank_, 0.);
  const double turned = on_valley / valley_, direction = on_crest > 0 ? angle_ - on_crest / crest_ : turned;
  const double axial = valley_ * std::sin(turned) + on_flank * std::cos(angle_);
  const double height = valley_ * (1 - std::cos(turned)) + on_flank * std::sin(angle_);
  const double crest_axial = on_crest > 0 ? crest_ * (std::sin(angle_) - std::sin(direction)) : 0;
  const double crest_height = on_crest > 0 ? crest_ * (std::cos(direction) - std::cos(angle_)) : 0;
  return {axial + crest_axial, height + crest_height, -std::sin(direction), std::cos(direction)};
}

} // namespace ballonet::geometry
