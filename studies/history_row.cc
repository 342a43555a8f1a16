// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/history_row.h"
#include <limits>

namespace ballonet::studies
{

double value_of(const Row &row, const std::string &column)
{
  for (const auto &[name, value] : row)
    if (name == column)
      return value;
  return std::numeric_limits<double>::quiet_NaN();
}

} // namespace ballonet::studies
