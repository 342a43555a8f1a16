// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/actuator_gauges.h"
#include "geometry/boundary.h"
#include "studies/actuator_pebs.h"
#include <algorithm>
#include <cmath>
#include <cstdio>

namespace ballonet::studies
{
namespace
{

std::string numbered(const char *format, std::size_t number)
{
  char text[32];
  std::snprintf(text, sizeof text, format, static_cast<int>(number));
  return text;
}

std::vector<std::uint32_t> cells_along(const geometry::Mesh &mesh, const std::string &surface)
{
  std::vector<std::uint32_t> cells;
  if (const geometry::Surface *found = geometry::find_surface(mesh, surface))
    for (const geometry::Face &face : found->faces)
      cells.push_back(face.cell);
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

void append_shape(const PebsMeasures &m, Row &row)
{
  row.emplace_back("bending_angle_deg", m.bending_angle);
  row.emplace_back("twist_deg", m.twist);
  row.emplace_back("out_of_plane_deg", m.out_of_plane);
  row.emplace_back("tip_x_mm", m.tip[0]);
  row.emplace_back("tip_y_mm", m.tip[1]);
  row.emplace_back("tip_z_mm", m.tip[2]);
}

} // namespace

BalloonShapeGauge::BalloonShapeGauge(const SimulationModel &model, bool symmetric)
    : model_(model), balloon_(*model.layout, model.mesh.nodes, symmetric)
{
}

void BalloonShapeGauge::measure(const solver::PathPoint &point, const solver::Equilibrium &equilibrium, Row &row)
{
  const auto present = positions(model_.mesh, point.progress.state);
  row.emplace_back("axial_ratio", balloon_.axial_ratio(present));
  row.emplace_back("radial_ratio", balloon_.radial_ratio(present));
  row.emplace_back("balloon_stress_max_MPa",
                   largest_in_body(model_.mesh, equilibrium.stresses(point.progress.state), "balloon"));
}

PebsShapeGauge::PebsShapeGauge(const SimulationModel &model, bool symmetric, double rib_arc_share,
                               MPI_Comm communicator)
    : model_(model), gauge_(*model.layout, model.mesh.nodes, symmetric), copies_(symmetric ? 2 : 1),
      rib_arc_share_(rib_arc_share), communicator_(communicator), head_top_(surface_nodes(model.mesh, "head_top"))
{
  if (const geometry::Surface *head = geometry::find_surface(model.mesh, "head_contact"))
    for (const geometry::Face &face : head->faces)
      head_faces_.emplace(face.cell, face.local);
  for (std::size_t rib = 1; rib <= model.layout->ribs.size(); ++rib)
    rib_cells_.push_back(cells_along(model.mesh, numbered("rib_inner_%02d", rib)));
}

PebsShapeGauge::Touch PebsShapeGauge::touch(const solver::State &state, const solver::Equilibrium &equilibrium) const
{
  double force = 0;
  std::vector<char> mark(model_.mesh.cells.size(), 0);
  const auto &pairs = model_.parameters.contact_pairs;
  const auto points = equilibrium.contacts().points(state);
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (pairs[i].name == cage_pair)
      for (const solver::ContactPoint &point : points[i]) {
        mark[point.primary->cell] = 1;
        if (head_faces_.contains({point.primary->cell, point.primary->local}))
          force += point.pressure * point.area;
      }
  MPI_Allreduce(MPI_IN_PLACE, &force, 1, MPI_DOUBLE, MPI_SUM, communicator_);
  MPI_Allreduce(MPI_IN_PLACE, mark.data(), static_cast<int>(mark.size()), MPI_CHAR, MPI_MAX, communicator_);
  const std::vector<bool> touched(mark.begin(), mark.end());
  return {copies_ * force, touched_share(rib_cells_, touched, rib_arc_share_)};
}

double PebsShapeGauge::tip_force(const solver::State &state, const solver::Equilibrium &equilibrium) const
{
  auto force = sum_over(head_top_, equilibrium.reactions(state));
  if (copies_ > 1)
    force[1] = 0; // cancelled by the mirror image
  return copies_ * std::hypot(force[0], force[1], force[2]);
}

void PebsShapeGauge::measure(const solver::PathPoint &point, const solver::Equilibrium &equilibrium, Row &row)
{
  const solver::State &state = point.progress.state;
  const PebsMeasures m = gauge_.measure(positions(model_.mesh, state), angle_);
  angle_ = m.bending_angle;
  const Touch touched = touch(state, equilibrium);
  const auto stress = equilibrium.stresses(state);
  append_shape(m, row);
  row.emplace_back("tip_force_N", tip_force(state, equilibrium));
  row.emplace_back("head_force_N", touched.head_force);
  row.emplace_back("axial_ratio", m.axial_ratio);
  row.emplace_back("radial_ratio", m.radial_ratio);
  row.emplace_back("balloon_stress_max_MPa", largest_in_body(model_.mesh, stress, "balloon"));
  row.emplace_back("backbone_stress_max_MPa", largest_in_body(model_.mesh, stress, "backbone"));
  row.emplace_back("max_bulge_mm", m.max_bulge);
  row.emplace_back("localisation_index", m.localisation);
  row.emplace_back("rib_contact_fraction", touched.rib_fraction);
  row.emplace_back("rib_opening_mm", m.rib_opening);
  for (std::size_t gap = 1; gap <= m.gaps.size(); ++gap)
    row.emplace_back(numbered("gap_%02d_deg", gap), m.gaps[gap - 1]);
}

} // namespace ballonet::studies
