// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/contact_shift.h"
#include <map>

namespace ballonet::solver::contact
{

namespace
{

std::array<double, 4> bilinear(const Parameters2 &xi)
{
  return {(1 - xi[0]) * (1 - xi[1]), xi[0] * (1 - xi[1]), (1 - xi[0]) * xi[1], xi[0] * xi[1]};
}

} // namespace

std::size_t number_shift_nodes(std::span<Patch> patches)
{
  constexpr std::array<std::size_t, 4> corners = {0, 2, 6, 8};
  std::map<std::pair<bool, Node>, std::uint32_t> number; // of the corner of a side
  for (Patch &patch : patches)
    for (std::size_t k = 0; k < 4 && !patch.points.empty(); ++k) {
      const std::pair corner = {patch.depth == 0, patch.nodes[patch.place(corners[k], 0)]};
      patch.shift_node[k] = number.insert({corner, static_cast<std::uint32_t>(number.size())}).first->second;
    }
  return number.size();
}

std::span<const double> shifts_of_pair(const State &state, std::size_t first, std::size_t n)
{
  const std::span<const double> all = state.contact_shift;
  return all.empty() ? all : all.subspan(first, n);
}

double shift_at(const Patch &patch, const Parameters2 &xi, std::span<const double> shifts)
{
  if (shifts.empty())
    return 0;
  const auto weights = bilinear(xi);
  double shift = 0;
  for (int k = 0; k < 4; ++k)
    shift += weights[k] * shifts[patch.shift_node[k]];
  return shift;
}

void MeanGaps::add(const Patch &patch, const Parameters2 &xi, std::size_t first, double normal_force,
                   double penetration)
{
  const auto weights = bilinear(xi);
  for (int k = 0; k < 4; ++k) {
    force[first + patch.shift_node[k]] += weights[k] * normal_force;
    moment[first + patch.shift_node[k]] += weights[k] * normal_force * penetration;
  }
}

} // namespace ballonet::solver::contact
