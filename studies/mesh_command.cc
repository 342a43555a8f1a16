// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/mesh_io.h"
#include "geometry/surface_export.h"
#include "studies/commands.h"
#include "studies/dry_run.h"
#include "studies/simulation_model.h"
#include "studies/study_file.h"
#include <filesystem>

namespace ballonet::studies
{
namespace
{

/// Prints why there is none, on rank 0.
ExitCode failed(const geometry::MeshFailure &failure, const Invocation &invocation)
{
  invocation.err << "ballonet: " << failure.reason << std::endl;
  return no_result;
}

bool is_first(const Invocation &invocation)
{
  int rank = 0;
  MPI_Comm_rank(invocation.communicator, &rank);
  return rank == 0;
}

} // namespace

ExitCode mesh_command(const Invocation &invocation)
{
  const StudyFile study = StudyFile::open(invocation.study, invocation.overrides);
  const auto built = build_model(study.study());
  if (const auto *failure = std::get_if<geometry::MeshFailure>(&built))
    return failed(*failure, invocation);
  const geometry::Mesh &mesh = std::get<SimulationModel>(built).mesh;
  const std::filesystem::path folder = invocation.directory.empty() ? "." : invocation.directory;
  if (is_first(invocation)) {
    std::filesystem::create_directories(folder);
    if (const auto failure = geometry::write_msh(mesh, folder / "mesh.msh"))
      return failed(*failure, invocation);
  }
  invocation.out << (folder / "mesh.msh").string() << ": " << mesh_text(mesh) << std::endl;
  return done;
}

ExitCode export_command(const Invocation &invocation)
{
  const StudyFile study = StudyFile::open(invocation.study, invocation.overrides);
  if (study.study().actuator.kind != ActuatorKind::pebs)
    throw InputError({invocation.study}, "actuator.kind", "an actuator that is not printed", "pebs");
  if (!invocation.step.empty())
    throw InputError({"export"}, "--step", invocation.step, "--stl FILE",
                     "STEP files are not available in this version");
  if (invocation.stl.empty())
    throw InputError({"export"}, "", "no file to write", "--stl FILE");
  const auto built = build_model(study.study());
  if (const auto *failure = std::get_if<geometry::MeshFailure>(&built))
    return failed(*failure, invocation);
  if (is_first(invocation))
    if (const auto failure = geometry::write_stl(std::get<SimulationModel>(built).mesh, "backbone", invocation.stl))
      return failed(*failure, invocation);
  invocation.out << invocation.stl << std::endl;
  return done;
}

} // namespace ballonet::studies
