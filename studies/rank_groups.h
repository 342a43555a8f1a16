// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <mpi.h>

namespace ballonet::studies
{

/// The ranks of a communicator divided into groups of equal size; ranks left over belong to none.
class RankGroups
{
public:
  /// Throws std::invalid_argument if there are fewer ranks than one group needs. Collective.
  RankGroups(MPI_Comm all, int ranks_per_group);
  ~RankGroups();
  RankGroups(const RankGroups &) = delete;
  RankGroups &operator=(const RankGroups &) = delete;

  MPI_Comm all() const { return all_; }
  MPI_Comm group() const { return group_; } ///< of this rank; MPI_COMM_NULL if it is left over
  int count() const { return count_; }
  int index() const { return index_; }       ///< of this rank's group; count() if it is left over
  int rank() const { return rank_; }         ///< in all()
  bool is_leader() const { return leader_; } ///< first rank of its group

private:
  MPI_Comm all_, group_ = MPI_COMM_NULL;
  int rank_ = 0, count_ = 1, index_ = 0;
  bool leader_ = false;
};

} // namespace ballonet::studies
