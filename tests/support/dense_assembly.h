// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/virtual_work.h"
#include <cstddef>

namespace ballonet::tests
{

/// Collects contributions in a dense vector and matrix over all nodes: for small meshes in tests.
class DenseAssembly : public solver::Assembly
{
public:
  std::vector<double> residual, tangent;                ///< size 3n and 3n x 3n, row by row
  std::vector<std::vector<solver::Node>> tangent_nodes; ///< the node sets add_tangent was called with

  explicit DenseAssembly(std::size_t n_nodes, bool with_tangent = true)
      : residual(3 * n_nodes, 0.), tangent(with_tangent ? 9 * n_nodes * n_nodes : 0, 0.)
  {
  }

  void add_residual(std::span<const solver::Node> nodes, std::span<const double> values) override
  {
    for (std::size_t a = 0; a < nodes.size(); ++a)
      for (std::size_t i = 0; i < 3; ++i)
        residual[3 * nodes[a] + i] += values[3 * a + i];
  }

  void add_tangent(std::span<const solver::Node> nodes, std::span<const double> values) override
  {
    tangent_nodes.emplace_back(nodes.begin(), nodes.end());
    const std::size_t n = 3 * nodes.size();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        tangent[(3 * nodes[i / 3] + i % 3) * residual.size() + 3 * nodes[j / 3] + j % 3] += values[n * i + j];
  }
};

} // namespace ballonet::tests
