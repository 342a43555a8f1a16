// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <sstream>
#include <string>

namespace ballonet::geometry
{

/// One text from words and numbers.
template <class... Parts>
std::string join(const Parts &...parts)
{
  std::ostringstream text;
  (text << ... << parts);
  return text.str();
}

} // namespace ballonet::geometry
