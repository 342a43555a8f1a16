// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/field_range.h"
#include <sstream>

namespace ballonet::studies
{

std::string range_text(double min, double max, const std::string &unit)
{
  constexpr double none = 1e300;
  std::ostringstream text;
  const std::string suffix = unit == "1" ? "" : " " + unit;
  if (min > -none && max < none)
    text << min << suffix << " to " << max << suffix;
  else if (min > -none)
    text << "at least " << min << suffix;
  else if (max < none)
    text << "at most " << max << suffix;
  else
    text << "any";
  return text.str();
}

} // namespace ballonet::studies
