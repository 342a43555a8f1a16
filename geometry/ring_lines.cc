// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/ring_lines.h"
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace ballonet::geometry
{

namespace
{

constexpr double turn = 2 * std::numbers::pi;

/// A stretch of the circle between two stops, by angle from the start.
struct Stretch {
  double begin, end;
  int elements; // 0: still open
};

double angle_from(double start, double angle)
{
  const double difference = std::fmod(angle - start, turn);
  const double positive = difference < 0 ? difference + turn : difference;
  return turn - positive < 1e-9 ? 0 : positive;
}

/// Stops of the circle by angle from the centre of the first window, 0 and a full turn included.
std::vector<double> sorted_stops(const std::vector<Window> &windows, const std::vector<double> &stops)
{
  const double start = windows.front().centre;
  std::vector<double> sorted = {0, turn};
  for (const Window &window : windows)
    for (const double side : {-1., 0., 1.})
      sorted.push_back(angle_from(start, window.centre + side * window.half_angle));
  for (const double stop : stops)
    sorted.push_back(angle_from(start, stop));
  std::sort(sorted.begin(), sorted.end());
  const auto same = [](double a, double b) { return b - a < 1e-9; };
  sorted.erase(std::unique(sorted.begin(), sorted.end(), same), sorted.end());
  return sorted;
}

int window_elements(const std::vector<Window> &windows, double start, double middle)
{
  for (const Window &window : windows) {
    const double from_edge = angle_from(start + middle, window.centre + window.half_angle);
    if (from_edge < 2 * window.half_angle)
      return window.elements / 2;
  }
  return 0;
}

double length(const Stretch &stretch) { return stretch.end - stretch.begin; }

/// The open stretch around the front, opposite the first window. It gets an even number of elements, so that a
/// mirror-symmetric ring has a mesh line there.
bool is_front(const Stretch &stretch)
{
  return stretch.elements == 0 && stretch.begin < turn / 2 - 1e-9 && stretch.end > turn / 2 + 1e-9;
}

/// Shares `total` elements out among the open stretches by length, at least one each.
void share_out(std::vector<Stretch> &stretches, int total)
{
  std::vector<Stretch *> open;
  double left = 0;
  for (Stretch &stretch : stretches)
    if (stretch.elements == 0) {
      open.push_back(&stretch);
      left += length(stretch);
    }
  std::stable_sort(open.begin(), open.end(), [](auto *a, auto *b) { return is_front(*a) > is_front(*b); });
  auto waiting = static_cast<int>(open.size());
  if (total < waiting + 1)
    throw std::invalid_argument("too few elements around the ring");
  for (Stretch *stretch : open) {
    --waiting;
    const double share = total * length(*stretch) / left;
    const bool even = is_front(*stretch) && waiting > 0;
    const auto rounded = static_cast<int>(even ? 2 * std::lround(share / 2) : std::lround(share));
    stretch->elements = waiting == 0 ? total : std::clamp(rounded, even ? 2 : 1, total - waiting);
    total -= stretch->elements;
    left -= length(*stretch);
  }
}

} // namespace

RingLines::RingLines(int count, const std::vector<Window> &windows, const std::vector<double> &stops)
{
  const double start = windows.front().centre;
  const std::vector<double> sorted = sorted_stops(windows, stops);
  std::vector<Stretch> stretches;
  int open = count;
  for (std::size_t i = 0; i + 1 < sorted.size(); ++i) {
    const double middle = (sorted[i] + sorted[i + 1]) / 2;
    stretches.push_back({sorted[i], sorted[i + 1], window_elements(windows, start, middle)});
    open -= stretches.back().elements;
  }
  share_out(stretches, open);
  for (const Stretch &stretch : stretches)
    for (int i = 0; i < stretch.elements; ++i)
      lines_.push_back(start + stretch.begin + (stretch.end - stretch.begin) * i / stretch.elements);
  lines_.push_back(start + turn);
}

double RingLines::angle(double index) const
{
  const double turns = std::floor(index / count());
  const double within = index - turns * count();
  const auto below = static_cast<std::size_t>(std::floor(within));
  const double fraction = within - static_cast<double>(below);
  const double line = fraction > 0 ? lines_[below] + fraction * (lines_[below + 1] - lines_[below]) : lines_[below];
  return line + turns * turn;
}

} // namespace ballonet::geometry
