// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/command_line.h"
#include <deal.II/base/mpi.h>
#include <iostream>

int main(int argc, char *argv[])
{
  int one = 1; // PETSc shall not read our options
  dealii::Utilities::MPI::MPI_InitFinalize mpi(one, argv, 1);
  return ballonet::studies::run_command_line({argv + 1, argv + argc}, MPI_COMM_WORLD, std::cout, std::cerr);
}
