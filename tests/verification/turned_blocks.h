// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/contact_work.h"
#include "solver/elastic_work.h"
#include "solver/load_work.h"
#include "solver/newton.h"
#include "tests/support/box_mesh.h"

namespace ballonet::tests
{

/// Rotation by `angle` (rad) about the direction (1, 2, 3), row by row.
solver::Matrix3 rotation(double angle);
/// Product of a matrix with every node's three values.
std::vector<double> rotated(const solver::Matrix3 &, const std::vector<double> &field);

/// A rubber block, held below and under pressure from a side, and another one on it, held above: pressed into it, it
/// slides along it while both are turned.
class TurnedBlocks
{
public:
  explicit TurnedBlocks(double friction, int passes = 2);

  /// A step of `dt` s to equilibrium with the upper block's top moved by `way` (in the axes that turn with the blocks)
  /// and everything turned by `angle` (rad) beyond where it was, beginning from the rigid rotation.
  void step(double dt, const solver::Vector3 &way, double load_factor, double angle);

  /// Forces on all nodes from outside, N: zero but at the two clamps.
  std::vector<double> forces() const { return newton_.forces(state_); }
  double stored_energy() const { return lower_.stored_energy(state_) + upper_.stored_energy(state_); } ///< N mm
  solver::ContactSummary contact() const { return contact_.summary(state_); }
  /// From the start to the present.
  solver::Matrix3 turned() const { return rotation(angle_); }

private:
  solver::Mesh mesh_;
  solver::Discretization discretization_;
  solver::ElasticWork lower_, upper_;
  solver::ContactWork contact_;
  solver::FollowerLoad load_;
  solver::LinearSystem system_;
  solver::NewtonSolver newton_;
  solver::State state_;
  double angle_ = 0;

  void turn_rigidly(double angle);
  void hold(const std::string &surface, const solver::Vector3 &way, solver::Prescribed &) const;
};

} // namespace ballonet::tests
