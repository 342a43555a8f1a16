// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/hdf5_file.h"
#include "solver/mesh.h"
#include "solver/types.h"

namespace ballonet::solver
{

/// history.h5 of a simulation: the exposed surface as quadrilaterals and its deformed shapes along the path.
///
///   /surface          attribute bodies ("a,b"), data sets faces (n x 4, points in cyclic order) and face_body (n)
///   /states/000012    data sets points (m x 3, mm) and stress (m, MPa); attributes given by the caller
///   /critical_points/0001    data sets points and mode (m x 3); attribute kind, and those given by the caller
///
/// Written by one rank.
class HistoryFile
{
public:
  /// Continues an existing file when `append`, dropping states of steps after `last_step`. Faces of the `hidden`
  /// surface (a symmetry plane) are left out.
  HistoryFile(const std::string &path, const Mesh &mesh, const std::string &hidden, bool append, int last_step);

  /// `cell_stress`: one value per cell; a point shows the largest of its cells.
  void add(int step, const State &state, const std::vector<double> &cell_stress,
           const std::map<std::string, double> &attributes);

  /// `facts` has the "step" in which the point was found.
  void add_critical_point(const std::string &kind, const State &state, const std::vector<double> &mode,
                          const std::map<std::string, double> &facts);

private:
  void write_surface();
  std::vector<float> at_surface(const std::vector<double> &field) const;
  std::vector<float> positions(const State &state) const;
  void drop_after(int last_step);
  static std::string group(int step);

  const Mesh &mesh_;
  Hdf5File file_;
  std::vector<int> faces_, face_body_;
  std::vector<Node> points_; ///< nodes of the surface
};

} // namespace ballonet::solver
