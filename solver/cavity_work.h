// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/discretization.h"
#include "solver/parameters.h"
#include "solver/virtual_work.h"

namespace ballonet::solver
{

/// The gas volume enclosed by a surface and the planes that close it,
///   V = -(1/d) int (x - origin) . n da   over the d measured directions (n points out of the solid, into the gas),
/// and the work -p V of its pressure. The follower pressure derives from V, so its tangent is symmetric.
class CavityWork : public VirtualWork
{
public:
  CavityWork(const Discretization &discretization, const Cavity &cavity);

  /// This rank's part of V, mm^3.
  double volume(const State &state) const;
  /// Adds this rank's part of dV/du.
  void volume_gradient(const State &state, Assembly &out) const;

  double energy(const State &state) const override { return -state.pressure * volume(state); }
  void residual(const State &state, Assembly &out) const override;
  void tangent(const State &state, Assembly &out) const override;

private:
  using FaceVector = std::array<double, 3 * n_face_nodes>;
  struct Point;
  FaceVector positions(const std::array<Node, n_face_nodes> &nodes, const State &state) const;
  void add_gradient(const State &state, double factor, Assembly &out) const;

  const Discretization &discretization_;
  Vector3 origin_, share_; ///< share_: 1/d for measured directions, else 0
  std::vector<std::array<Node, n_face_nodes>> faces_;
};

} // namespace ballonet::solver
