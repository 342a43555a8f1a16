// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/commands.h"
#include "studies/study_file.h"

namespace ballonet::studies
{
ExitCode run_command(const Invocation &i)
{
  StudyFile::open(i.study, i.overrides);
  return internal_error;
}
ExitCode mesh_command(const Invocation &i)
{
  StudyFile::open(i.study, i.overrides);
  return internal_error;
}
ExitCode export_command(const Invocation &i)
{
  StudyFile::open(i.study, i.overrides);
  return internal_error;
}
ExitCode report_command(const Invocation &) { return internal_error; }
} // namespace ballonet::studies
