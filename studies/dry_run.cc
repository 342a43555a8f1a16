// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/dry_run.h"
#include "studies/content_hash.h"
#include "studies/simulation_model.h"
#include "studies/study_run.h"
#include <sstream>

namespace ballonet::studies
{

std::string mesh_text(const geometry::Mesh &mesh)
{
  std::ostringstream text;
  text << mesh.cells.size() << " cells, " << mesh.nodes.size() << " nodes, " << 3 * mesh.nodes.size()
       << " displacements; smallest scaled Jacobian " << mesh.quality.smallest_scaled_jacobian
       << ", largest aspect ratio " << mesh.quality.largest_aspect_ratio << " (worst cell " << mesh.quality.worst_cell
       << ")";
  return text.str();
}

bool print_dry_run(const StudyFile &file, const RankGroups &groups, std::ostream &out)
{
  int ranks = 1;
  MPI_Comm_size(groups.all(), &ranks);
  out << "study:       " << file.study().title.name << "\n"
      << "hash:        " << content_hash(file.study()) << "\n"
      << "variables:   " << file.space().size() << "\n"
      << "evaluations: at most " << largest_number_of_evaluations(file) << "\n"
      << "ranks:       " << ranks << ", " << groups.count() << " evaluation(s) at a time\n";
  if (file.study().method.model == ModelKind::reduced) {
    out << "mesh:        none, the reduced model needs none\n";
    return true;
  }
  const auto built = build_model(file.study());
  if (const auto *failure = std::get_if<geometry::MeshFailure>(&built)) {
    out << "mesh:        none: " << failure->reason << "\n";
    return false;
  }
  out << "mesh:        " << mesh_text(std::get<SimulationModel>(built).mesh) << "\n";
  return true;
}

} // namespace ballonet::studies
