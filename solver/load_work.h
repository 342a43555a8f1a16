// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/cavity_work.h"

namespace ballonet::solver
{

/// Nodal masses by row sums (Simpson weights on affine cells, all positive), tonne; of this rank's cells of one body.
void add_nodal_mass(const Discretization &discretization, std::uint32_t body, double density,
                    std::vector<double> &mass);

/// Tangent vectors d x/d xi and d x/d eta of a face.
struct FaceTangents {
  Vector3 xi{}, eta{};
};

/// Dead forces on nodes, scaled with the load factor of the state: weight, dead tractions and forces on sets of nodes.
class DeadLoad : public VirtualWork
{
public:
  /// Throws std::invalid_argument for a load that is neither a traction or pressure on a surface nor a force on nodes.
  DeadLoad(const Discretization &discretization, const std::vector<double> &mass, const Vector3 &gravity,
           const std::vector<Load> &loads);
  double energy(const State &state) const override;
  void residual(const State &state, Assembly &out) const override;
  void tangent(const State &, Assembly &) const override {}

private:
  void add_traction(const Discretization &, const Load &);
  void add_nodal_forces(const Discretization &, const Load &);
  std::vector<double> force_; ///< N at load factor 1, three per node; this rank's part
  std::vector<Node> nodes_;   ///< those with a force
};

/// Follower pressure on a surface that is no controlled cavity, scaled with the load factor. Where the surface has a
/// free rim the load has no potential: the residual is exact, the tangent its symmetric part, the energy that of the
/// swept volume.
class FollowerLoad : public VirtualWork
{
public:
  FollowerLoad(const Discretization &discretization, const Load &load);
  double energy(const State &state) const override;
  void residual(const State &state, Assembly &out) const override;
  void tangent(const State &state, Assembly &out) const override;

private:
  FaceTangents tangents(const std::array<Node, n_face_nodes> &nodes, const State &state, int point) const;
  const Discretization &discretization_;
  CavityWork swept_;
  double pressure_;
  std::vector<std::array<Node, n_face_nodes>> faces_;
};

} // namespace ballonet::solver
