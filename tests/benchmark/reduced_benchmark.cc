// SPDX-License-Identifier: LGPL-2.1-or-later
#include "solver/reduced/pebs_path.h"
#include "solver/reduced/ramp_path.h"
#include <benchmark/benchmark.h>

using namespace ballonet::solver::reduced;

namespace
{

void reduced_static_path(benchmark::State &state)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(static_path(PebsModel{Parameters{}}).rows.size());
}

void reduced_ramp_path(benchmark::State &state)
{
  for (auto _ : state)
    benchmark::DoNotOptimize(ramp_path(PebsModel{Parameters{}}).rows.size());
}

} // namespace

BENCHMARK(reduced_static_path)->Unit(benchmark::kMillisecond);
BENCHMARK(reduced_ramp_path)->Unit(benchmark::kMillisecond);
