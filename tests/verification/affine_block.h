// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/elastic_work.h"
#include "solver/newton.h"
#include "tests/support/box_mesh.h"

namespace ballonet::tests
{

/// A unit cube of eight distorted cells whose whole boundary is moved by x = F X.
class AffineBlock
{
public:
  AffineBlock(const solver::Material &, bool mixed);

  /// Equilibrium of the inner nodes.
  solver::NewtonSolver::Outcome deform(const solver::Matrix3 &F);

  /// Largest distance of a node from F X, mm.
  double displacement_error(const solver::Matrix3 &F) const;
  /// Largest von Mises stress of each cell, MPa.
  std::vector<double> stresses() const;
  /// Mean first Piola-Kirchhoff stress, MPa, from the forces f on the boundary alone: P = sum f (x) X / volume.
  solver::Matrix3 mean_stress() const;

private:
  solver::Mesh mesh_;
  solver::Discretization discretization_;
  solver::ElasticWork work_;
  solver::LinearSystem system_;
  solver::NewtonSolver newton_;
  solver::State state_;
};

} // namespace ballonet::tests
