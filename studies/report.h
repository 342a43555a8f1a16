// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <filesystem>
#include <ostream>

namespace ballonet::studies
{

/// Makes report.html of a results directory with scripts/report.py. False, with a line on `out`, if that did not work.
/// The script is looked for in the folder named by the environment variable BALLONET_SCRIPTS, else in the source tree.
bool make_report(const std::filesystem::path &directory, std::ostream &out);

} // namespace ballonet::studies
