// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include <functional>
#include <optional>
#include <string>

namespace ballonet::geometry
{

/// gmsh keeps its state in global variables. A session starts it silently, gives it an empty model and ends it, so
/// nothing is left behind. Sessions must not overlap, neither nested nor in threads.
class GmshSession
{
public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession &) = delete;
  GmshSession &operator=(const GmshSession &) = delete;
};

/// Runs `work` within a session of its own. What gmsh throws ends here: the reason, nothing if all went well.
std::optional<std::string> in_gmsh(const std::function<void()> &work);

} // namespace ballonet::geometry
