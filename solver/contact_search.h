// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_patch.h"
#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace ballonet::solver::contact
{

/// A box with sides along the axes.
struct Box {
  Point3 low, high;

  void include(const Box &other);
  Box enlarged(double by) const;
  bool overlaps(const Box &other) const;
  double distance_square(const Point3 &) const;
};

/// A box around the biquadratic patch or triquadratic cell (9 or 27 nodes): it encloses its Bezier control points.
Box enclosing_box(std::span<const Point3> nodes);

/// A binary tree of boxes, built once for a set of them in O(n log n).
class BoxTree
{
public:
  explicit BoxTree(std::vector<Box> boxes);

  /// Calls visit(index) for every box that overlaps `box`.
  template <class Visit>
  void overlapping(const Box &box, Visit visit) const;

  /// Calls bound = visit(index, bound) for the boxes nearer to x than `bound` (mm), near branches first: a visitor that
  /// returns the smallest distance seen finds the nearest content without looking at the rest.
  template <class Visit>
  void nearest(const Point3 &x, double bound, Visit visit) const;

  const Box &box(std::uint32_t index) const { return boxes_[index]; }

private:
  struct Branch {
    Box box;
    std::uint32_t begin, end; ///< of order_
    std::uint32_t right;      ///< its left child follows directly; 0: a leaf
  };
  std::vector<Box> boxes_;
  std::vector<std::uint32_t> order_;
  std::vector<Branch> branches_;

  void build(std::uint32_t begin, std::uint32_t end);
};

template <class Visit>
void BoxTree::overlapping(const Box &box, Visit visit) const
{
  std::array<std::uint32_t, 64> stack;
  std::size_t depth = 0;
  if (!branches_.empty())
    stack[depth++] = 0;
  while (depth > 0) {
    const std::uint32_t index = stack[--depth];
    const Branch &branch = branches_[index];
    if (!branch.box.overlaps(box))
      continue;
    if (branch.right) {
      stack[depth++] = branch.right;
      stack[depth++] = index + 1;
    } else
      for (std::uint32_t k = branch.begin; k < branch.end; ++k)
        if (boxes_[order_[k]].overlaps(box))
          visit(order_[k]);
  }
}

template <class Visit>
void BoxTree::nearest(const Point3 &x, double bound, Visit visit) const
{
  struct Entry {
    std::uint32_t index;
    double square;
  };
  std::array<Entry, 64> stack;
  std::size_t depth = 0;
  if (!branches_.empty())
    stack[depth++] = {0, branches_[0].box.distance_square(x)};
  while (depth > 0) {
    const Entry entry = stack[--depth];
    if (entry.square > bound * bound)
      continue;
    const Branch &branch = branches_[entry.index];
    if (branch.right) {
      Entry left = {entry.index + 1, branches_[entry.index + 1].box.distance_square(x)};
      Entry right = {branch.right, branches_[branch.right].box.distance_square(x)};
      if (left.square < right.square)
        std::swap(left, right);
      stack[depth++] = left;
      stack[depth++] = right;
    } else
      for (std::uint32_t k = branch.begin; k < branch.end; ++k)
        if (boxes_[order_[k]].distance_square(x) <= bound * bound)
          bound = visit(order_[k], bound);
  }
}

} // namespace ballonet::solver::contact
