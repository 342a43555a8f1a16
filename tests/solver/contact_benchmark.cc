// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/penetration_check.h"
#include "tests/support/contact_scene.h"
#include <catch2/catch.hpp>
#include <ctime>
#include <iostream>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

/// Takes what contact assembles and does nothing with it.
class NoAssembly : public Assembly
{
public:
  void add_residual(std::span<const Node>, std::span<const double> values) override { sum += values[0]; }
  void add_tangent(std::span<const Node>, std::span<const double> values) override { sum += values[0], ++blocks; }
  double sum = 0;
  int blocks = 0;
};

/// A cylindrical shell of 24 x 30 faces (18000 points) pressed into 20 bars along the circumference (1440 patches).
ContactScene cage_scene()
{
  ContactScene scene;
  const double pi = std::acos(-1.);
  auto ring = [&](double radius, double angle, double z) {
    return std::array<double, 3>{radius * std::cos(pi * angle), radius * std::sin(pi * angle), z};
  };
  for (int bar = 0; bar < 20; ++bar) {
    const std::string name = "bar" + std::to_string(bar);
    add_block(scene.mesh, name, {1, 24, 1},
              [&](auto p) { return ring(7.4 + 2 * p[0], p[1], 2.25 * bar + 0.8 + 0.9 * p[2]); });
    for (const char *side : {".x0", ".z0", ".z1"})
      scene.pair.primary.push_back(name + side);
  }
  add_block(scene.mesh, "shell", {1, 24, 30}, [&](auto p) { return ring(7 + 0.5 * p[0], p[1], 45 * p[2]); });
  scene.pair.secondary = {"shell.x1"};
  scene.state.displacement.assign(3 * scene.mesh.nodes.size(), 0.);
  return scene;
}

template <class Action>
void measure(const char *what, const Action &action)
{
  constexpr int repetitions = 10;
  double best = 1e300;
  for (int k = 0; k < repetitions; ++k) {
    const std::clock_t start = std::clock();
    action();
    best = std::min(best, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::cout << what << ": " << 1e3 * best << " ms of processor time\n";
}

} // namespace

TEST_CASE("cost of contact", "[.benchmark]")
{
  const ContactScene scene = cage_scene();
  ContactWork work(scene.mesh, scene.pair, all_owned);
  work.begin_step(scene.state, {.dt = 1e-3});
  const ContactSummary summary = work.summary(scene.state);
  std::cout << summary.points << " points touch, deepest " << summary.penetration << " mm\n";
  const auto increment = random_field(scene.state.displacement.size(), 0.05, 1);
  const State slid = moved(scene.state, increment, 0.2);
  NoAssembly assembly;
  measure("begin_step", [&] { work.begin_step(scene.state, {.dt = 1e-3}); });
  measure("begin_iteration with search", [&] { work.begin_iteration(slid, 0); });
  measure("energy", [&] { assembly.sum += work.energy(slid); });
  measure("residual", [&] { work.residual(slid, assembly); });
  measure("tangent", [&] { work.tangent(slid, assembly); });
  measure("advance", [&] { work.advance(scene.state, increment, 1); });
  measure("largest_step", [&] { assembly.sum += work.largest_step(slid, increment); });
  std::vector<std::vector<Node>> couplings;
  measure("add_couplings", [&] { couplings.clear(), work.add_couplings(couplings); });
  const PenetrationCheck check(scene.mesh, scene.pair, 0.3);
  measure("penetration check", [&] { assembly.sum += static_cast<double>(check.find(slid).size()); });
  std::cout << couplings.size() << " couplings, " << assembly.blocks / 10 << " blocks a tangent\n";
  CHECK(summary.points > 3000);
  CHECK(std::isfinite(assembly.sum));
}
