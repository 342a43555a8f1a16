// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/critical_points.h"
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ballonet::studies
{

/// A critical point as it stands in history.h5 and journal.jsonl.
struct CriticalRecord {
  std::string kind;                    ///< word of a solver::CriticalKind
  std::map<std::string, double> facts; ///< step, load_factor, ..., the unit at the end of the name
};

/// `copies` of the meshed part make up the whole; `has_cavity`: with pressure and volume.
CriticalRecord record_of(const solver::CriticalPoint &point, int copies, bool has_cavity);

/// Those of steps up to `last_step` in a history.h5; none where the file cannot be read.
std::vector<CriticalRecord> read_critical_points(const std::filesystem::path &file, int last_step);

} // namespace ballonet::studies
