// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "studies/instability.h"
#include <nlohmann/json_fwd.hpp>

namespace ballonet::studies
{

/// A judgement as it stands in journal.jsonl and summary.json: {"class", "reason", "stage", "criteria": [{"name",
/// "class", "what", "value", "limit", "unit", "at_most", "margin"}], "snap_throughs": [{"before", "after",
/// "recovered"}]}, both sides of a snap-through with pressure_kPa, angle_deg, volume_mm3 and bulge_mm. What is not a
/// number is null.
nlohmann::ordered_json json_of(const Judgement &judgement);

/// The same judgement, bit by bit. Throws nlohmann's exceptions or std::invalid_argument if it is none.
Judgement judgement_of(const nlohmann::ordered_json &json);

} // namespace ballonet::studies
