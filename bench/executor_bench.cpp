// SPDX-License-Identifier: Apache-2.0
// What a step of an axis costs, by what it does in it.
//   build/release/bench/bench_executor --benchmark_repetitions=5
// Results: docs/executor/axis.md. The paths run at full speed, and at half of it by an override.
#include <cmath>
#include <memory>

#include <benchmark/benchmark.h>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/job.hpp"

namespace {

using namespace jounce;
using Kind = CommandKind;

AxisConfig config() {
  AxisConfig axis;
  axis.limits.velocity = 1000;
  axis.limits.acceleration = 1e5;
  axis.limits.position_min = -1e12;
  axis.limits.position_max = 1e12;
  return axis;
}

/// There and back without end by quintics, in 64 pieces.
std::shared_ptr<const Table> turning() {
  Columns c;
  const double w = 2 * M_PI;
  for (int i = 0; i <= 64; ++i) {
    const double t = i / 64.0;
    c.x.push_back(t);
    c.p.push_back(50 * (1 - std::cos(w * t)));
    c.v.push_back(50 * w * std::sin(w * t));
    c.a.push_back(50 * w * w * std::cos(w * t));
  }
  c.p.back() = c.p.front();
  c.v.back() = c.v.front() = 0;
  c.a.back() = c.a.front();
  return std::make_shared<const Table>(jounce::Domain::time, Interpolation::quintic_hermite,
                                       Extrapolation::wrap, std::move(c));
}

void run(benchmark::State& state, MotionAxis& axis, std::int64_t tick) {
  for (auto _ : state) benchmark::DoNotOptimize(axis.step(++tick));
  state.counters["moves"] = axis.state() == State::standstill ? 0 : 1;
}

void idle(benchmark::State& state) {
  MotionAxis axis(config());
  axis.step(0, {command::Enable{}});
  run(state, axis, 0);
}
BENCHMARK(idle);

void table_over_time(benchmark::State& state) {
  Job job(1, turning());
  MotionAxis axis(config());
  axis.step(0, {command::Enable{}});
  axis.step(1, {command::Arm{.movement = &job}});
  axis.step(2, {command::Start{}});
  axis.step(3, {command::Override{.factor = static_cast<double>(state.range(0)) / 100}});
  run(state, axis, 3);
}
BENCHMARK(table_over_time)->Arg(100)->Arg(50);

void move_at_a_velocity(benchmark::State& state) {
  MotionAxis axis(config());
  axis.step(0, {command::Enable{}});
  axis.step(1, {command::MoveVelocity{.velocity = 1}});
  run(state, axis, 1);
}
BENCHMARK(move_at_a_velocity);

/// A new target in every step: what planning costs.
void a_new_target_each_tick(benchmark::State& state) {
  AxisConfig limits = config();
  limits.limits.jerk = state.range(0) != 0 ? std::optional(1e7) : std::nullopt;
  MotionAxis axis(limits);
  axis.step(0, {command::Enable{}});
  std::int64_t tick = 0;
  for (auto _ : state) {
    const double target = ++tick % 2000 < 1000 ? 300 : -300;
    benchmark::DoNotOptimize(axis.step(tick, {command::MoveAbsolute{.position = target}}));
  }
}
BENCHMARK(a_new_target_each_tick)->Arg(0)->Arg(1)->ArgName("jerk");

}  // namespace
