// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/toml_document.h"
#include <mpi.h>
#include <ostream>
#include <string>
#include <vector>

namespace ballonet::studies
{

/// How the program ends.
enum ExitCode {
  done = 0,
  no_result = 1,     ///< the run ended without its result; the reason is in summary.json
  wrong_input = 2,   ///< the message names file, line, key, what was given and what is allowed
  internal_error = 3 ///< a bug
};

/// What all commands share. `out` and `err` print on one rank only.
struct Invocation {
  MPI_Comm communicator;
  std::ostream &out, &err;
  std::string study;               ///< file
  std::string directory;           ///< of results; empty: results/NAME of the study file for a run, here for a mesh
  std::vector<Override> overrides; ///< --set
  bool resume = false, dry_run = false;
  std::string key;       ///< describe
  std::string stl, step; ///< export
};

/// Each returns its exit code and throws InputError for wrong input.
ExitCode run_command(const Invocation &);
ExitCode mesh_command(const Invocation &);
ExitCode export_command(const Invocation &);
ExitCode report_command(const Invocation &);
ExitCode describe_command(const Invocation &);
ExitCode check_command(const Invocation &);

} // namespace ballonet::studies
