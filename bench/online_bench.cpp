// SPDX-License-Identifier: Apache-2.0
// What a cycle of an OnlineGenerator costs: while nothing changes, while every target is set again, and
// where all axes are planned again.
//   build/release/bench/bench_online --benchmark_repetitions=9 --benchmark_report_aggregates_only
#include <cstddef>

#include <benchmark/benchmark.h>

#include "jounce/profiles/online/online.hpp"

namespace {

using namespace jounce;

constexpr double cycle = 1e-9;  // so short that the motion never ends

template <std::size_t N>
OnlineGenerator<N> under_way() {
  OnlineGenerator<N> g(Sync::time);
  for (std::size_t i = 0; i < N; ++i) {
    g.set_bounds(i, within(2, 10, 100));
    g.set_target(i, {.position = 10.0 + static_cast<double>(i), .velocity = 0.5});
  }
  (void)g.step(0.1);
  return g;
}

template <std::size_t N>
void step(benchmark::State& state) {
  auto g = under_way<N>();
  for (auto _ : state) benchmark::DoNotOptimize(g.step(cycle));
}

/// A target with the noise of rounding: compared, and found to fit.
template <std::size_t N>
void step_set(benchmark::State& state) {
  auto g = under_way<N>();
  double noise = 0x1p-51;
  for (auto _ : state) {
    noise = -noise;
    for (std::size_t i = 0; i < N; ++i)
      g.set_target(i, {(10.0 + static_cast<double>(i)) * (1 + noise), 0.5});
    benchmark::DoNotOptimize(g.step(cycle));
  }
}

/// Every target jumps in every cycle.
template <std::size_t N>
void step_planned(benchmark::State& state) {
  auto g = under_way<N>();
  double jump = 1;
  for (auto _ : state) {
    jump = -jump;
    for (std::size_t i = 0; i < N; ++i)
      g.set_target(i, {10.0 + jump + static_cast<double>(i), 0.5});
    benchmark::DoNotOptimize(g.step(cycle));
  }
}

/// An acceleration limit goes down and up again in every second cycle.
template <std::size_t N>
void step_lowered(benchmark::State& state) {
  auto g = under_way<N>();
  bool low = false;
  for (auto _ : state) {
    low = !low;
    for (std::size_t i = 0; i < N; ++i) g.set_bounds(i, within(2, low ? 5 : 10, 100));
    benchmark::DoNotOptimize(g.step(cycle));
  }
}

BENCHMARK(step<1>);
BENCHMARK(step<3>);
BENCHMARK(step<7>);
BENCHMARK(step_set<1>);
BENCHMARK(step_set<3>);
BENCHMARK(step_set<7>);
BENCHMARK(step_planned<1>);
BENCHMARK(step_planned<3>);
BENCHMARK(step_planned<7>);
BENCHMARK(step_lowered<1>);
BENCHMARK(step_lowered<3>);
BENCHMARK(step_lowered<7>);

}  // namespace
