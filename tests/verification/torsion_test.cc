// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/simulation.h"
#include "tests/support/comparison.h"
#include "tests/support/round_mesh.h"
#include "tests/support/run_to_end.h"
#include <catch2/catch.hpp>
#include <cmath>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double A = 1, B = 1.6, length = 3, mu = 0.3; // mm, MPa

Material rubber()
{
  Material m;
  m.name = "rubber", m.c10 = mu / 2, m.d1 = 2e-6 / mu;
  return m;
}

/// An incompressible tube whose end is turned by `twist` rad/mm in equal steps at constant length, under the inner
/// pressure that keeps its radii.
class TwistedTube
{
public:
  TwistedTube(int n, double pressure)
      : mesh_(whole_tube(A, B, length, n, 8 * n, 2 * n)), discretization_(mesh_, MPI_COMM_SELF),
        wall_(discretization_, 0, make_material(rubber()), 0, true), load_(discretization_, {"inner", {}, pressure}),
        system_(discretization_),
        newton_(system_, {&wall_, &load_}, {}, nullptr, MPI_COMM_SELF, {.tolerance = 1e-8, .force_floor = 1e-3})
  {
    state_.displacement.assign(3 * mesh_.nodes.size(), 0.);
    state_.load_factor = 1;
  }

  void turn(double twist, int steps)
  {
    for (int k = 1; k <= steps; ++k) {
      const double share = double(k) / steps;
      for (VirtualWork *work : std::initializer_list<VirtualWork *>{&wall_, &load_})
        work->begin_step(state_, {.dt = 1, .load_factor = share * share});
      system_.prescribe(ends_turned(share * twist * length));
      const auto outcome = newton_.solve(state_, {});
      INFO(outcome.reason);
      REQUIRE(outcome.converged);
    }
  }

  struct End {
    double torque = 0, axial_force = 0; ///< N mm, N; on the turned end
  };
  End end() const
  {
    const auto force = newton_.forces(state_);
    End end;
    for (const auto node : surface_nodes(mesh_, "z1")) {
      const std::size_t i = 3 * node;
      const double x = mesh_.nodes[node][0] + state_.displacement[i];
      const double y = mesh_.nodes[node][1] + state_.displacement[i + 1];
      end.torque += x * force[i + 1] - y * force[i];
      end.axial_force += force[i + 2];
    }
    return end;
  }

private:
  Mesh mesh_;
  Discretization discretization_;
  ElasticWork wall_;
  FollowerLoad load_;
  LinearSystem system_;
  mutable NewtonSolver newton_;
  State state_;

  Prescribed ends_turned(double angle) const
  {
    Prescribed values(state_.displacement.size(), std::nan(""));
    for (const auto node : surface_nodes(mesh_, "z0"))
      std::fill_n(&values[3 * node], 3, 0.);
    for (const auto node : surface_nodes(mesh_, "z1")) {
      const auto &X = mesh_.nodes[node];
      values[3 * node] = X[0] * (std::cos(angle) - 1) - X[1] * std::sin(angle);
      values[3 * node + 1] = X[0] * std::sin(angle) + X[1] * (std::cos(angle) - 1);
      values[3 * node + 2] = 0;
    }
    return values;
  }
};

/// Mean rotation about z of the free end of a closed tube under inner pressure, rad.
double rotation_under_pressure(double pitch)
{
  const auto mesh = whole_tube(A, B, length, 1, 8, 2, pitch);
  Parameters p;
  p.materials = {rubber()};
  p.materials[0].d1 = 0.02; // lets Newton's method come to rounding
  p.bodies = {{"body", "rubber", true}};
  p.supports = {{"z0", {"x", "y", "z"}}};
  const double pressure = 0.06;
  p.loads = {{"inner", {0, 0, 0}, pressure}, {"z1", {0, 0, pressure * A * A / (B * B - A * A)}, 0}};
  p.path.control = Control::load;
  p.path.load_steps = 2;
  p.newton = {.tolerance = 1e-10, .force_floor = 1e-2};
  Simulation simulation(p, mesh, MPI_COMM_SELF);
  run_to_end(simulation);
  const auto &u = simulation.progress().state.displacement;
  double moment = 0, inertia = 0, widening = 0;
  for (const auto node : surface_nodes(mesh, "z1")) {
    const double X = mesh.nodes[node][0], Y = mesh.nodes[node][1];
    moment += X * u[3 * node + 1] - Y * u[3 * node];
    widening += X * u[3 * node] + Y * u[3 * node + 1];
    inertia += X * X + Y * Y;
  }
  CHECK(widening / inertia > 0.05); // it is well inflated
  return moment / inertia;
}

} // namespace

// Rivlin's torsion of an incompressible neo-Hookean tube: every section turns as a whole, the stress is
//   sigma_rr = sigma_zz = -mu psi^2 (B^2 - r^2) / 2,  sigma_thetaz = mu psi r.
TEST_CASE("torsion of a neo-Hookean tube")
{
  const double twist = 0.3, square = B * B - A * A;
  const double pressure = mu * twist * twist * square / 2;
  const double torque = M_PI / 2 * mu * twist * (std::pow(B, 4) - std::pow(A, 4));
  const double axial = -M_PI / 4 * mu * twist * twist * square * square;
  const char *source = "Rivlin (1949), exact for an incompressible tube";
  double errors[2];
  for (const int n : {1, 2}) {
    TwistedTube tube(n, pressure);
    tube.turn(twist, 3);
    const auto end = tube.end();
    errors[n - 1] = std::abs(end.torque / torque - 1);
    if (n == 2) {
      compare({"tube twisted by 0.9 rad: torque, 2 cells through the wall", source, torque, end.torque, 1e-3, "N mm"});
      compare({"tube twisted by 0.9 rad: axial force (Poynting)", source, axial, end.axial_force, 1e-2, "N"});
    }
  }
  compare({"tube twisted by 0.9 rad: observed order of the torque's error", "theory: 4 for quadratic displacements", 2,
           std::log2(errors[0] / errors[1]), 0, "1", Comparison::Kind::at_least});
}

TEST_CASE("a tube without fibres does not twist under pressure")
{
  const char *source = "symmetry";
  const auto kind = Comparison::Kind::absolute;
  compare({"tube under pressure: rotation of its end", source, 0, rotation_under_pressure(0), 1e-10, "rad", kind});
  compare(
      {"the same on a mesh whose lines wind by 0.9 rad", source, 0, rotation_under_pressure(0.3), 2e-3, "rad", kind});
}
