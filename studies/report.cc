// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/report.h"
#include <cstdlib>
#include <fcntl.h>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>

namespace ballonet::studies
{
namespace
{

std::filesystem::path script()
{
  const char *folder = std::getenv("BALLONET_SCRIPTS");
  return std::filesystem::path(folder ? folder : BALLONET_SCRIPTS) / "report.py";
}

/// Runs a program with one argument and waits; its standard output is dropped.
bool run_program(const std::string &program, const std::string &argument)
{
  std::string first = program, second = argument;
  char *arguments[] = {first.data(), second.data(), nullptr};
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int error = posix_spawn(&child, program.c_str(), &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  int status = 1;
  return error == 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace

bool make_report(const std::filesystem::path &directory, std::ostream &out)
{
  const bool made = run_program(script().string(), directory.string());
  if (made)
    out << (directory / "report.html").string() << std::endl;
  else
    out << "no report: " << script().string() << " did not work" << std::endl;
  return made;
}

} // namespace ballonet::studies
