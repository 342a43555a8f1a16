// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/history_row.h"
#include "solver/reduced/rib_ring.h"
#include <algorithm>
#include <cmath>
#include <numeric>

namespace ballonet::solver::reduced
{
namespace
{

constexpr double degree = std::numbers::pi / 180, kPa = 1e-3;

double volume(const BalloonTube &tube, double z, double b)
{
  const double a = tube.inner_radius(z, b);
  return std::numbers::pi * a * a * z * tube.length();
}

/// Bulge of the gap where it is largest over the mean of all; 1 without bulges.
double localisation_index(const PebsModel &model, const State &state)
{
  if (!state.touches_ribs)
    return 1;
  std::vector<double> heights;
  for (double th : state.gap_angle())
    heights.push_back(model.gap_bulge().slip_height(state.pressure, state.axial_stretch, th));
  const double largest = *std::max_element(heights.begin(), heights.end());
  const double n = static_cast<double>(heights.size());
  if (std::isinf(largest))
    return n;
  return largest > 0 ? largest * n / std::accumulate(heights.begin(), heights.end(), 0.0) : 1;
}

struct Tip {
  double x, z;
};

/// Middle of the head disc, mm. The hinges sit in the middle of their gaps, a lever behind the balloon's axis.
Tip tip(const PebsModel &model, const Angles &al)
{
  const Parameters &p = model.parameters();
  const double lever = model.hinge().lever, last = (p.pitch() + p.ribs.width + p.head.thickness) / 2;
  Tip tip = {-lever, p.ribs.gap / 2};
  for (std::size_t i = 0; i < al.size(); ++i) {
    const double length = i + 1 < al.size() ? p.pitch() : last;
    tip.x -= length * std::sin(al[i]);
    tip.z += length * std::cos(al[i]);
  }
  return {tip.x + lever * std::cos(al.back()), tip.z + lever * std::sin(al.back())};
}

std::string gap_column(std::size_t gap) { return (gap < 10 ? "gap_0" : "gap_") + std::to_string(gap) + "_deg"; }

} // namespace

std::vector<std::pair<std::string, double>> history_row(const PebsModel &model, const State &state)
{
  const double z = state.axial_stretch, b = state.outer_radius, B = model.parameters().balloon.diameter / 2;
  const double q = state.touches_ribs ? std::max(0.0, state.contact_pressure) : 0;
  const double v = volume(model.tube(), z, b);
  const Tip head = tip(model, state.al);
  std::vector<std::pair<std::string, double>> row = {
      {"time_s", state.time},
      {"pressure_kPa", state.pressure / kPa},
      {"volume_mm3", v},
      {"volume_ratio", v / volume(model.tube(), 1, B)},
      {"bending_angle_deg", state.angle / degree},
      {"twist_deg", 0},
      {"out_of_plane_deg", 0},
      {"tip_x_mm", head.x},
      {"tip_y_mm", 0},
      {"tip_z_mm", head.z},
      {"tip_force_N", 0},
      {"head_force_N", state.thrust},
      {"axial_ratio", z},
      {"radial_ratio", b / B},
      {"max_bulge_mm", state.bulge},
      {"localisation_index", localisation_index(model, state)},
      {"rib_contact_fraction", state.touches_ribs ? 1.0 : 0.0},
      {"rib_opening_mm", ring_growth(model.parameters(), q)},
  };
  const std::vector<double> th = state.gap_angle();
  for (std::size_t i = 0; i < th.size(); ++i)
    row.emplace_back(gap_column(i + 1), th[i] / degree);
  return row;
}

} // namespace ballonet::solver::reduced
