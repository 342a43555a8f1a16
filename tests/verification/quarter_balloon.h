// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/mesh.h"

namespace ballonet::tests
{

/// The quarter x, y >= 0 of the balloon of the reference design (outer diameter 7.2, wall 0.5, length 90 mm), with the
/// surfaces balloon_inner, balloon_base and the symmetry planes x0 and y0.
class QuarterBalloon
{
public:
  QuarterBalloon();
  solver::Mesh mesh;

private:
  void add_plane(const std::string &name, int direction);
};

} // namespace ballonet::tests
