// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/commands.h"
#include <mpi.h>
#include <ostream>
#include <string>
#include <vector>

namespace ballonet::studies
{

/// The whole program behind main(): `arguments` without the program's name. Every rank calls it with the same
/// arguments; only rank 0 prints. Never throws.
int run_command_line(const std::vector<std::string> &arguments, MPI_Comm communicator, std::ostream &out,
                     std::ostream &err);

} // namespace ballonet::studies
