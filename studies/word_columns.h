// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>
#include <vector>

namespace ballonet::studies
{

/// The column of history.csv that says whether a row is an equilibrium or a state of a motion.
inline constexpr const char *state_column = "state";

/// The words of a column of history.csv that holds words, in the order of the numbers that stand for them in a Row; of
/// other columns none.
std::vector<std::string> words_of(const std::string &column);

/// "moving,equilibrium,...": the same in one text.
std::string all_words_of(const std::string &column);

/// Throws std::invalid_argument if the column has no such word.
double number_of(const std::string &column, const std::string &word);

} // namespace ballonet::studies
