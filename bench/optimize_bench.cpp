// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include "jounce/optimize/shape.hpp"

#include "optimize/clp_shape.hpp"
#include "optimize/shape_problems.hpp"

// Shapes of a cam: peaks held everywhere (exact extrema) beside Clp's simplex on a grid of four places a
// piece, in the same run; and how the time grows with the coefficients.

namespace jounce {
namespace {

using test_optimize::rest_to_rest_shape;
using test_optimize::within;

ShapeProblem peak_problem(std::size_t coefficients, int order) {
  ShapeProblem p = rest_to_rest_shape(3);
  p.pieces = coefficients - 5;
  p.minimize = {{PeakOf{derivative_of_shape(order)}}};
  return p;
}

void solve(benchmark::State& state, const ShapeProblem& p) {
  ShapeOutcome best;
  for (auto _ : state) benchmark::DoNotOptimize(best = optimize_shape(p));
  if (!best.usable()) state.SkipWithError(best.reason.c_str());
  state.counters["reached"] = best.figures[0].reached;
  state.counters["rounds"] = best.rounds;
}

void LeastPeakJerk(benchmark::State& state) {
  solve(state, peak_problem(static_cast<std::size_t>(state.range(0)), 3));
}
BENCHMARK(LeastPeakJerk)
    ->Arg(50)
    ->Arg(100)
    ->Arg(200)
    ->Arg(500)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);

void LeastPeakAcceleration(benchmark::State& state) {
  solve(state, peak_problem(static_cast<std::size_t>(state.range(0)), 2));
}
BENCHMARK(LeastPeakAcceleration)->Arg(50)->Arg(200)->Arg(500)->Unit(benchmark::kMillisecond);

void ClpOnAGrid(benchmark::State& state) {
  double least = 0;
  const auto order = static_cast<int>(state.range(0));
  for (auto _ : state) least = test_optimize::clp_least_peak(195, order, 4);
  state.counters["reached"] = least;
}
BENCHMARK(ClpOnAGrid)->Arg(3)->Arg(2)->Unit(benchmark::kMillisecond);

void LeastRmsAcceleration(benchmark::State& state) {
  ShapeProblem p = peak_problem(200, 2);
  p.minimize = {{RmsOf{derivative_of_shape(2)}}};
  solve(state, p);
}
BENCHMARK(LeastRmsAcceleration)->Unit(benchmark::kMillisecond);

/// Peak acceleration under a jerk limit, knots added where the optimum switches.
void Front(benchmark::State& state) {
  ShapeProblem p = rest_to_rest_shape(3);
  p.degree = 3;
  p.pieces = 80;
  p.refine = true;
  p.minimize = {{PeakOf{derivative_of_shape(2)}}};
  p.corridors = {within(derivative_of_shape(3), 60, p)};
  solve(state, p);
}
BENCHMARK(Front)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace jounce
