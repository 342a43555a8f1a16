// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/elastic_work.h"
#include "solver/linear_system.h"
#include "tests/benchmark/no_assembly.h"
#include "tests/support/box_mesh.h"
#include "tests/support/nodal_fields.h"
#include <benchmark/benchmark.h>

using namespace ballonet::solver;
using namespace ballonet::tests;

namespace
{

Mesh distorted_block(int nx, int ny, int nz)
{
  return box_mesh(nx, ny, nz, [](Point3 x) { return distorted(x, 0.05); });
}

Material rubber()
{
  Material m;
  m.c10 = 0.16, m.d1 = 1e-3;
  return m;
}

Material plastic()
{
  Material m;
  m.law = Law::saint_venant, m.youngs_modulus = 50, m.poisson_ratio = 0.3;
  return m;
}

/// A deformed block of rubber, mixed, with viscosity; or of plastic, displacement form.
struct DeformedBlock {
  Mesh mesh;
  Discretization discretization{mesh, MPI_COMM_SELF};
  ElasticWork work;
  State start, end;
  std::vector<double> increment;

  DeformedBlock(Mesh block, bool mixed)
      : mesh(std::move(block)), work(discretization, 0, make_material(mixed ? rubber() : plastic()), 5e-3, mixed),
        increment(random_field(3 * mesh.nodes.size(), 2e-3, 1))
  {
    start.displacement.assign(increment.size(), 0.);
    end = moved(start, increment, 1);
    work.begin_step(start, {.dt = 1e-2});
  }
};

/// Time per cell of one thing the elastic work does; argument 1: mixed form.
void elastic_work(benchmark::State &state, void (*act)(DeformedBlock &, Assembly &))
{
  DeformedBlock block(distorted_block(4, 4, 4), state.range(0));
  NoAssembly assembly;
  for (auto _ : state)
    act(block, assembly);
  benchmark::DoNotOptimize(assembly.sum);
  state.counters["per_cell"] = benchmark::Counter(
      block.mesh.cells.size(), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

/// Assembly and factorisation of the tangent of a slender rubber body; argument: its length in cells.
void factorisation(benchmark::State &state)
{
  const int length = state.range(0);
  DeformedBlock block(box_mesh(2, 6, length), true);
  LinearSystem system(block.discretization);
  Prescribed held(block.end.displacement.size(), std::nan(""));
  for (const auto node : surface_nodes(block.mesh, "z0"))
    for (int d = 0; d < 3; ++d)
      held[3 * node + d] = 0;
  system.prescribe(held);
  for (auto _ : state)
    if (!system.factorise({&block.work}, block.start))
      state.SkipWithError("the factorisation failed");
  state.SetComplexityN(length);
}

} // namespace

BENCHMARK_CAPTURE(elastic_work, residual, [](DeformedBlock &b, Assembly &a) { b.work.residual(b.end, a); })
    ->Arg(0)
    ->Arg(1);
BENCHMARK_CAPTURE(elastic_work, tangent, [](DeformedBlock &b, Assembly &a) { b.work.tangent(b.end, a); })
    ->Arg(0)
    ->Arg(1);
BENCHMARK_CAPTURE(elastic_work, advance, [](DeformedBlock &b, Assembly &) { b.work.advance(b.end, b.increment, 0.); })
    ->Arg(0)
    ->Arg(1);
BENCHMARK(factorisation)->RangeMultiplier(2)->Range(20, 160)->Unit(benchmark::kMillisecond)->Complexity();
