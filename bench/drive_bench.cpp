// SPDX-License-Identifier: Apache-2.0
// The drive model: cost of a second of motion. Times are of this machine; compare within one run.

#include <algorithm>
#include <thread>
#include <vector>

#include <benchmark/benchmark.h>

#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/validate/drive.hpp"
#include "jounce/validate/linear_drive.hpp"

#include "drive_by_hand.hpp"

namespace jounce {
namespace {

/// One second from start to end of the watch: 0.8 s of motion, 0.2 s of standstill.
Trajectory trapezoid_second() {
  return trapezoid({.from = 0, .to = 3600, .velocity = 6000, .acceleration = 30'000}).curve();
}

Trajectory s_curve_second() {
  return s_curve({.from = 0, .to = 3600, .velocity = 6200, .acceleration = 40'000, .jerk = 6e5})
      .curve();
}

Drive with_lag() {
  Drive drive = servo_400w();
  drive.motor.current_lag = 1e-4;
  return drive;
}

Drive four_masses() {
  Drive drive = with_lag();
  Mass part = drive.train[0];
  part.inertia /= 3;
  part.stiffness *= 3;
  drive.train = {part, part, part};
  return drive;
}

Drive rubbing() {
  Drive drive = with_lag();
  drive.motor.friction = {1e-4, 0.02, 0.03, 2};
  drive.train[0].friction = {1e-4, 0.05, 0.08, 2};
  return drive;
}

Drive with_backlash() {
  Drive drive = with_lag();
  drive.train[0].backlash = 2e-3;
  return drive;
}

Drive sampled(double cycle) {
  Drive drive = with_lag();
  drive.controller.cycle = cycle;
  return drive;
}

void drive_for_a_second(benchmark::State& state, const Trajectory& move, const Drive& drive) {
  DriveResult result;
  for (auto _ : state) {
    result = drive_through(move, drive, {.settle = 1 - move.length()});
    benchmark::DoNotOptimize(result);
  }
  if (!result.integration.ok()) state.SkipWithError(result.integration.reason.c_str());
  state.counters["steps"] = static_cast<double>(result.integration.steps);
  state.counters["restarts"] = static_cast<double>(result.integration.restarts);
}

/// The yardstick, in the same run.
void by_hand_for_a_second(benchmark::State& state, const Trajectory& move) {
  const Drive drive = servo_400w();
  long steps = 0;
  for (auto _ : state) {
    bench::ByHand hand(move, drive, 1);
    benchmark::DoNotOptimize(hand.run(1e-8, steps));
  }
  state.counters["steps"] = static_cast<double>(steps);
}

BENCHMARK_CAPTURE(by_hand_for_a_second, trapezoid, trapezoid_second())
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(by_hand_for_a_second, s_curve, s_curve_second())->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(drive_for_a_second, two_mass_trapezoid, trapezoid_second(), servo_400w())
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(drive_for_a_second, two_mass_s_curve, s_curve_second(), servo_400w())
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(drive_for_a_second, two_mass_lag_s_curve, s_curve_second(), with_lag())
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(drive_for_a_second, four_mass_s_curve, s_curve_second(), four_masses())
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(drive_for_a_second, friction_s_curve, s_curve_second(), rubbing())
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(drive_for_a_second, backlash_s_curve, s_curve_second(), with_backlash())
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(drive_for_a_second, sampled_1ms_s_curve, s_curve_second(), sampled(1e-3))
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(drive_for_a_second, sampled_62us_s_curve, s_curve_second(), sampled(62.5e-6))
    ->Unit(benchmark::kMicrosecond);

/// The same second exactly, at a thousand instants.
void exact_second(benchmark::State& state, const Trajectory& move, const Drive& drive) {
  std::vector<double> times(1000);
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = static_cast<double>(i) / 999;
  for (auto _ : state) benchmark::DoNotOptimize(exact_run(move, drive, times));
}
BENCHMARK_CAPTURE(exact_second, two_mass_trapezoid, trapezoid_second(), servo_400w())
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(exact_second, two_mass_s_curve, s_curve_second(), servo_400w())
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(exact_second, sampled_1ms_s_curve, s_curve_second(), sampled(1e-3))
    ->Unit(benchmark::kMicrosecond);

/// All figures of the same second, certified.
void exact_figures_of_a_second(benchmark::State& state, const Trajectory& move,
                               const Drive& drive) {
  for (auto _ : state)
    benchmark::DoNotOptimize(exact_through(move, drive, {.settle = 1 - move.length()}));
}
BENCHMARK_CAPTURE(exact_figures_of_a_second, two_mass_trapezoid, trapezoid_second(), servo_400w())
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(exact_figures_of_a_second, two_mass_s_curve, s_curve_second(), servo_400w())
    ->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(exact_figures_of_a_second, four_mass_s_curve, s_curve_second(), four_masses())
    ->Unit(benchmark::kMicrosecond);

/// A thousand axes whose load is off by up to 10 %, on two threads.
template <class Residual>
void monte_carlo(benchmark::State& state, const Residual& residual_of) {
  constexpr int cases = 1000;
  std::vector<double> residual(cases);
  const auto part = [&](int first) {
    for (int i = first; i < cases; i += 2) {
      Drive drive = servo_400w();
      drive.train[0].inertia *= 0.9 + 0.2 * i / cases;
      residual[static_cast<std::size_t>(i)] = residual_of(drive);
    }
  };
  for (auto _ : state) {
    std::thread other(part, 1);
    part(0);
    other.join();
    benchmark::DoNotOptimize(residual.data());
  }
}

void monte_carlo_by_integration(benchmark::State& state) {
  const Trajectory move = s_curve_second();
  monte_carlo(state, [&](const Drive& drive) {
    return drive_through(move, drive, {.settle = 1 - move.length()}).residual.value;
  });
}
BENCHMARK(monte_carlo_by_integration)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime()
    ->MeasureProcessCPUTime();

/// The method of over_tolerances().
void monte_carlo_exact(benchmark::State& state) {
  const Trajectory move = s_curve_second();
  monte_carlo(state, [&](const Drive& drive) {
    return exact_through(move, drive, {.settle = 1 - move.length()})->residual.value;
  });
}
BENCHMARK(monte_carlo_exact)->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();

}  // namespace
}  // namespace jounce
