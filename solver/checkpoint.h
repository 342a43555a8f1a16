// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/path_follower.h"

namespace ballonet::solver
{

/// Writes all that a path needs to go on, to a new file that replaces the old one in one move: a kill at any moment
/// leaves a whole checkpoint. Called by one rank.
void write_checkpoint(const std::string &file, const PathProgress &progress);

/// False when there is no such file. Throws std::runtime_error when it belongs to another mesh or is damaged.
bool read_checkpoint(const std::string &file, PathProgress &progress);

} // namespace ballonet::solver
