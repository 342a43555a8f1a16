// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once
#include "solver/parameters.h"
#include "tests/support/box_mesh.h"

namespace ballonet::tests
{

/// Root of a function that falls from a to b.
template <class Function>
double root(const Function &f, double a, double b)
{
  for (int i = 0; i < 100; ++i)
    (f((a + b) / 2) > 0 ? a : b) = (a + b) / 2;
  return (a + b) / 2;
}

/// Two blocks on each other with meshes that do not match, pressed together without friction; no lateral strain.
struct PressedBlocks {
  static constexpr double modulus = 10, height = 1, side = 2, pressed_by = 0.15; // MPa, mm

  double thickness;
  solver::Mesh mesh;
  solver::Parameters parameters;

  explicit PressedBlocks(double thickness = 0.1) : thickness(thickness)
  {
    using solver::Law, solver::Control;
    const auto lower = [thickness](Point3 p) { // the upper layer of cells is two thicknesses thin
      const double z = p[2] <= 0.5 ? 2 * p[2] * (height - 2 * thickness) : height - 4 * thickness * (1 - p[2]);
      return Point3{side * p[0], side * p[1], z};
    };
    const auto upper = [](Point3 p) { return Point3{side * p[0], side * p[1], height * (1 + p[2])}; };
    mesh = beside(box_mesh(2, 2, 2, lower, "lower", "lower."), box_mesh(3, 3, 1, upper, "upper", "upper."));
    parameters.materials.resize(1);
    auto &m = parameters.materials[0];
    m.name = "foam", m.law = Law::saint_venant, m.youngs_modulus = modulus, m.poisson_ratio = 0;
    parameters.bodies = {{"lower", "foam"}, {"upper", "foam"}};
    for (const std::string name : {"lower.", "upper."}) {
      parameters.supports.push_back({name + "x0", {"x"}});
      parameters.supports.push_back({name + "y0", {"y"}});
    }
    parameters.supports.push_back({"lower.z0", {"z"}});
    parameters.supports.push_back({"upper.z1", {}, {{{}, {}, -pressed_by}}});
    parameters.contact_pairs = {{"pair", {"upper.z0"}, {"lower.z1"}, 0, thickness, 30, 0.02}};
    parameters.path.control = Control::load;
    parameters.path.load_steps = 4;
    parameters.newton = {.tolerance = 1e-11, .force_floor = 1e-3};
  }

  /// Stretch of a Saint-Venant bar with nu = 0 under the reference pressure P: E l (l^2 - 1) / 2 = -P.
  static double stretch(double pressure)
  {
    return root([&](double l) { return -pressure - modulus * l * (l * l - 1) / 2; }, 0.6, 1);
  }

  /// Contact pressure of the stack: the contact acts on the surface `thickness` inside the lower block, so what lies
  /// above that surface carries nothing; then the gap and the upper block. `penetration`: of a pressure, mm.
  template <class Penetration>
  double pressure(const Penetration &penetration) const
  {
    return root(
        [&](double P) {
          const double top = (2 * height - thickness) * stretch(P) + thickness - penetration(P);
          return top - (2 * height - pressed_by);
        },
        1e-3, 3);
  }
};

} // namespace ballonet::tests
