// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/pebs_measures.h"
#include <algorithm>
#include <cmath>
#include <limits>

namespace ballonet::studies
{
namespace
{

Point difference(const Point &a, const Point &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point &a, const Point &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Point &a) { return std::sqrt(dot(a, a)); }

/// Weights of the cubic Hermite polynomial for both ends and both tangents.
std::array<double, 4> hermite(double t)
{
  return {(1 + 2 * t) * (1 - t) * (1 - t), t * t * (3 - 2 * t), t * (1 - t) * (1 - t), -t * t * (1 - t)};
}

} // namespace

PebsGauge::PebsGauge(geometry::PebsLayout layout, std::vector<Point> reference, bool symmetric)
    : layout_(std::move(layout)), reference_(std::move(reference)), symmetric_(symmetric)
{
  if (!layout_.balloon_outer.empty())
    balloon_.emplace(layout_, reference_, symmetric_);
}

std::vector<RigidFrame> PebsGauge::rib_frames(const std::vector<Point> &deformed) const
{
  std::vector<RigidFrame> frames(1);
  for (const geometry::RibLayout &rib : layout_.ribs)
    frames.push_back(best_fit(reference_, deformed, rib.nodes, symmetric_));
  return frames;
}

PebsMeasures PebsGauge::measure(const std::vector<Point> &deformed, double previous_angle) const
{
  PebsMeasures m;
  const RigidFrame head = best_fit(reference_, deformed, layout_.head, symmetric_);
  const FrameAngles turned = angles(head.rotation);
  m.bending_angle = unwrapped(turned.bending, previous_angle);
  m.twist = turned.twist;
  m.out_of_plane = turned.out_of_plane;
  m.tip = head.map({0, 0, head.reference_centre[2]});
  const auto frames = rib_frames(deformed);
  for (std::size_t k = 1; k < frames.size(); ++k)
    m.gaps.push_back(angles(relative_rotation(frames[k - 1].rotation, frames[k].rotation)).bending);
  m.rib_opening = rib_opening(deformed, frames);
  if (balloon_) {
    m.axial_ratio = balloon_->axial_ratio(deformed);
    m.radial_ratio = balloon_->radial_ratio(deformed);
    const auto bulges = gap_bulges(deformed, frames);
    m.max_bulge = *std::max_element(bulges.begin(), bulges.end());
    m.localisation = localisation_index(bulges);
  }
  return m;
}

std::vector<double> PebsGauge::gap_bulges(const std::vector<Point> &deformed,
                                          const std::vector<RigidFrame> &frames) const
{
  std::vector<CageAxis::Station> stations;
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const double z = k == 0 ? 0 : layout_.ribs[k - 1].centre_z;
    stations.push_back({frames[k].map({0, 0, z}), frames[k].normal()});
  }
  const CageAxis axis(std::move(stations));
  std::vector<double> bulges(layout_.ribs.size(), -layout_.inner_radius);
  for (const geometry::BalloonNode &node : layout_.balloon_outer)
    if (const auto place = axis.place_of(deformed[node.node]))
      bulges[place->gap] = std::max(bulges[place->gap], place->radius - layout_.inner_radius);
  return bulges;
}

double PebsGauge::rib_opening(const std::vector<Point> &deformed, const std::vector<RigidFrame> &frames) const
{
  double largest = 0;
  for (std::size_t k = 0; k < layout_.ribs.size(); ++k)
    for (const std::uint32_t node : layout_.ribs[k].nodes) {
      const Point at_rest = reference_[node], now = frames[k + 1].pull_back(deformed[node]);
      largest = std::max(largest, std::hypot(now[0], now[1]) - std::hypot(at_rest[0], at_rest[1]));
    }
  return largest;
}

std::optional<double> CageAxis::radius_in_gap(const Point &point, std::size_t gap) const
{
  const Station &below = stations_[gap], &above = stations_[gap + 1];
  const double up = dot(difference(point, below.centre), below.normal);
  const double down = dot(difference(above.centre, point), above.normal);
  if (up < 0 || down < 0 || up + down <= 0)
    return {};
  const double t = up / (up + down), chord = length(difference(above.centre, below.centre));
  const auto w = hermite(t);
  Point offset{}, normal{};
  for (int i = 0; i < 3; ++i) {
    offset[i] = point[i] - (w[0] * below.centre[i] + w[1] * above.centre[i] +
                            chord * (w[2] * below.normal[i] + w[3] * above.normal[i]));
    normal[i] = (1 - t) * below.normal[i] + t * above.normal[i];
  }
  const double along = dot(offset, normal) / length(normal);
  return std::sqrt(std::max(0., dot(offset, offset) - along * along));
}

std::optional<CageAxis::Place> CageAxis::place_of(const Point &point) const
{
  std::optional<Place> nearest; // a bent cage may have the point between several pairs of planes
  double to_station = length(difference(point, stations_.back().centre));
  for (std::size_t gap = 0; gap + 1 < stations_.size(); ++gap) {
    to_station = std::min(to_station, length(difference(point, stations_[gap].centre)));
    if (const auto radius = radius_in_gap(point, gap); radius && (!nearest || *radius < nearest->radius))
      nearest = Place{gap, *radius};
  }
  constexpr double far_off =
      2; // in its own cross-section a point is about as far from the axis as from the next station
  const bool elsewhere = nearest && nearest->radius > far_off * to_station; // a curled cage has its other end there
  return elsewhere ? std::nullopt : nearest;
}

double localisation_index(const std::vector<double> &gap_bulges)
{
  double largest = 0, sum = 0;
  for (const double bulge : gap_bulges) {
    largest = std::max(largest, bulge);
    sum += std::max(0., bulge);
  }
  return largest > 0 ? largest * static_cast<double>(gap_bulges.size()) / sum : 1;
}

double touched_share(const std::vector<std::vector<std::uint32_t>> &rib_cells, const std::vector<bool> &touched,
                     double arc_share)
{
  std::size_t n_touched = 0;
  for (const auto &cells : rib_cells) {
    const auto n = std::count_if(cells.begin(), cells.end(), [&](std::uint32_t cell) { return touched[cell]; });
    n_touched += static_cast<double>(n) >= arc_share * static_cast<double>(cells.size()) && n > 0;
  }
  return rib_cells.empty() ? 0 : static_cast<double>(n_touched) / static_cast<double>(rib_cells.size());
}

} // namespace ballonet::studies
