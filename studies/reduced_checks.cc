// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/reduced_checks.h"
#include "studies/content_hash.h"
#include "studies/reduced_parameters.h"
#include <algorithm>
#include <stdexcept>

namespace ballonet::studies
{

void check_reduced(const Study &study, const TomlDocument &document)
{
  if (const auto unknown = unknown_to_reduced(study))
    throw document.error(unknown->key, unknown->given + " with the reduced model", unknown->allowed);
  try {
    solver::reduced::check(reduced_parameters(study));
  } catch (const std::invalid_argument &e) {
    throw document.error("method.model", "the reduced model for this study", "a study within the reduced model's range",
                         e.what());
  }
}

void check_reduced_variable(const std::vector<Study> &extremes, const std::string &variable,
                            const TomlDocument &document, const std::string &place)
{
  for (const Study &extreme : extremes)
    if (const auto unknown = unknown_to_reduced(extreme))
      throw document.error(place, "\"" + variable + "\" with the reduced model",
                           "variables of which the reduced model knows all values",
                           unknown->key + " = " + unknown->given);
  const auto same = [&](const Study &extreme) { return content_hash(extreme) == content_hash(extremes.front()); };
  const bool alone = extremes.front().method.model == ModelKind::reduced;
  if (alone && extremes.size() > 1 && std::all_of(extremes.begin(), extremes.end(), same))
    throw document.error(place, "\"" + variable + "\" with the reduced model",
                         "a variable that makes a difference to the reduced model");
}

} // namespace ballonet::studies
