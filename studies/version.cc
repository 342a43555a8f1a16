// SPDX-License-Identifier: LGPL-2.1-or-later
#include "studies/version.h"

namespace ballonet::studies
{

std::string commit_text() { return BALLONET_COMMIT; }

std::string version_text() { return std::string("ballonet ") + BALLONET_VERSION + " (" + commit_text() + ")"; }

} // namespace ballonet::studies
