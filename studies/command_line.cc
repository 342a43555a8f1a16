// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/command_line.h"
#include "studies/version.h"
#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>

namespace ballonet::studies
{
namespace
{

using Command = std::function<ExitCode(const Invocation &)>;

/// The options as CLI11 fills them, and the command that was chosen.
struct Options {
  explicit Options(Invocation &invocation_) : invocation(invocation_) {}

  Invocation &invocation;
  std::vector<std::string> settings;
  Command command;
};

CLI::App *add_command(CLI::App &app, Options &options, const std::string &name, const std::string &help,
                      const Command &command)
{
  CLI::App *sub = app.add_subcommand(name, help);
  sub->callback([&options, command] { options.command = command; });
  return sub;
}

void add_study(CLI::App *sub, Options &options)
{
  sub->add_option("STUDY", options.invocation.study, "study file (TOML)")->required();
  sub->add_option("--set", options.settings, "path.to.key=value: replaces a key of the study; may be repeated")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
}

void add_directory(CLI::App *sub, Options &options)
{
  sub->add_option("-o,--output", options.invocation.directory, "results directory; default: results/NAME of the study")
      ->type_name("DIR");
}

void add_run(CLI::App &app, Options &options)
{
  CLI::App *run = add_command(app, options, "run", "do what the study asks", run_command);
  add_study(run, options);
  add_directory(run, options);
  run->add_flag("--resume", options.invocation.resume, "go on with an interrupted run in the same directory");
  run->add_flag("--dry-run", options.invocation.dry_run, "say what would be done, write nothing");
}

void add_commands(CLI::App &app, Options &options)
{
  add_run(app, options);
  CLI::App *mesh = add_command(app, options, "mesh", "mesh and its quality only", mesh_command);
  add_study(mesh, options);
  add_directory(mesh, options);
  CLI::App *print = add_command(app, options, "export", "the part to print", export_command);
  add_study(print, options);
  print->add_option("--stl", options.invocation.stl, "file to write")->type_name("FILE");
  print->add_option("--step", options.invocation.step, "file to write")->type_name("FILE");
  CLI::App *report = add_command(app, options, "report", "rebuild the report of a results directory", report_command);
  report->add_option("DIR", options.invocation.directory, "results directory")->required();
  CLI::App *describe =
      add_command(app, options, "describe", "every key: meaning, unit, range, default", describe_command);
  describe->add_option("KEY", options.invocation.key, "only keys that begin with this");
  add_study(add_command(app, options, "check", "validate a study, write nothing", check_command), options);
}

/// Parses and runs; help, version and mistakes on the command line end here too.
int parse_and_run(const std::vector<std::string> &arguments, Invocation &invocation)
{
  CLI::App app("Ballonet designs pneumatic soft actuators that stay stable.", "ballonet");
  app.set_version_flag("--version", version_text());
  app.require_subcommand(1);
  app.footer("Exit codes: 0 done, 1 ended without result, 2 wrong input, 3 internal error.\n"
             "In parallel: mpirun -n N ballonet run STUDY.toml");
  Options options(invocation);
  add_commands(app, options);
  try {
    app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
  } catch (const CLI::ParseError &e) {
    return app.exit(e, invocation.out, invocation.err) == 0 ? done : wrong_input;
  }
  for (const std::string &setting : options.settings)
    invocation.overrides.push_back(parse_override(setting));
  return options.command(invocation);
}

} // namespace

int run_command_line(const std::vector<std::string> &arguments, MPI_Comm communicator, std::ostream &out,
                     std::ostream &err)
{
  int rank = 0;
  MPI_Comm_rank(communicator, &rank);
  std::ostream silent(nullptr);
  Invocation invocation{
      communicator, rank == 0 ? out : silent, rank == 0 ? err : silent, {}, {}, {}, false, false, {}, {}, {}};
  try {
    return parse_and_run(arguments, invocation);
  } catch (const InputError &e) {
    invocation.err << "ballonet: " << e.what() << std::endl;
    return wrong_input;
  } catch (const std::exception &e) {
    invocation.err << "ballonet: internal error: " << e.what() << std::endl;
    return internal_error;
  }
}

} // namespace ballonet::studies
