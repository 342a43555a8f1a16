// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "geometry/mesh.h"
#include "studies/rank_groups.h"
#include "studies/study_file.h"
#include <ostream>

namespace ballonet::studies
{

/// Says what a run would do: mesh, number of evaluations, ranks, hash. Writes no file. False if there is no mesh of the
/// study as it stands.
bool print_dry_run(const StudyFile &study, const RankGroups &groups, std::ostream &out);

/// One line about a mesh: cells, nodes, quality.
std::string mesh_text(const geometry::Mesh &mesh);

} // namespace ballonet::studies
