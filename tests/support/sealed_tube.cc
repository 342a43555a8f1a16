// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/sealed_tube.h"
#include "tests/support/box_mesh.h"

namespace ballonet::tests
{

SealedTube::SealedTube()
    : mesh(beside(quarter_tube(3, 4, 6, 1, 3, 3, "tube"), quarter_tube(4.3, 6, 2.5, 1, 2, 1, "ring", "ring.")))
{
  parameters.materials.resize(2);
  auto &rubber = parameters.materials[0], &plastic = parameters.materials[1];
  rubber.name = "rubber", rubber.c10 = 0.16, rubber.d1 = 0.005, rubber.density = 1e-9, rubber.relaxation_time = 5e-3;
  plastic.name = "plastic", plastic.law = solver::Law::saint_venant;
  plastic.youngs_modulus = 50, plastic.poisson_ratio = 0.3, plastic.density = 1e-9;
  parameters.bodies = {{"tube", "rubber", true}, {"ring", "plastic", false}};
  for (const std::string prefix : {"", "ring."}) {
    parameters.supports.push_back({prefix + "x0", {"x"}});
    parameters.supports.push_back({prefix + "y0", {"y"}});
    parameters.supports.push_back({prefix + "z0", {"z"}});
  }
  parameters.supports.push_back({"z1", {"z"}});
  parameters.cavity = solver::Cavity{"inner", {0, 0, 0}, {"x", "y"}};
  parameters.contact_pairs = {{"pair", {"outer"}, {"ring.inner", "ring.z1"}}};
  auto &path = parameters.path;
  path.volume_max = 1.5, path.volume_rate = 6, path.step_initial = 5e-3, path.step_max = 2e-2;
  parameters.newton.tolerance = 1e-11;
  parameters.newton.force_floor = 1e-3;
}

} // namespace ballonet::tests
