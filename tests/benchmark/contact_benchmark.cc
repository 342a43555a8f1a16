// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/penetration_check.h"
#include "tests/benchmark/no_assembly.h"
#include "tests/support/contact_scene.h"
#include <benchmark/benchmark.h>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

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

/// The scene with its contact at the start of a step, and a state a little further on.
struct PressedCage {
  ContactScene scene = cage_scene();
  ContactWork work{scene.mesh, scene.pair, all_owned};
  std::vector<double> increment = random_field(scene.state.displacement.size(), 0.05, 1);
  State slid = moved(scene.state, increment, 0.2);
  NoAssembly assembly;
  PressedCage() { begin_step(); }
  void begin_step() { work.begin_step(scene.state, {.dt = 1e-3}); }
};

/// Times one thing contact does. The number of points in contact stands beside the time.
void contact_work(benchmark::State &state, void (*act)(PressedCage &))
{
  PressedCage cage;
  for (auto _ : state)
    act(cage);
  benchmark::DoNotOptimize(cage.assembly.sum);
  state.counters["points"] = cage.work.summary(cage.scene.state).points;
}

void check_penetration(benchmark::State &state)
{
  PressedCage cage;
  const PenetrationCheck check(cage.scene.mesh, cage.scene.pair, 0.3);
  for (auto _ : state)
    benchmark::DoNotOptimize(check.find(cage.slid).size());
}

} // namespace

BENCHMARK_CAPTURE(contact_work, begin_step, [](PressedCage &c) { c.begin_step(); })->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(contact_work, search, [](PressedCage &c) {
  c.work.begin_iteration(c.slid, 0);
})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(contact_work, residual, [](PressedCage &c) {
  c.work.residual(c.slid, c.assembly);
})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(contact_work, tangent, [](PressedCage &c) {
  c.work.tangent(c.slid, c.assembly);
})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(contact_work, advance, [](PressedCage &c) {
  c.work.advance(c.scene.state, c.increment, 1);
})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(contact_work, largest_step, [](PressedCage &c) {
  c.assembly.sum += c.work.largest_step(c.slid, c.increment);
})->Unit(benchmark::kMillisecond);
BENCHMARK(check_penetration)->Unit(benchmark::kMillisecond);
