// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/coupling_pattern.h"
#include "tests/support/box_mesh.h"
#include <algorithm>
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

bool coupled(const CouplingPattern &pattern, Node a, Node b)
{
  const auto has = [&](Node row, Node other) {
    return std::binary_search(pattern.row(row).begin(), pattern.row(row).end(), other);
  };
  REQUIRE(has(a, b) == has(b, a));
  return has(a, b);
}

} // namespace

TEST_CASE("the pattern holds what is asked for, and lets go of it when it is many", "[mpi]")
{
  int rank, ranks;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  const Mesh mesh = box_mesh(8, 1, 1);
  const Discretization discretization(mesh, MPI_COMM_WORLD);
  CouplingPattern pattern(discretization);
  const Node far = mesh.cells.back()[26], near = mesh.cells.front()[0];
  const std::size_t of_cells = pattern.row(near).size();
  CHECK_FALSE(coupled(pattern, near, far));

  using Sets = std::vector<std::vector<Node>>;
  const bool last = rank == ranks - 1; // one rank asks, all learn it
  CHECK(pattern.cover(last ? Sets{{near, far}} : Sets{}));
  CHECK(coupled(pattern, near, far));
  CHECK_FALSE(pattern.cover(last ? Sets{{far, near}} : Sets{}));
  CHECK_FALSE(pattern.cover({})); // two entries too many are no reason for a new matrix
  CHECK(coupled(pattern, near, far));

  Sets all(1);
  for (Node node = 0; node < mesh.nodes.size(); ++node)
    all[0].push_back(node);
  CHECK(pattern.cover(all));
  CHECK(pattern.row(near).size() == mesh.nodes.size());
  CHECK(pattern.cover({}));
  CHECK(pattern.row(near).size() == of_cells);
}
