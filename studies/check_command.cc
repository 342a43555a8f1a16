// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/commands.h"
#include "studies/study_file.h"

namespace ballonet::studies
{

ExitCode check_command(const Invocation &invocation)
{
  const StudyFile file = StudyFile::open(invocation.study, invocation.overrides);
  invocation.out << invocation.study << ": correct, " << file.space().size() << " variable(s)\n";
  return done;
}

} // namespace ballonet::studies
