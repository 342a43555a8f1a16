// SPDX-License-Identifier: LGPL-2.1-or-later
#include "tests/support/comparison.h"
#include "tests/support/rubber_sphere.h"
#include "tests/support/run_to_end.h"
#include "tests/support/thick_wall.h"
#include <cmath>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

constexpr double A = inner_radius, B = outer_radius;

struct Sphere : RubberSphere {
  Sphere() : RubberSphere(A, B, wall_mu)
  {
    parameters.path.control = Control::arc_length;
    parameters.path.inertia = false;
    parameters.path.arc_step_max = 0.05;
  }

  /// (r / A)^3 of the inner wall where it meets the x axis.
  double volume_ratio(const State &state) const
  {
    const auto at = std::find(mesh.nodes.begin(), mesh.nodes.end(), Vector3{A, 0, 0});
    REQUIRE(at != mesh.nodes.end());
    return std::pow(1 + state.displacement[3 * (at - mesh.nodes.begin())] / A, 3);
  }
};

struct Travelled {
  double highest = 0, worst = 0, last = 0, volume_ratio = 1;
  bool turned = false; ///< the load has come down again
};

/// Follows the path to V / V0 = 8 and compares the pressure `of` every state with the closed form.
template <class Pressure>
Travelled travel(const Sphere &sphere, const Pressure &of)
{
  Travelled way;
  Simulation simulation(sphere.parameters, sphere.mesh, MPI_COMM_SELF);
  const auto result = simulation.run(
      [&](const PathPoint &point) {
        const State &state = point.progress.state;
        way.volume_ratio = sphere.volume_ratio(state);
        way.last = of(state);
        way.highest = std::max(way.highest, way.last);
        way.turned = way.turned || way.last < 0.95 * way.highest;
        way.worst = std::max(way.worst, std::abs(way.last / sphere_pressure(way.volume_ratio) - 1));
        return way.volume_ratio > 8 ? "far enough" : "";
      },
      [](const std::string &) {});
  INFO(result.reason);
  REQUIRE(way.volume_ratio > 8);
  CHECK(way.turned);
  return way;
}

void report(const std::string &name, const Travelled &way)
{
  double limit = 0;
  for (double ratio = 1; ratio < 8; ratio += 1e-3)
    limit = std::max(limit, sphere_pressure(ratio));
  const char *source = "incompressible neo-Hookean sphere, exact (Green and Zerna 1954)";
  compare({name + ": limit pressure", source, 1e3 * limit, 1e3 * way.highest, 5e-3, "kPa"});
  compare({name + ": largest relative error of pressure to V / V0 = 8", source, 0, way.worst, 1e-3, "1",
           Comparison::Kind::absolute});
}

} // namespace

// Arc length passes the limit of the load, whichever load it is.
TEST_CASE("arc length: a sphere under the pressure of a cavity")
{
  Sphere sphere;
  sphere.parameters.cavity = Cavity{"inner"};
  sphere.parameters.path.preload_steps = 1;
  sphere.parameters.path.pressure_rate = 5; // MPa/s: 10 kPa in the first step
  report("arc length, cavity", travel(sphere, [](const State &state) { return state.pressure; }));
}

TEST_CASE("arc length: a sphere under a follower load")
{
  Sphere sphere;
  sphere.parameters.loads = {{"inner", {0, 0, 0}, 1.}};
  sphere.parameters.path.load_steps = 100;
  report("arc length, follower load", travel(sphere, [](const State &state) { return state.load_factor; }));
}
