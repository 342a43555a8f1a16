// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/benchmark/benchmark_case.h"
#include "tests/support/box_mesh.h"
#include "tests/support/cook_panel.h"
#include "tests/support/elastica.h"
#include "tests/support/round_mesh.h"
#include "tests/support/thick_wall.h"
#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ballonet::tests
{

using namespace solver;

namespace
{

constexpr double blown_to = 3; // V / V0

Parameters under_load(int steps)
{
  Parameters p;
  p.path.control = Control::load;
  p.path.load_steps = steps;
  p.newton.force_floor = 1e-3;
  return p;
}

Parameters blown(const std::vector<Support> &supports, double pressure)
{
  auto p = under_load(5);
  p.materials.resize(1);
  auto &rubber = p.materials[0];
  rubber.name = "rubber", rubber.c10 = wall_mu / 2, rubber.d1 = 2e-6 / wall_mu;
  p.bodies = {{"body", "rubber", true}};
  p.supports = supports;
  p.loads = {{"inner", {0, 0, 0}, pressure}};
  return p;
}

/// Root mean square over the shared nodes of the distance to where `radius` says the node goes; the radius counts the
/// first `dimensions` coordinates. Relative to the same mean of the exact displacement.
double radial_error(const Mesh &mesh, int dimensions, double (*radius)(double, double), const std::vector<double> &u)
{
  double wrong = 0, size = 0;
  for (const auto node : shared_nodes(mesh)) {
    const auto &X = mesh.nodes[node];
    const double R = dimensions == 2 ? std::hypot(X[0], X[1]) : std::hypot(X[0], X[1], X[2]);
    const double growth = radius(R, blown_to) / R - 1;
    for (int d = 0; d < dimensions; ++d) {
      wrong += std::pow(u[3 * node + d] - growth * X[d], 2);
      size += std::pow(growth * X[d], 2);
    }
  }
  return std::sqrt(wrong / size);
}

BenchmarkCase tube(int n)
{
  BenchmarkCase c{quarter_tube(inner_radius, outer_radius, 0.5, n, 2 * n, 1),
                  blown({{"x0", {"x"}}, {"y0", {"y"}}, {"z0", {"z"}}, {"z1", {"z"}}}, tube_pressure(blown_to)),
                  {}};
  c.error = [mesh = c.mesh](const auto &u) { return radial_error(mesh, 2, tube_radius, u); };
  return c;
}

BenchmarkCase sphere(int n)
{
  BenchmarkCase c{eighth_sphere(inner_radius, outer_radius, n, n),
                  blown({{"x0", {"x"}}, {"y0", {"y"}}, {"z0", {"z"}}}, sphere_pressure(blown_to)),
                  {}};
  c.error = [mesh = c.mesh](const auto &u) { return radial_error(mesh, 3, sphere_radius, u); };
  return c;
}

BenchmarkCase cook(int n)
{
  auto p = cook_parameters();
  p.newton.tolerance = Newton{}.tolerance;
  const auto mesh = cook_panel(n);
  return {mesh, p, [tip = cook_tip(mesh)](const auto &u) { return u[3 * tip + 1] / cook_deflection - 1; }};
}

/// Length 40 times the height, no lateral contraction; see tests/verification/elastica_test.cc.
BenchmarkCase cantilever(int n)
{
  constexpr double length = 40, modulus = 1000, alpha = 4;
  BenchmarkCase c{box_mesh(n, 1, 1,
                           [](Point3 x) {
                             return Point3{length * x[0], x[1] - 0.5, x[2] - 0.5};
                           }),
                  under_load(2),
                  {}};
  auto &p = c.parameters;
  p.materials.resize(1);
  auto &m = p.materials[0];
  m.name = "steel", m.law = Law::saint_venant, m.youngs_modulus = modulus, m.poisson_ratio = 0;
  p.bodies = {{"body", "steel"}};
  p.supports = {{"x0", {"x", "y", "z"}}};
  p.loads = {{"x1", {0, alpha * modulus / 12 / (length * length), 0}, 0}};
  const auto &nodes = c.mesh.nodes;
  const std::size_t tip = std::find(nodes.begin(), nodes.end(), Point3{length, 0.5, 0.5}) - nodes.begin();
  const std::size_t low = std::find(nodes.begin(), nodes.end(), Point3{length, -0.5, -0.5}) - nodes.begin();
  c.error = [tip, low](const auto &u) {
    const auto mean = [&](int d) { return (u[3 * tip + d] + u[3 * low + d]) / 2; };
    const Tip exact = elastica(alpha);
    return std::hypot(mean(0) / length + 1 - exact.x, mean(1) / length - exact.y) / std::hypot(1 - exact.x, exact.y);
  };
  return c;
}

} // namespace

BenchmarkCase benchmark_case(const std::string &name, int cells)
{
  const std::pair<const char *, BenchmarkCase (*)(int)> known[] = {
      {"tube", tube}, {"sphere", sphere}, {"cook", cook}, {"cantilever", cantilever}};
  for (const auto &[key, make] : known)
    if (name == key)
      return make(cells);
  throw std::invalid_argument("there is no case \"" + name + "\"; known: tube, sphere, cook, cantilever");
}

std::vector<std::uint32_t> shared_nodes(const Mesh &mesh)
{
  std::vector<bool> shared(mesh.nodes.size());
  for (const auto &cell : mesh.cells)
    for (int a = 0; a < 27; ++a)
      if ((a % 3 == 1) + (a / 3 % 3 == 1) + (a / 9 == 1) <= 1)
        shared[cell[a]] = true;
  std::vector<std::uint32_t> nodes;
  for (std::uint32_t node = 0; node < shared.size(); ++node)
    if (shared[node])
      nodes.push_back(node);
  return nodes;
}

} // namespace ballonet::tests
