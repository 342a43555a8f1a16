// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <string>

namespace ballonet::studies
{

/// Release of Ballonet, and the commit it was built from where that is known.
std::string version_text();
std::string commit_text();

} // namespace ballonet::studies
