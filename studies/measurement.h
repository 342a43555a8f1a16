// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/simulation.h"
#include "studies/history_row.h"
#include "studies/simulation_model.h"
#include <memory>
#include <mpi.h>
#include <string>
#include <vector>

namespace ballonet::studies
{

/// One part of what is measured at a converged step.
class Gauge
{
public:
  virtual ~Gauge() = default;

  /// Appends its columns to those of the gauges before it. Called by all ranks of the simulation, gives all of them the
  /// same numbers.
  virtual void measure(const solver::PathPoint &point, const solver::Equilibrium &equilibrium, Row &row) = 0;

  /// Tells it the last row measured before an interruption.
  virtual void go_on_after(const Row &) {}
};

/// Everything that is measured in a study, as rows of history.csv.
class Measurement
{
public:
  /// `model` must outlive this object.
  Measurement(const Study &study, const SimulationModel &model, MPI_Comm communicator);

  Row measure(const solver::PathPoint &point, const solver::Equilibrium &equilibrium);
  void go_on_after(const Row &row);

private:
  std::vector<std::unique_ptr<Gauge>> gauges_;
};

/// Present positions of all nodes, mm.
std::vector<std::array<double, 3>> positions(const geometry::Mesh &mesh, const solver::State &state);

/// Largest entry of `values` (one per cell) within a body, 0 if the mesh has no such body.
double largest_in_body(const geometry::Mesh &mesh, const std::vector<double> &values, const std::string &body);

/// Sum over nodes of a vector field with three entries per node.
std::array<double, 3> sum_over(const std::vector<std::uint32_t> &nodes, const std::vector<double> &field);

/// The nodes of a surface, each once. Throws std::invalid_argument if the mesh has no such surface.
std::vector<std::uint32_t> surface_nodes(const geometry::Mesh &mesh, const std::string &surface);

/// The nodes of a set. Throws std::invalid_argument if the mesh has no such set.
const std::vector<std::uint32_t> &set_nodes(const geometry::Mesh &mesh, const std::string &set);

} // namespace ballonet::studies
