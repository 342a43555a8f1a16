// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/equilibrium.h"
#include "studies/measurement.h"
#include <filesystem>
#include <map>

namespace ballonet::studies
{

/// The fields of a simulation for ParaView: fields/step_NNNNNN.vtu in its folder, one file per kept state, and
/// fields.pvd, which lists them with their times. The points are those at rest; the nodal vector `displacement` (mm)
/// moves them. The points of a cell carry its `stress_MPa` (largest von Mises stress) and `body` (index).
class FieldFiles
{
public:
  /// Keeps the files of an earlier session that belong to one of `rows`, removes the others. Collective.
  FieldFiles(std::filesystem::path folder, const std::vector<Row> &rows, MPI_Comm communicator);

  /// Writes the state of a step. Collective. Throws if the disk is full.
  void add(int step, const solver::State &state, const std::vector<double> &stresses,
           const solver::Equilibrium &equilibrium);

private:
  void keep_files_of(const std::vector<Row> &rows);
  void write_collection() const;

  std::filesystem::path folder_;
  bool writes_;                 // the first rank
  std::map<int, double> times_; // by step, of the files there are; of the first rank
};

} // namespace ballonet::studies
