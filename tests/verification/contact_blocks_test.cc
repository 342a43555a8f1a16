// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/box_mesh.h"
#include "tests/support/comparison.h"
#include "tests/support/run_to_end.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double modulus = 10, height = 1, side = 2, thickness = 0.1, pressed_by = 0.15; // MPa, mm

/// Two blocks on each other with meshes that do not match, pressed together without friction; no lateral strain.
struct PressedBlocks {
  Mesh mesh;
  Parameters parameters;
  PressedBlocks()
  {
    const auto lower = [](Point3 p) { // the upper layer of cells is two thicknesses thin
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
};

/// Root of a function that falls from a to b.
template <class Function>
double root(const Function &f, double a, double b)
{
  for (int i = 0; i < 100; ++i)
    (f((a + b) / 2) > 0 ? a : b) = (a + b) / 2;
  return (a + b) / 2;
}

/// Stretch of a Saint-Venant bar with nu = 0 under the reference pressure P: E l (l^2 - 1) / 2 = -P.
double stretch(double pressure)
{
  return root([&](double l) { return -pressure - modulus * l * (l * l - 1) / 2; }, 0.6, 1);
}

/// Penetration under a pressure above the onset: P = eps (g - g0 / 2).
double penetration(double pressure, const ContactPair &pair) { return pressure / pair.stiffness + pair.onset / 2; }

/// Contact pressure of the stack: the contact acts on the surface `thickness` inside the lower block, so what lies
/// above that surface carries nothing; then the gap and the upper block.
double exact_pressure(const ContactPair &pair)
{
  return root(
      [&](double P) {
        const double top = (2 * height - thickness) * stretch(P) + thickness - penetration(P, pair);
        return top - (2 * height - pressed_by);
      },
      pair.stiffness * pair.onset / 2, 3);
}

} // namespace

// Contact patch test (Taylor and Papadopoulos 1991): a uniform pressure must pass a contact between meshes that do not
// match. Quadrature points on one side only do not pass it exactly; a few per cent are expected of the pressure. The
// mean is 0.4 % too high by theory: the kink of the displacement at the contact's depth is not in the space of one
// cell.
TEST_CASE("contact patch test: two pressed blocks")
{
  const PressedBlocks blocks;
  const auto &pair = blocks.parameters.contact_pairs[0];
  Simulation simulation(blocks.parameters, blocks.mesh, MPI_COMM_SELF);
  run_to_end(simulation);
  const auto &state = simulation.progress().state;
  const auto &equilibrium = simulation.equilibrium();

  const double exact = exact_pressure(pair);
  double low = infinity, high = 0, off_law = 0;
  const auto points = equilibrium.contacts().points(state);
  for (const auto &point : points[0]) {
    low = std::min(low, point.pressure), high = std::max(high, point.pressure);
    off_law = std::max(off_law, std::abs(point.penetration - penetration(point.pressure, pair)));
  }
  const auto summary = equilibrium.contacts().summaries(state)[0];
  const char *source = "closed form: two bars and the contact law in series";
  compare(
      {"contact patch test: mean pressure", source, exact, -summary.primary_force[0][2] / (side * side), 1e-2, "MPa"});
  compare({"contact patch test: largest pressure", source, exact, high, 0.05, "MPa"});
  compare({"contact patch test: smallest pressure", source, exact, low, 0.05, "MPa"});
  compare({"contact patch test: distance of penetrations from the law", "contact law", 0, off_law, 1e-12, "mm",
           Comparison::Kind::absolute});
  compare({"contact patch test: area in contact", "geometry", side * side, summary.area, 1e-10, "mm^2"});

  double position = 0, nodes = 0;
  for (const auto node : surface_nodes(blocks.mesh, "upper.z0")) {
    position += blocks.mesh.nodes[node][2] + state.displacement[3 * node + 2];
    ++nodes;
  }
  const double face = (height - thickness) * stretch(exact) + thickness - penetration(exact, pair);
  compare({"contact patch test: mean position of the secondary surface", source, face, position / nodes, 2e-3, "mm",
           Comparison::Kind::absolute});

  const auto forces = equilibrium.reactions(state);
  double below = 0, above = 0;
  for (const auto node : surface_nodes(blocks.mesh, "lower.z0"))
    below += forces[3 * node + 2];
  for (const auto node : surface_nodes(blocks.mesh, "upper.z1"))
    above += forces[3 * node + 2];
  compare({"contact patch test: sum of the reactions", "equilibrium", 0, below + above, 1e-10, "N",
           Comparison::Kind::absolute});
  compare({"contact patch test: force on both surfaces", "action and reaction", 0,
           summary.primary_force[0][2] + summary.secondary_force[2], 1e-10, "N", Comparison::Kind::absolute});
}
