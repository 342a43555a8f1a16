// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace ballonet::studies
{

/// Numbers with their names, in the order of the columns of history.csv; a word stands there by its number.
using Row = std::vector<std::pair<std::string, double>>;

/// The number of a column; NaN if there is none.
double value_of(const Row &row, const std::string &column);

} // namespace ballonet::studies
