// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/box_mesh.h"
#include "tests/support/comparison.h"
#include "tests/support/run_to_end.h"
#include <catch2/catch.hpp>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double radius = 160, extent = 8, depth = 0.1; // mm
constexpr double modulus = 10, poisson_ratio = 0.3;     // MPa
constexpr double plane_modulus = modulus / (1 - poisson_ratio * poisson_ratio);

/// Half (x >= 0) of the lowest part of a cylinder along y, cells growing away from the contact, on a stiff flat plate.
Mesh cylinder_on_plate()
{
  const auto cylinder = [](Point3 p) {
    const double x = extent * std::pow(p[0], 2), low = radius - std::sqrt(radius * radius - x * x);
    return Point3{x, depth * p[1], low + (extent - low) * std::pow(p[2], 2)};
  };
  const auto plate = [](Point3 p) { return Point3{(extent + 1) * p[0], depth * p[1], p[2] - 1}; };
  return beside(box_mesh(12, 1, 6, cylinder, "cylinder", "cylinder."), box_mesh(1, 1, 1, plate, "plate", "plate."));
}

Parameters pressed_by(double way, double stiffness, const std::string &primary = "plate.z1")
{
  Parameters p;
  p.materials.resize(2);
  for (auto &m : p.materials)
    m.law = Law::saint_venant, m.poisson_ratio = poisson_ratio;
  p.materials[0].name = "soft", p.materials[0].youngs_modulus = modulus;
  p.materials[1].name = "stiff", p.materials[1].youngs_modulus = 1e4 * modulus;
  p.bodies = {{"cylinder", "soft"}, {"plate", "stiff"}};
  p.supports = {{"cylinder.x0", {"x"}}, {"cylinder.y0", {"y"}}, {"cylinder.y1", {"y"}}};
  p.supports.push_back({"cylinder.z1", {}, {{{}, {}, -way}}});
  p.supports.push_back({"plate.z0", {"x", "y", "z"}});
  p.contact_pairs = {{"pair", {"cylinder.z0"}, {primary}, 0, 0.05, stiffness, 1e-5}};
  p.contact_pairs[0].points_per_side = 8;
  p.rigid_bodies.resize(1);
  p.rigid_bodies[0].name = "floor"; // the plane z = 0
  p.path.control = Control::load;
  p.path.load_steps = 2;
  p.newton = {.tolerance = 1e-7, .force_floor = 0.02};
  return p;
}

/// The contact of half the cylinder.
struct Contact {
  double line_force = 0; ///< N/mm, of the whole cylinder
  double half_width = 0; ///< b, mm, from the second moment of Hertz's pressure: int p x^2 dx / int p dx = b^2 / 4
  double pressure = 0;   ///< MPa, mean over |x| < b / 3

  double hertz_half_width() const { return std::sqrt(4 * line_force * radius / (M_PI * plane_modulus)); }
  /// Mean of p0 sqrt(1 - t^2) over 0 < t < s, s the measured b / 3 over Hertz's b.
  double hertz_pressure() const
  {
    const double b = hertz_half_width(), s = half_width / 3 / b;
    return 2 * line_force / (M_PI * b) * (std::asin(s) / s + std::sqrt(1 - s * s)) / 2;
  }
};

Contact measured(const std::vector<ContactPoint> &points)
{
  double force = 0, moment = 0, middle_force = 0, middle_area = 0;
  for (const auto &point : points) {
    force += point.area * point.pressure;
    moment += point.area * point.pressure * std::pow(point.position[0], 2);
  }
  Contact contact = {2 * force / depth, 2 * std::sqrt(moment / force), 0};
  for (const auto &point : points)
    if (point.position[0] < contact.half_width / 3)
      middle_force += point.area * point.pressure, middle_area += point.area;
  contact.pressure = middle_force / middle_area;
  return contact;
}

Contact press(const Mesh &mesh, const Parameters &parameters)
{
  Simulation simulation(parameters, mesh, MPI_COMM_SELF);
  run_to_end(simulation);
  return measured(simulation.equilibrium().contacts().points(simulation.progress().state)[0]);
}

} // namespace

// Hertz (1882), plane strain: b^2 = 4 P R / (pi E*), p = p0 sqrt(1 - x^2 / b^2), p0 = 2 P / (pi b), E* = E / (1 -
// nu^2). The contact yields by p / eps, which is a soft layer on Hertz's half space: a relative error of the order E* /
// (eps b) = 8 % and 0.5 % here. The strain, b / (2 R) = 0.3 %, must be small too: four times of it cost 1 % of the
// pressure. The edge of the contact lies inside a cell, hence the 0.6 % of the half width.
TEST_CASE("Hertz: a cylinder on a flat plate")
{
  const auto mesh = cylinder_on_plate();
  const auto soft = press(mesh, pressed_by(0.01, 125)), stiff = press(mesh, pressed_by(0.01, 2000));
  const char *source = "Hertz (1882), from the measured force";
  compare(
      {"Hertz's cylinder: half width of the contact", source, soft.hertz_half_width(), soft.half_width, 0.04, "mm"});
  compare(
      {"Hertz's cylinder: pressure in the middle third", source, soft.hertz_pressure(), soft.pressure, 0.04, "MPa"});
  compare({"Hertz's cylinder, contact 16 times as stiff: half width", source, stiff.hertz_half_width(),
           stiff.half_width, 0.01, "mm"});
  compare({"Hertz's cylinder, contact 16 times as stiff: pressure in the middle third", source, stiff.hertz_pressure(),
           stiff.pressure, 0.01, "MPa"});
}

TEST_CASE("Hertz: a cylinder on a rigid plane")
{
  const auto contact = press(cylinder_on_plate(), pressed_by(0.01, 2000, "floor"));
  const char *source = "Hertz (1882), from the measured force";
  compare({"Hertz's cylinder on a rigid plane: half width of the contact", source, contact.hertz_half_width(),
           contact.half_width, 0.01, "mm"});
  compare({"Hertz's cylinder on a rigid plane: pressure in the middle third", source, contact.hertz_pressure(),
           contact.pressure, 0.01, "MPa"});
}
