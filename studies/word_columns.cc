// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/word_columns.h"
#include "studies/stages.h"
#include <algorithm>
#include <stdexcept>

namespace ballonet::studies
{

std::vector<std::string> words_of(const std::string &column)
{
  if (column == state_column)
    return {"moving", "equilibrium"};
  return column == stage_column ? all_stage_words() : std::vector<std::string>{};
}

std::string all_words_of(const std::string &column)
{
  std::string text;
  for (const std::string &word : words_of(column))
    text += (text.empty() ? "" : ",") + word;
  return text;
}

double number_of(const std::string &column, const std::string &word)
{
  const auto words = words_of(column);
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end())
    throw std::invalid_argument("column \"" + column + "\" has no word \"" + word + "\"");
  return static_cast<double>(found - words.begin());
}

} // namespace ballonet::studies
