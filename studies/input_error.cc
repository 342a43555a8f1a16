// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/input_error.h"
#include <algorithm>

namespace ballonet::studies
{
namespace
{

std::string message(const Place &place, const std::string &key, const std::string &given, const std::string &allowed,
                    const std::string &hint)
{
  std::string text = place.file;
  if (place.line > 0)
    text.append(":").append(std::to_string(place.line));
  text += ": ";
  if (!key.empty())
    text += key + ": ";
  text += "given " + given + "; allowed: " + allowed;
  return hint.empty() ? text : text + "; " + hint;
}

std::string joined(const std::vector<std::string> &words)
{
  std::string text;
  for (const auto &word : words)
    text += (text.empty() ? "" : ", ") + word;
  return text;
}

} // namespace

InputError::InputError(Place place_, std::string key_, std::string given_, std::string allowed_, std::string hint_)
    : std::runtime_error(message(place_, key_, given_, allowed_, hint_)), place(std::move(place_)),
      key(std::move(key_)), given(std::move(given_)), allowed(std::move(allowed_)), hint(std::move(hint_))
{
}

std::size_t edit_distance(const std::string &a, const std::string &b)
{
  std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i)
    d[i][0] = i;
  for (std::size_t j = 0; j <= b.size(); ++j)
    d[0][j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i)
    for (std::size_t j = 1; j <= b.size(); ++j) {
      d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
    }
  return d[a.size()][b.size()];
}

std::string nearest_hint(const std::string &word, const std::vector<std::string> &known)
{
  if (known.empty())
    return {};
  const auto nearest = std::min_element(known.begin(), known.end(), [&](const auto &a, const auto &b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
  if (edit_distance(word, *nearest) <= std::max<std::size_t>(2, word.size() / 3))
    return "nearest known: " + *nearest;
  return "known: " + joined(known);
}

} // namespace ballonet::studies
