// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/backbone.h"
#include "geometry/disc_grid.h"
#include "geometry/rib_pattern.h"
#include "geometry/ring_lines.h"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace ballonet::geometry
{

namespace
{

constexpr double core_share = 0.6; ///< radius of a disc's core over the cage's inner radius

/// What all parts of the backbone are drawn from.
struct Drawing {
  const Pebs &pebs;
  const MeshSizes &sizes;
  RibPattern pattern;

  double inner() const { return pebs.ribs.inner_radius; }
  double wall_outer() const { return inner() + pebs.wall.thickness; }
  double outer() const { return inner() + pebs.ribs.thickness; }
};

/// A range of radii with its elements: the wall's layer, or the rest of the rib.
struct Layer {
  double inner, outer;
  int elements;
  double radius(double k) const { return inner + (outer - inner) * k / elements; }
};

Layer wall_layer(const Drawing &d) { return {d.inner(), d.wall_outer(), d.sizes.through_wall}; }
Layer rib_layer(const Drawing &d) { return {d.wall_outer(), d.outer(), d.sizes.through_rib}; }

RingLines base_lines(const Drawing &d)
{
  return {d.sizes.around_ring, {{d.pattern.strip_foot(0), d.pattern.half_window(), d.sizes.across_wall}}, {}};
}

RingLines rib_lines(const Drawing &d, int rib)
{
  const double land = d.pattern.orientation(rib), half_arc = d.pattern.half_arc(rib);
  std::vector<Window> windows = {{land, d.pattern.half_window(), d.sizes.across_wall}};
  if (d.pattern.has_second_land(rib))
    windows.push_back({d.pattern.strip_foot(rib + 1), d.pattern.half_window(), d.sizes.across_wall});
  if (d.pattern.half_arc(rib) > std::numbers::pi - 1e-9)
    return {d.sizes.around_ring, windows, {}};
  return {d.sizes.around_ring, windows, {land - half_arc, land + half_arc}};
}

bool in_window(const Drawing &d, double centre, double angle)
{
  return std::abs(wrap_angle(angle - centre)) < d.pattern.half_window();
}

/// One column of a rib ring between two neighbouring mesh lines, one radial layer of it.
void add_column(BlockMesh &blocks, const Drawing &d, const RingLines &lines, int rib, int column, const Layer &layer,
                bool land)
{
  const double orientation = d.pattern.orientation(rib);
  const int along = d.sizes.along_rib;
  const auto map = [&](double i, double j, double k) {
    const double angle = lines.angle(column + i), chi = angle - orientation;
    const double lower = d.pattern.lower(rib, chi), upper = d.pattern.upper(rib, chi);
    return cylinder_point(layer.radius(k), angle, lower + (upper - lower) * j / along);
  };
  const std::array<Side, 6> sides = {Side::edge, Side::edge, Side::lower, Side::upper, Side::inner, Side::outer};
  blocks.add("backbone", {1, along, layer.elements}, map, {Part::rib, rib, land, sides});
}

void add_rib(BlockMesh &blocks, const Drawing &d, int rib)
{
  const RingLines lines = rib_lines(d, rib);
  const double orientation = d.pattern.orientation(rib);
  for (int column = 0; column < lines.count(); ++column) {
    const double middle = lines.angle(column + 0.5);
    if (std::abs(wrap_angle(middle - orientation)) > d.pattern.half_arc(rib))
      continue;
    const bool land = in_window(d, orientation, middle) ||
                      (d.pattern.has_second_land(rib) && in_window(d, d.pattern.strip_foot(rib + 1), middle));
    add_column(blocks, d, lines, rib, column, wall_layer(d), land);
    if (!land || d.pebs.wall.thick_land)
      add_column(blocks, d, lines, rib, column, rib_layer(d), land);
  }
}

/// Point of a strip: eta = -1 ... 1 across, fraction along the fold, distance from the middle line outwards.
/// The width stays the same along the fold, so the angle shrinks as the fold moves out.
Point strip_point(const Drawing &d, int gap, double eta, double fraction, double distance)
{
  const RibPattern &pattern = d.pattern;
  const FoldPoint fold = pattern.corrugation(gap, eta).at(fraction);
  const double turn = wrap_angle(pattern.strip_top(gap) - pattern.strip_foot(gap));
  const double middle = pattern.wall_radius() + fold.height;
  const double angle =
      pattern.strip_foot(gap) + fraction * turn + eta * pattern.half_window() * pattern.wall_radius() / middle;
  return cylinder_point(middle + distance * fold.normal_height, angle,
                        pattern.strip_start(gap, eta) + fold.axial + distance * fold.normal_axial);
}

double fold_length(const Drawing &d, int gap) { return d.pattern.corrugation(gap, 0).length(); }

double mean_fold_length(const Drawing &d)
{
  double sum = 0;
  for (int gap = 0; gap < d.pattern.count(); ++gap)
    sum += fold_length(d, gap);
  return sum / d.pattern.count();
}

/// Elements along a fold: in proportion to its length, even, so that the crest is a mesh line.
int fold_elements(const Drawing &d, int gap, double mean_length)
{
  const double share = d.sizes.along_fold * fold_length(d, gap) / mean_length;
  return std::max(std::min(4, d.sizes.along_fold), 2 * static_cast<int>(std::lround(share / 2)));
}

void add_strip(BlockMesh &blocks, const Drawing &d, int gap, int along)
{
  const int across = d.sizes.across_wall, through = d.sizes.through_wall;
  const auto map = [&](double i, double j, double k) {
    return strip_point(d, gap, 2 * i / across - 1, j / along, d.pebs.wall.thickness * (k / through - 0.5));
  };
  const std::array<Side, 6> sides = {Side::edge, Side::edge, Side::none, Side::none, Side::inner, Side::outer};
  blocks.add("backbone", {across, along, through}, map, {Part::strip, gap, false, sides});
}

/// A full disc between two heights, out to the ribs' outer radius, on given mesh lines.
void add_disc(BlockMesh &blocks, const Drawing &d, const RingLines &lines, double bottom, double top, int through,
              Part part)
{
  const DiscGrid grid(
      lines.count(), [&](double index) { return lines.angle(index); }, core_share);
  const auto height = [=](double k) { return bottom + (top - bottom) * k / through; };
  const double inner = d.inner();
  const int rings = d.sizes.disc_rings;
  const CellTag tag{part, 0, false, {Side::none, Side::none, Side::none, Side::none, Side::lower, Side::upper}};
  const auto place = [&](const std::array<double, 2> &p, double k) {
    return cylinder_point(inner * p[0], p[1], height(k));
  };
  blocks.add(
      "backbone", {grid.core_count(), grid.core_count(), through},
      [&](double i, double j, double k) { return place(grid.core(i, j), k); }, tag);
  blocks.add(
      "backbone", {lines.count(), rings, through},
      [&](double i, double j, double k) { return place(grid.ring(i, j / rings), k); }, tag);
  for (const Layer &layer : {wall_layer(d), rib_layer(d)})
    blocks.add(
        "backbone", {lines.count(), layer.elements, through},
        [&](double i, double j, double k) { return cylinder_point(layer.radius(j), lines.angle(i), height(k)); }, tag);
}

} // namespace

void add_backbone(BlockMesh &blocks, const Pebs &pebs, const MeshSizes &sizes)
{
  const Drawing d{pebs, sizes, RibPattern(pebs.ribs, pebs.wall)};
  const int top = pebs.ribs.count - 1;
  const double height = d.pattern.height();
  add_disc(blocks, d, base_lines(d), -pebs.base.thickness, 0, sizes.through_base, Part::base);
  const double mean_length = mean_fold_length(d);
  for (int k = 0; k <= top; ++k) {
    add_strip(blocks, d, k, fold_elements(d, k, mean_length));
    add_rib(blocks, d, k);
  }
  add_disc(blocks, d, rib_lines(d, top), height, height + pebs.head.thickness, sizes.through_head, Part::head);
}

} // namespace ballonet::geometry
