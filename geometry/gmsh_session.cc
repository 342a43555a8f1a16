// SPDX-License-Identifier: LGPL-2.1-or-later
#include "geometry/gmsh_session.h"
#include <exception>
#include <gmsh.h>

namespace ballonet::geometry
{

GmshSession::GmshSession()
{
  constexpr bool read_user_settings = false;
  gmsh::initialize(0, nullptr, read_user_settings);
  gmsh::option::setNumber("General.Terminal", 0);
  gmsh::option::setNumber("General.NumThreads", 1);
  gmsh::model::add("ballonet");
}

GmshSession::~GmshSession()
{
  try {
    gmsh::finalize();
  } catch (...) { // a destructor lets nothing out, and a failed end has no remedy
  }
}

std::optional<std::string> in_gmsh(const std::function<void()> &work)
{
  try {
    const GmshSession session;
    work();
    return std::nullopt;
  } catch (const std::exception &error) {
    return error.what();
  } catch (const std::string &message) { // what gmsh's own calls throw
    return message;
  } catch (...) {
    return "gmsh failed without a message";
  }
}

} // namespace ballonet::geometry
