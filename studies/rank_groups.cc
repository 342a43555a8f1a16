// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/rank_groups.h"
#include <stdexcept>
#include <string>

namespace ballonet::studies
{

RankGroups::RankGroups(MPI_Comm all, int ranks_per_group) : all_(all)
{
  int size = 1;
  MPI_Comm_size(all, &size);
  MPI_Comm_rank(all, &rank_);
  count_ = size / ranks_per_group;
  if (count_ == 0)
    throw std::invalid_argument("an evaluation on " + std::to_string(ranks_per_group) + " ranks, but there are only " +
                                std::to_string(size));
  index_ = rank_ / ranks_per_group < count_ ? rank_ / ranks_per_group : count_;
  leader_ = index_ < count_ && rank_ % ranks_per_group == 0;
  MPI_Comm_split(all, index_ < count_ ? index_ : MPI_UNDEFINED, rank_, &group_);
}

RankGroups::~RankGroups()
{
  if (group_ != MPI_COMM_NULL)
    MPI_Comm_free(&group_);
}

} // namespace ballonet::studies
