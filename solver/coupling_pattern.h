// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/discretization.h"
#include <vector>

namespace ballonet::solver
{

/// Which nodes share entries of the matrix: those of a cell, and those that contact couples. Complete on every rank.
class CouplingPattern
{
public:
  explicit CouplingPattern(const Discretization &);

  /// Makes room for these sets of nodes beyond the cells' own, each rank giving its part (collective). A pattern that
  /// holds them already is kept unless it has become much larger than needed. Returns whether it has changed.
  bool cover(const std::vector<std::vector<Node>> &couplings);

  /// The nodes that `node` is coupled with, itself included, sorted.
  const std::vector<Node> &row(Node node) const { return rows_[node]; }

private:
  using Rows = std::vector<std::vector<Node>>;
  const Discretization &discretization_;
  Rows of_cells_, rows_;

  Rows with(const std::vector<Node> &couplings) const;
  bool holds(const Rows &) const;
};

} // namespace ballonet::solver
