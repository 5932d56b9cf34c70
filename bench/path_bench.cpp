// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <vector>

#include <benchmark/benchmark.h>

#include "jounce/base/detail/keep_freed_memory.hpp"
#include "jounce/path/plan.hpp"
#include "jounce/path/refine.hpp"

// Whole plans of long programs, by segment; and the evaluation of three axes.
namespace jounce {
namespace {

GroupLimits limits(std::size_t n) {
  return {.axes = std::vector<Limits>(n, {.acceleration = 1000, .jerk = 1e4})};
}

/// A zigzag of 5 mm in three axes, rounded.
Program zigzag(std::int64_t segments, Corner corner, double value) {
  Program p(3);
  p.set({.velocity = 100, .corner = corner, .value = value});
  for (std::int64_t i = 1; i <= segments; ++i) {
    const double x = static_cast<double>(i);
    p.line({5 * x, i % 2 == 0 ? 0.0 : 5.0, 0.1 * static_cast<double>(i % 7)}, static_cast<int>(i));
  }
  return p;
}

/// Chords of 0.2 mm of a wave.
Program dense(std::int64_t segments) {
  Program p(3);
  p.set({.velocity = 100, .corner = Corner::average, .value = 0.02});
  for (std::int64_t i = 1; i <= segments; ++i) {
    const double x = 0.2 * static_cast<double>(i);
    p.line({x, 20 * std::sin(x / 20), 5 * std::cos(x / 31)}, static_cast<int>(i));
  }
  return p;
}

void by_segment(benchmark::State& state, const Program& program) {
  const GroupLimits l = limits(3);
  double bytes = 0;
  double time = 0;
  for (auto _ : state) {
    const Plan made = plan(program, l);
    time = made.duration();
    const Path& path = made.path();
    bytes = static_cast<double>(path.bytes() + made.law().bytes() + made.junctions().size_bytes());
    benchmark::DoNotOptimize(made.duration());
  }
  const auto n = static_cast<double>(state.range(0));
  state.counters["ns_a_segment"] = benchmark::Counter(
      n * 1e-9, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
  state.counters["bytes_a_segment"] = bytes / n;
  state.counters["program_s"] = time;
}

void plan_turns(benchmark::State& state) {
  by_segment(state, zigzag(state.range(0), Corner::deviation, 0.5));
}
BENCHMARK(plan_turns)->RangeMultiplier(10)->Range(1000, 1000000)->Unit(benchmark::kMillisecond);

void plan_stops(benchmark::State& state) {
  by_segment(state, zigzag(state.range(0), Corner::stop, 0));
}
BENCHMARK(plan_stops)->Range(100000, 100000)->Unit(benchmark::kMillisecond);

void plan_average(benchmark::State& state) {
  by_segment(state, dense(state.range(0)));
}
BENCHMARK(plan_average)->RangeMultiplier(10)->Range(1000, 100000)->Unit(benchmark::kMillisecond);

void evaluate_three_axes(benchmark::State& state) {
  const Plan made = plan(zigzag(10000, Corner::deviation, 0.5), limits(3));
  std::vector<Motion> out(3);
  double t = 0;
  for (auto _ : state) {
    t += 0.001;
    if (t > made.duration()) t = 0;
    made.at(t, out);
    benchmark::DoNotOptimize(out.data());
  }
}
BENCHMARK(evaluate_three_axes);

/// The same by a cursor, at the cycle of 1 ms.
void evaluate_by_cursor(benchmark::State& state) {
  const Plan made = plan(zigzag(10000, Corner::deviation, 0.5), limits(3));
  std::vector<Motion> out(3);
  PlanCursor cursor(made);
  double t = 0;
  for (auto _ : state) {
    t += 0.001;
    if (t > made.duration()) t = 0;
    cursor.at(t, out);
    benchmark::DoNotOptimize(out.data());
  }
}
BENCHMARK(evaluate_by_cursor);

/// Arcs of 1 to 6 mm, joined to lines by blends.
void plan_arcs(benchmark::State& state) {
  Program p(3);
  p.set({.velocity = 100, .corner = Corner::deviation, .value = 0.05});
  for (std::int64_t i = 0; i < state.range(0); ++i) {
    const Point from = p.position();
    const double r = 1 + static_cast<double>(i % 6);
    if (i % 2 == 0)
      p.line({from[0] + 5, from[1]}, static_cast<int>(i + 1));
    else
      p.arc(arc_about(from, {from[0], from[1] + r}, {from[0], from[1] + 2 * r}, Plane{0, 1},
                      ArcRotation::counterclockwise),
            static_cast<int>(i + 1));
  }
  by_segment(state, p);
}
BENCHMARK(plan_arcs)->Range(1000, 1000)->Unit(benchmark::kMillisecond);

void refine_average(benchmark::State& state) {
  const Plan made = plan(dense(state.range(0)), limits(3));
  double time = 0;
  for (auto _ : state) benchmark::DoNotOptimize(time = refined(made).duration());
  state.counters["share_of_time"] = time / made.duration();
}
BENCHMARK(refine_average)->Arg(3000)->Unit(benchmark::kMillisecond);

void axes_of_a_plan(benchmark::State& state) {
  const Plan made = plan(zigzag(1000, Corner::deviation, 0.5), limits(3));
  for (auto _ : state) benchmark::DoNotOptimize(to_axes(made));
}
BENCHMARK(axes_of_a_plan)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace jounce

int main(int argc, char** argv) {
  jounce::keep_freed_memory();  // the program does the same
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
}
