// SPDX-License-Identifier: LGPL-2.1-or-later
#include "optimize/evaluation.h"
#include <stdexcept>

namespace ballonet::optimize
{

std::string_view word_of(Status status)
{
  for (const auto &[candidate, word] : status_words)
    if (candidate == status)
      return word;
  throw std::logic_error("a status without a word");
}

Status status_of(std::string_view word)
{
  for (const auto &[status, candidate] : status_words)
    if (candidate == word)
      return status;
  throw std::invalid_argument("unknown status '" + std::string(word) + "'");
}

} // namespace ballonet::optimize
