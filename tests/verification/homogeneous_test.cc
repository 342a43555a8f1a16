// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/comparison.h"
#include "tests/support/reaction.h"
#include "tests/support/run_to_end.h"
#include "tests/verification/affine_block.h"
#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double mu = 0.4; // MPa
const char *const textbook = "Ogden, Non-linear Elastic Deformations (1984), homogeneous states";

/// `ratio`: bulk over shear modulus.
Material neo_hookean(double ratio)
{
  Material m;
  m.name = "rubber", m.c10 = mu / 2, m.d1 = 2 / (ratio * mu);
  return m;
}

Material saint_venant()
{
  Material m;
  m.law = Law::saint_venant, m.youngs_modulus = 2, m.poisson_ratio = 0.3;
  return m;
}

/// The patch test: with the boundary moved by x = F X, displacement and stress inside must be those of F.
void check_patch(const std::string &name, const Material &material, bool mixed)
{
  const Matrix3 F = {1.2, 0.3, -0.1, 0.05, 0.9, 0.2, 0.1, -0.15, 1.1};
  AffineBlock block(material, mixed);
  const auto outcome = block.deform(F);
  INFO(name << ": " << outcome.reason);
  REQUIRE(outcome.converged);
  const char *source = "exact: a homogeneous state is in the space (Irons and Razzaque 1972)";
  compare({"patch test, " + name + ": largest error of displacement", source, 0, block.displacement_error(F), 1e-10,
           "mm", Comparison::Kind::absolute});
  const double exact = von_mises(F, make_material(material)->evaluate(right_cauchy_green(F)).stress);
  double worst = 0;
  for (const double stress : block.stresses())
    worst = std::max(worst, std::abs(stress / exact - 1));
  compare({"patch test, " + name + ": largest relative error of von Mises stress", source, 0, worst, 1e-10, "1",
           Comparison::Kind::absolute});
}

/// A unit cube on three symmetry planes whose sides `moved` go to `stretch`; force on side x1, N.
double pulled(const std::vector<std::string> &moved, double stretch)
{
  const auto mesh = box_mesh(2, 2, 2, [](Point3 x) { return distorted(x, 0.08); });
  Parameters parameters;
  parameters.materials = {neo_hookean(1e5)};
  parameters.bodies = {{"body", "rubber", true}};
  parameters.supports = {{"x0", {"x"}}, {"y0", {"y"}}, {"z0", {"z"}}};
  for (const auto &side : moved) {
    auto &support = parameters.supports.emplace_back();
    support.surface = side;
    support.move[side[0] - 'x'] = stretch - 1;
  }
  parameters.path.control = Control::load;
  parameters.path.load_steps = 4;
  parameters.newton = {.tolerance = 1e-9, .force_floor = 1e-3};
  Simulation simulation(parameters, mesh, MPI_COMM_SELF);
  run_to_end(simulation);
  return reaction(mesh, simulation.equilibrium(), simulation.progress().state, "x1")[0];
}

} // namespace

TEST_CASE("patch test on distorted cells")
{
  check_patch("neo-Hookean", neo_hookean(20), false);
  check_patch("neo-Hookean, mixed", neo_hookean(1000), true);
  check_patch("Saint-Venant", saint_venant(), false);
}

// Incompressible neo-Hookean stresses per reference area: uniaxial mu (l - l^-2), equibiaxial mu (l - l^-5). The bulk
// modulus is 1e5 mu, so the difference from incompressibility is of the order of 1e-5.
TEST_CASE("uniaxial and equibiaxial tension of an incompressible neo-Hookean cube")
{
  const double l = 2;
  compare({"uniaxial tension to stretch 2: force", textbook, mu * (l - std::pow(l, -2)), pulled({"x1"}, l), 5e-5, "N"});
  compare({"uniaxial compression to stretch 0.6: force", textbook, mu * (0.6 - std::pow(0.6, -2)), pulled({"x1"}, 0.6),
           5e-5, "N"});
  compare({"equibiaxial tension to stretch 2: force", textbook, mu * (l - std::pow(l, -5)), pulled({"x1", "y1"}, l),
           5e-5, "N"});
}

// Simple shear x = X + g Z keeps the volume: P_xz = mu g, and with p = kappa (J - 1) = 0 the normal stress on the
// sheared plane is P_zz = -mu g^2 / 3 (Poynting effect).
TEST_CASE("simple shear of a neo-Hookean cube")
{
  const double g = 0.8;
  AffineBlock block(neo_hookean(1000), true);
  const auto outcome = block.deform({1, 0, g, 0, 1, 0, 0, 0, 1});
  INFO(outcome.reason << ", last residual " << outcome.residuals.back());
  REQUIRE(outcome.converged);
  const auto P = block.mean_stress();
  compare({"simple shear 0.8: shear stress", textbook, mu * g, P[2], 1e-8, "MPa"});
  compare({"simple shear 0.8: normal stress on the sheared plane", textbook, -mu * g * g / 3, P[8], 1e-8, "MPa"});
}
