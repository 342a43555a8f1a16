// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/balloon_measures.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

namespace ballonet::studies
{
namespace
{

double distance(const Point &a, const Point &b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

/// Nodes of the same height, to 1e-5 mm.
long long height_key(double z) { return std::llround(z * 1e5); }

} // namespace

BalloonGauge::BalloonGauge(const geometry::PebsLayout &layout, const std::vector<Point> &reference, bool symmetric)
    : symmetric_(symmetric)
{
  const double tube_end = layout.balloon_length - layout.balloon_radius + 1e-6;
  std::map<long long, Ring> rings;
  double top = -1;
  for (const geometry::BalloonNode &node : layout.balloon_outer) {
    if (node.z > top) {
      top = node.z;
      tip_ = node.node;
    }
    if (node.z > tube_end)
      continue;
    Ring &ring = rings[height_key(node.z)];
    ring.nodes.push_back(node.node);
    ring.weights.push_back(symmetric && std::abs(reference[node.node][1]) > 1e-9 ? 2 : 1); // with its mirror image
  }
  for (auto &[height, ring] : rings) {
    double sum = 0;
    for (const double weight : ring.weights)
      sum += weight;
    for (double &weight : ring.weights)
      weight /= sum;
    rings_.push_back(std::move(ring));
  }
  if (rings_.size() < 2 || top <= tube_end)
    throw std::invalid_argument("a balloon needs at least two rings of nodes and a tip");
  rest_length_ = length(reference);
  rest_radius_ = radius(reference);
}

Point BalloonGauge::centre(const Ring &ring, const std::vector<Point> &points) const
{
  Point sum{};
  for (std::size_t n = 0; n < ring.nodes.size(); ++n)
    for (int i = 0; i < 3; ++i)
      sum[i] += ring.weights[n] * points[ring.nodes[n]][i];
  if (symmetric_)
    sum[1] = 0;
  return sum;
}

double BalloonGauge::length(const std::vector<Point> &points) const
{
  double sum = 0;
  Point previous = centre(rings_.front(), points);
  for (const Ring &ring : rings_) {
    const Point next = centre(ring, points);
    sum += distance(previous, next);
    previous = next;
  }
  return sum + distance(previous, points[tip_]);
}

double BalloonGauge::radius(const std::vector<Point> &points) const
{
  double sum = 0;
  for (const Ring &ring : rings_) {
    const Point middle = centre(ring, points);
    for (std::size_t n = 0; n < ring.nodes.size(); ++n)
      sum += ring.weights[n] * distance(points[ring.nodes[n]], middle);
  }
  return sum / static_cast<double>(rings_.size());
}

} // namespace ballonet::studies
