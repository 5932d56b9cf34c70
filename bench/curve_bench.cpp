// SPDX-License-Identifier: Apache-2.0
// The cost of moves, samples and witnesses; cam_bench.cpp measures cams.
// Run: build/release/bench/bench_curve --benchmark_repetitions=9
// Results: docs/performance.md.
#include <cstdint>
#include <vector>

#include <benchmark/benchmark.h>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/optimize/optimize.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/pvt/sample.hpp"
#include "jounce/validate/witness.hpp"

namespace {

using namespace jounce;

/// A cam of n quintic segments that swings up and down over 360.
CamSpec swinging(int n) {
  CamSpec spec;
  for (int i = 1; i <= n; ++i)
    spec.segments.push_back(
        {Law::quintic, {360.0 * i / n, i % 2 == 0 ? 0.0 : 1.0 + 0.01 * (i % 7), {}, {}}, ""});
  return spec;
}

std::vector<double> positions(std::size_t n) {
  std::vector<double> x(n);
  for (std::size_t i = 0; i < n; ++i) x[i] = 360 * static_cast<double>(i) / static_cast<double>(n);
  return x;
}

void sample_a_block(benchmark::State& state) {
  const Cam cam = design(swinging(64)).cam;
  const auto x = positions(4096);
  std::vector<Transfer> out(x.size());
  for (auto _ : state) {
    cam.sample(x, out);
    benchmark::DoNotOptimize(out.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(x.size()));
}
BENCHMARK(sample_a_block);

void extrema_of_a_modified_sine(benchmark::State& state) {
  const Cam cam(normalized(Law::modified_sine));
  for (auto _ : state) benchmark::DoNotOptimize(extrema(cam));
}
BENCHMARK(extrema_of_a_modified_sine)->Unit(benchmark::kMicrosecond);

void solve_s_curve(benchmark::State& state) {
  SCurveSpec spec{.to = 50, .velocity = 10, .acceleration = 20, .deceleration = 30, .jerk = 100};
  for (auto _ : state) {
    spec.to = spec.to == 50 ? 51 : 50;
    benchmark::DoNotOptimize(s_curve(spec));
  }
}
BENCHMARK(solve_s_curve);

void solve_trapezoid(benchmark::State& state) {
  TrapezoidSpec spec{.to = 50, .velocity = 10, .acceleration = 20, .deceleration = 30};
  for (auto _ : state) {
    spec.to = spec.to == 50 ? 51 : 50;
    benchmark::DoNotOptimize(trapezoid(spec));
  }
}
BENCHMARK(solve_trapezoid);

void table_within_a_millionth(benchmark::State& state) {
  const Cam cycloid(normalized(Law::inclined_sine));
  for (auto _ : state)
    benchmark::DoNotOptimize(sample_within(cycloid, Interpolation::cubic_hermite, 1e-6));
}
BENCHMARK(table_within_a_millionth)->Unit(benchmark::kMillisecond);

void witness_of_a_followed_cam(benchmark::State& state) {
  const Followed slave(design(swinging(12)).cam,
                       trapezoid({.to = 360, .velocity = 180, .acceleration = 720}).curve());
  for (auto _ : state) benchmark::DoNotOptimize(witness(slave));
}
BENCHMARK(witness_of_a_followed_cam)->Unit(benchmark::kMillisecond);

}  // namespace
