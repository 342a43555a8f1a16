// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/measurement.h"
#include "geometry/boundary.h"
#include "studies/actuator_gauges.h"
#include "studies/obstacle_gauge.h"
#include "studies/path_gauges.h"
#include "studies/response_gauge.h"
#include "studies/stages.h"
#include <algorithm>
#include <stdexcept>

namespace ballonet::studies
{

Measurement::Measurement(const Study &study, const SimulationModel &model, MPI_Comm communicator)
{
  const bool symmetric = study.actuator.kind != ActuatorKind::mesh && study.mesh.symmetry;
  gauges_.push_back(std::make_unique<ControlGauge>(study.path.control));
  if (model.parameters.cavity)
    gauges_.push_back(std::make_unique<CavityGauge>(symmetric ? 2 : 1));
  if (!model.parameters.responses.empty())
    gauges_.push_back(std::make_unique<ResponseGauge>(model));
  if (study.actuator.kind == ActuatorKind::balloon)
    gauges_.push_back(std::make_unique<BalloonShapeGauge>(model, symmetric));
  if (study.actuator.kind == ActuatorKind::pebs)
    gauges_.push_back(std::make_unique<PebsShapeGauge>(model, symmetric, study.judge.rib_arc_share, communicator));
  if (study.actuator.kind == ActuatorKind::pebs)
    gauges_.push_back(std::make_unique<ObstacleGauge>(model.parameters, symmetric));
  gauges_.push_back(std::make_unique<NumericsGauge>());
  if (study.actuator.kind == ActuatorKind::pebs && study.actuator.pebs.with_balloon)
    gauges_.push_back(std::make_unique<StageGauge>(stage_thresholds(study)));
}

Row Measurement::measure(const solver::PathPoint &point, const solver::Equilibrium &equilibrium)
{
  Row row;
  for (const auto &gauge : gauges_)
    gauge->measure(point, equilibrium, row);
  return row;
}

void Measurement::go_on_after(const Row &row)
{
  for (const auto &gauge : gauges_)
    gauge->go_on_after(row);
}

std::vector<std::array<double, 3>> positions(const geometry::Mesh &mesh, const solver::State &state)
{
  auto result = mesh.nodes;
  for (std::size_t n = 0; n < result.size(); ++n)
    for (std::size_t i = 0; i < 3; ++i)
      result[n][i] += state.displacement[3 * n + i];
  return result;
}

double largest_in_body(const geometry::Mesh &mesh, const std::vector<double> &values, const std::string &body)
{
  double largest = 0;
  for (std::size_t cell = 0; cell < mesh.cells.size(); ++cell)
    if (mesh.bodies[mesh.cell_body[cell]].name == body)
      largest = std::max(largest, values[cell]);
  return largest;
}

std::array<double, 3> sum_over(const std::vector<std::uint32_t> &nodes, const std::vector<double> &field)
{
  std::array<double, 3> sum{};
  for (const std::uint32_t node : nodes)
    for (std::size_t i = 0; i < 3; ++i)
      sum[i] += field[3 * node + i];
  return sum;
}

std::vector<std::uint32_t> surface_nodes(const geometry::Mesh &mesh, const std::string &name)
{
  const geometry::Surface *surface = geometry::find_surface(mesh, name);
  if (!surface)
    throw std::invalid_argument("the mesh has no surface \"" + name + "\"");
  std::vector<std::uint32_t> nodes;
  for (const geometry::Face &face : surface->faces)
    for (const std::uint32_t node : geometry::nodes_of(mesh, face))
      nodes.push_back(node);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

const std::vector<std::uint32_t> &set_nodes(const geometry::Mesh &mesh, const std::string &name)
{
  for (const geometry::NodeSet &set : mesh.node_sets)
    if (set.name == name)
      return set.nodes;
  throw std::invalid_argument("the mesh has no set of nodes \"" + name + "\"");
}

} // namespace ballonet::studies
