// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/critical_record.h"
#include "solver/hdf5_file.h"
#include <stdexcept>

namespace ballonet::studies
{

CriticalRecord record_of(const solver::CriticalPoint &point, int copies, bool has_cavity)
{
  CriticalRecord record = {solver::word_of(point.kind),
                           {{"step", point.step},
                            {"load_factor", point.load_factor},
                            {"step_share", point.bracket},
                            {"load_participation", point.load_participation},
                            {"negative_eigenvalues_before", point.before.negative_pivots},
                            {"negative_eigenvalues_after", point.after.negative_pivots}}};
  if (has_cavity)
    record.facts.insert({{"pressure_kPa", 1e3 * point.pressure},
                         {"volume_mm3", copies * point.volume},
                         {"negative_eigenvalues_held_volume_before", point.before.at_held_volume()},
                         {"negative_eigenvalues_held_volume_after", point.after.at_held_volume()}});
  return record;
}

std::vector<CriticalRecord> read_critical_points(const std::filesystem::path &file, int last_step)
{
  std::vector<CriticalRecord> records;
  if (!std::filesystem::exists(file))
    return records;
  try {
    const solver::Hdf5File in(file, solver::Hdf5File::Mode::read);
    for (const std::string &name : in.names("/critical_points")) {
      const std::string object = "/critical_points/" + name;
      if (in.read_attribute(object, "step") <= last_step)
        records.push_back({in.read_text_attribute(object, "kind"), in.number_attributes(object)});
    }
  } catch (const std::runtime_error &) {
    records.clear(); // damaged by a kill: it begins anew
  }
  return records;
}

} // namespace ballonet::studies
