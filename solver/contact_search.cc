// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_search.h"
#include <numeric>

namespace ballonet::solver::contact
{

void Box::include(const Box &other)
{
  for (int i = 0; i < 3; ++i) {
    low[i] = std::min(low[i], other.low[i]);
    high[i] = std::max(high[i], other.high[i]);
  }
}

Box Box::enlarged(double by) const
{
  Box box = *this;
  for (int i = 0; i < 3; ++i) {
    box.low[i] -= by;
    box.high[i] += by;
  }
  return box;
}

bool Box::overlaps(const Box &other) const
{
  bool overlap = true;
  for (int i = 0; i < 3; ++i)
    overlap = overlap && low[i] <= other.high[i] && other.low[i] <= high[i];
  return overlap;
}

double Box::distance_square(const Point3 &x) const
{
  double square = 0;
  for (int i = 0; i < 3; ++i) {
    const double outside = std::max({low[i] - x[i], x[i] - high[i], 0.});
    square += outside * outside;
  }
  return square;
}

namespace
{

/// Lagrange to Bernstein coefficients of a quadratic, in each direction: the middle becomes 2 f1 - (f0 + f2) / 2.
void to_control_points(std::span<Point3> nodes)
{
  for (std::size_t stride = 1; stride < nodes.size(); stride *= 3)
    for (std::size_t n = 0; n < nodes.size(); ++n)
      if (n / stride % 3 == 1)
        nodes[n] = 2. * nodes[n] - 0.5 * (nodes[n - stride] + nodes[n + stride]);
}

} // namespace

Box enclosing_box(std::span<const Point3> nodes)
{
  std::array<Point3, 27> points;
  std::copy(nodes.begin(), nodes.end(), points.begin());
  const std::span<Point3> control(points.data(), nodes.size());
  to_control_points(control);
  Box box = {control[0], control[0]};
  for (const Point3 &point : control)
    box.include({point, point});
  return box;
}

BoxTree::BoxTree(std::vector<Box> boxes) : boxes_(std::move(boxes)), order_(boxes_.size())
{
  std::iota(order_.begin(), order_.end(), 0u);
  branches_.reserve(boxes_.size());
  if (!boxes_.empty())
    build(0, static_cast<std::uint32_t>(boxes_.size()));
}

/// Splits at the median along the longest side of the branch until four boxes are left.
void BoxTree::build(std::uint32_t begin, std::uint32_t end)
{
  const std::size_t index = branches_.size();
  Branch branch = {boxes_[order_[begin]], begin, end, 0};
  for (std::uint32_t k = begin; k < end; ++k)
    branch.box.include(boxes_[order_[k]]);
  branches_.push_back(branch);
  if (end - begin <= 4)
    return;
  const Point3 size = branch.box.high - branch.box.low;
  const int axis = size[0] > size[1] ? (size[0] > size[2] ? 0 : 2) : (size[1] > size[2] ? 1 : 2);
  const std::uint32_t middle = (begin + end) / 2;
  auto centre = [&](std::uint32_t k) { return boxes_[k].low[axis] + boxes_[k].high[axis]; };
  std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                   [&](std::uint32_t a, std::uint32_t b) { return centre(a) < centre(b); });
  build(begin, middle);
  branches_[index].right = static_cast<std::uint32_t>(branches_.size());
  build(middle, end);
}

} // namespace ballonet::solver::contact
