// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/types.h"
#include <span>
#include <vector>

namespace ballonet::solver
{

/// Where contributions put their local vectors and matrices: the distributed system, or a dense one in a test.
class Assembly
{
public:
  virtual ~Assembly() = default;
  /// `values`: 3 per node, the force the contribution exerts against the displacement (d energy / d u).
  virtual void add_residual(std::span<const Node> nodes, std::span<const double> values) = 0;
  /// `values`: symmetric (3n) x (3n) matrix, row by row (d residual / d u).
  virtual void add_tangent(std::span<const Node> nodes, std::span<const double> values) = 0;
};

/// A contribution to the incremental potential of one step: elasticity, viscosity, mass, contact, ...
/// Life of a step: begin_step, then per iteration begin_iteration, residual and tangent, then advance.
/// Each rank contributes the part of the cells it owns; sums over ranks are the caller's.
class VirtualWork
{
public:
  virtual ~VirtualWork() = default;

  /// Freezes what stays the same during the step, such as histories and friction limits.
  virtual void begin_step(const State & /*start*/, const Step &) {}

  /// Called before the assembly of iteration `iteration` (0, 1, ...); contact may search again in the first ones.
  virtual void begin_iteration(const State &, int /*iteration*/) {}

  /// True when the couplings have changed in the last begin_step or begin_iteration.
  virtual bool couplings_changed() const { return false; }
  /// Sets of nodes this contribution couples beyond the cells' own.
  virtual void add_couplings(std::vector<std::vector<Node>> &) const {}

  /// This rank's part of the incremental potential, N mm.
  virtual double energy(const State &) const = 0;

  virtual void residual(const State &, Assembly &) const = 0;
  virtual void tangent(const State &, Assembly &) const = 0;

  /// While on, contact leaves the geometric part out of its tangent: what is left of it is positive semidefinite.
  virtual void convexify(bool /*on*/) {}

  /// Carries the stored Newton quantities (stresses, pressures) along with the displacement increment
  /// `fraction` * `increment` that starts at `from`.
  virtual void advance(const State & /*from*/, std::span<const double> /*increment*/, double /*fraction*/) {}

  /// The largest fraction (0, 1] of the increment this contribution can bear (this rank's part).
  virtual double largest_step(const State &, std::span<const double> /*increment*/) const { return 1; }
};

} // namespace ballonet::solver
