// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/quality.h"
#include "geometry/hexahedron.h"
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace ballonet::geometry
{

namespace
{

/// min det J / max det J; at most 0 for a cell that is folded anywhere.
double scaled_jacobian(const CellNodes &nodes)
{
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  for (const QuadraturePoint &gauss : gauss_points()) {
    const double value = jacobian(map_point(nodes, gauss.reference));
    smallest = std::min(smallest, value);
    largest = std::max(largest, std::abs(value));
  }
  return largest > 0 ? smallest / largest : 0;
}

double distance(const Point &a, const Point &b)
{
  const Point d = difference(a, b);
  return std::sqrt(dot(d, d));
}

/// Mean length of the four edges along a reference axis, each measured over its middle node.
double mean_edge(const CellNodes &nodes, unsigned axis)
{
  constexpr std::array<unsigned, 3> stride = {1, 3, 9};
  const unsigned step = stride[axis], u = stride[(axis + 1) % 3], v = stride[(axis + 2) % 3];
  double sum = 0;
  for (const unsigned start : {0U, 2 * u, 2 * v, 2 * u + 2 * v})
    sum += distance(nodes[start], nodes[start + step]) + distance(nodes[start + step], nodes[start + 2 * step]);
  return sum / 4;
}

double aspect_ratio(const CellNodes &nodes)
{
  const auto [shortest, longest] = std::minmax({mean_edge(nodes, 0), mean_edge(nodes, 1), mean_edge(nodes, 2)});
  return shortest > 0 ? longest / shortest : std::numeric_limits<double>::infinity();
}

std::string place(const Mesh &mesh, std::size_t cell)
{
  const Point &centre = mesh.nodes[mesh.cells[cell][13]];
  std::ostringstream text;
  text << "in body \"" << mesh.bodies[mesh.cell_body[cell]].name << "\" at (" << centre[0] << ", " << centre[1] << ", "
       << centre[2] << ") mm";
  return text.str();
}

} // namespace

Quality measure_quality(const Mesh &mesh)
{
  Quality quality{std::numeric_limits<double>::infinity(), 0, 0, 0};
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell) {
    const CellNodes nodes = cell_nodes(mesh, cell);
    const double scaled = scaled_jacobian(nodes), aspect = aspect_ratio(nodes);
    if (scaled < quality.smallest_scaled_jacobian) {
      quality.smallest_scaled_jacobian = scaled;
      quality.worst_cell = cell;
    }
    if (aspect > quality.largest_aspect_ratio) {
      quality.largest_aspect_ratio = aspect;
      quality.longest_cell = cell;
    }
  }
  return quality;
}

std::optional<std::string> rejection(const Mesh &mesh, const Quality &quality, const QualityLimits &limits)
{
  std::ostringstream text;
  if (!(quality.smallest_scaled_jacobian > 0))
    text << "a cell is folded (scaled Jacobian " << quality.smallest_scaled_jacobian << ") "
         << place(mesh, quality.worst_cell);
  else if (quality.smallest_scaled_jacobian < limits.smallest_jacobian)
    text << "scaled Jacobian " << quality.smallest_scaled_jacobian << " below " << limits.smallest_jacobian << ' '
         << place(mesh, quality.worst_cell);
  else if (quality.largest_aspect_ratio > limits.largest_aspect)
    text << "aspect ratio " << quality.largest_aspect_ratio << " above " << limits.largest_aspect << ' '
         << place(mesh, quality.longest_cell);
  else
    return std::nullopt;
  return text.str();
}

} // namespace ballonet::geometry
