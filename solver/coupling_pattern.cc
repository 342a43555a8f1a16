// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/coupling_pattern.h"
#include <algorithm>

namespace ballonet::solver
{

namespace
{

void sort_without_repetition(std::vector<Node> &row)
{
  std::sort(row.begin(), row.end());
  row.erase(std::unique(row.begin(), row.end()), row.end());
}

std::size_t entries(const std::vector<std::vector<Node>> &rows)
{
  std::size_t sum = 0;
  for (const auto &row : rows)
    sum += row.size();
  return sum;
}

/// The sets of all ranks on every rank: [size, nodes..., size, nodes..., ...].
std::vector<Node> gathered(const std::vector<std::vector<Node>> &sets, MPI_Comm comm)
{
  std::vector<Node> mine;
  for (const auto &set : sets) {
    mine.push_back(set.size());
    mine.insert(mine.end(), set.begin(), set.end());
  }
  int size = mine.size(), ranks;
  MPI_Comm_size(comm, &ranks);
  std::vector<int> sizes(ranks), offsets(ranks + 1);
  MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, comm);
  for (int r = 0; r < ranks; ++r)
    offsets[r + 1] = offsets[r] + sizes[r];
  std::vector<Node> all(offsets[ranks]);
  MPI_Allgatherv(mine.data(), size, MPI_UNSIGNED, all.data(), sizes.data(), offsets.data(), MPI_UNSIGNED, comm);
  return all;
}

} // namespace

CouplingPattern::CouplingPattern(const Discretization &discretization)
    : discretization_(discretization), of_cells_(discretization.n_nodes())
{
  for (const auto &cell : discretization.mesh().cells)
    for (const auto node : cell)
      of_cells_[node].insert(of_cells_[node].end(), cell.begin(), cell.end());
  for (auto &row : of_cells_)
    sort_without_repetition(row);
  rows_ = of_cells_;
}

CouplingPattern::Rows CouplingPattern::with(const std::vector<Node> &couplings) const
{
  Rows rows = of_cells_;
  for (std::size_t i = 0; i < couplings.size(); i += couplings[i] + 1) {
    const auto first = couplings.begin() + i + 1, last = first + couplings[i];
    for (auto node = first; node != last; ++node)
      rows[*node].insert(rows[*node].end(), first, last);
  }
  for (std::size_t node = 0; node < rows.size(); ++node)
    if (rows[node].size() > of_cells_[node].size())
      sort_without_repetition(rows[node]);
  return rows;
}

bool CouplingPattern::holds(const Rows &rows) const
{
  for (std::size_t node = 0; node < rows.size(); ++node)
    if (!std::includes(rows_[node].begin(), rows_[node].end(), rows[node].begin(), rows[node].end()))
      return false;
  return true;
}

bool CouplingPattern::cover(const std::vector<std::vector<Node>> &couplings)
{
  constexpr double spare = 1.05; // a larger pattern costs more in every factorisation than a new one once
  Rows needed = with(gathered(couplings, discretization_.comm()));
  if (holds(needed) && entries(rows_) <= spare * entries(needed))
    return false;
  rows_ = std::move(needed);
  return true;
}

} // namespace ballonet::solver
