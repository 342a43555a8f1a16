// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/commands.h"
#include "studies/report.h"
#include <filesystem>

namespace ballonet::studies
{

ExitCode report_command(const Invocation &invocation)
{
  if (!std::filesystem::is_directory(invocation.directory))
    throw InputError({invocation.directory}, "", "no directory", "a results directory");
  int rank = 0, made = 0;
  MPI_Comm_rank(invocation.communicator, &rank);
  if (rank == 0)
    made = make_report(invocation.directory, invocation.out);
  MPI_Bcast(&made, 1, MPI_INT, 0, invocation.communicator);
  return made ? done : no_result;
}

} // namespace ballonet::studies
