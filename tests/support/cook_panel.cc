// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/cook_panel.h"
#include "tests/support/box_mesh.h"
#include <algorithm>

namespace ballonet::tests
{

using namespace solver;

namespace
{
constexpr double shear_modulus = 80.1938, bulk_modulus = 40.0942e4, load = 100; // MPa, N per mm of thickness
}

Mesh cook_panel(int n)
{
  return box_mesh(n, n, 1, [](Point3 p) {
    const double low = 44 * p[0], high = 44 + 16 * p[0];
    return Point3{48 * p[0], low + (high - low) * p[1], p[2]};
  });
}

Parameters cook_parameters()
{
  Parameters p;
  p.materials.resize(1);
  auto &m = p.materials[0];
  m.name = "rubber", m.c10 = shear_modulus / 2, m.d1 = 2 / bulk_modulus;
  p.bodies = {{"body", "rubber", true}};
  p.supports = {{"x0", {"x", "y"}}, {"z0", {"z"}}, {"z1", {"z"}}};
  p.loads = {{"x1", {0, load / 16, 0}, 0}};
  p.path.control = Control::load;
  p.path.load_steps = 2;
  p.newton = {.tolerance = 1e-8, .force_floor = 1e-3};
  return p;
}

std::uint32_t cook_tip(const Mesh &mesh)
{
  return std::find(mesh.nodes.begin(), mesh.nodes.end(), Point3{48, 60, 0}) - mesh.nodes.begin();
}

} // namespace ballonet::tests
