// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>

namespace ballonet::studies
{

/// "0 mm to 10 mm", "at least 0 mm", "any"; bounds beyond 1e300 count as none.
std::string range_text(double min, double max, const std::string &unit);

} // namespace ballonet::studies
