// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/simulation.h"
#include "tests/support/comparison.h"
#include "tests/support/sealed_tube.h"
#include <catch2/catch.hpp>
#include <sstream>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

/// q of |r_k+1| ~ |r_k|^q from the last three residuals above round-off.
double order(const std::vector<double> &residuals, double round_off)
{
  int last = static_cast<int>(residuals.size()) - 1;
  while (last > 2 && residuals[last] < round_off)
    --last;
  REQUIRE(last >= 2);
  return std::log(residuals[last] / residuals[last - 1]) / std::log(residuals[last - 1] / residuals[last - 2]);
}

/// Residuals of the last step of a path.
std::vector<double> last_step(const Parameters &parameters, const Mesh &mesh)
{
  std::vector<double> residuals;
  Simulation simulation(parameters, mesh, MPI_COMM_SELF);
  const auto result = simulation.run(
      [&](const PathPoint &point) {
        residuals = point.newton.residuals;
        return "";
      },
      [](const std::string &) {});
  INFO(result.reason);
  REQUIRE(result.status != PathStatus::diverged);
  return residuals;
}

void check_order(const std::string &name, const std::vector<double> &residuals)
{
  std::ostringstream text;
  for (const double r : residuals)
    text << ' ' << r;
  INFO(name << ": residuals" << text.str());
  compare({"Newton's method, " + name + ": order of convergence", "theory: 2", 1.7, order(residuals, 1e-13), 0, "1",
           Comparison::Kind::at_least});
}

} // namespace

// Close to the solution each residual is of the order of the square of the one before.
TEST_CASE("Newton's method converges quadratically in a smooth step")
{
  for (const bool mixed : {false, true}) {
    SealedTube tube;
    tube.parameters.bodies[0].mixed = mixed;
    tube.parameters.materials[0].d1 = 2; // compressible: round-off stays far below the residuals
    tube.parameters.contact_pairs.clear();
    auto &path = tube.parameters.path;
    path.volume_max = 1.5, path.step_initial = path.step_max = 0.2; // one large step
    tube.parameters.newton = {.tolerance = 1e-12, .force_floor = 1, .krylov_below = 0, .reuse_below = 0};
    check_order(mixed ? "mixed form" : "displacement form", last_step(tube.parameters, tube.mesh));
  }
}

TEST_CASE("Newton's method converges quadratically in contact")
{
  SealedTube tube;
  tube.parameters.materials[0].d1 = 2;
  tube.parameters.newton = {.tolerance = 1e-12, .force_floor = 1, .krylov_below = 0, .reuse_below = 0};
  check_order("with frictional contact", last_step(tube.parameters, tube.mesh));
}
