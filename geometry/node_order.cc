// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/node_order.h"
#include <cmath>
#include <gmsh.h>

namespace ballonet::geometry
{

std::vector<unsigned> lexicographic_places(int element_type)
{
  std::string name;
  int dimension = 0, order = 0, nodes = 0, corners = 0;
  std::vector<double> reference;
  gmsh::model::mesh::getElementProperties(element_type, name, dimension, order, nodes, reference, corners);
  const auto width = static_cast<std::size_t>(dimension);
  std::vector<unsigned> places;
  for (std::size_t node = 0; node < static_cast<std::size_t>(nodes); ++node) {
    unsigned place = 0, stride = 1;
    for (std::size_t d = 0; d < width; ++d, stride *= 3)
      place += stride * static_cast<unsigned>(std::lround(reference[width * node + d] + 1));
    places.push_back(place);
  }
  return places;
}

} // namespace ballonet::geometry
