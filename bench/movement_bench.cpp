// SPDX-License-Identifier: Apache-2.0
// What an axis plays, and what it follows: ns a cycle of 1 ms, without the axis.
#include <cmath>
#include <memory>

#include <benchmark/benchmark.h>

#include "jounce/axis/fifo_movement.hpp"
#include "jounce/axis/job.hpp"
#include "jounce/axis/live_cam.hpp"
#include "jounce/axis/live_gear.hpp"
#include "jounce/axis/master.hpp"

namespace {

using namespace jounce;

std::shared_ptr<const Table> cam() {
  return std::make_shared<const Table>(Domain::master, Interpolation::quintic_hermite,
                                       Extrapolation::wrap,
                                       Columns{{0, 75, 200, 280, 360},
                                               {0, 100, 225, 100, 0},
                                               {0, 1, 1, 0.01739120485, 0},
                                               {0, 0, 0, 0, 0}});
}

std::shared_ptr<const Table> to_and_fro() {
  return std::make_shared<const Table>(Domain::time, Interpolation::quintic_hermite,
                                       Extrapolation::wrap,
                                       Columns{{0, 1, 2}, {0, 50, 0}, {0, 0, 0}, {0, 0, 0}});
}

/// A master at 200 m/s.
void play(benchmark::State& state, Movement& movement) {
  Moment now{0, 1e-3, {0, 200, 0, 0}};
  if (movement.begin({}, now) != Cause::none) return state.SkipWithError("refused");
  std::int64_t tick = 0;
  for (auto _ : state) {
    now.t = static_cast<double>(++tick) * 1e-3;
    now.master[0] = 200 * now.t;
    benchmark::DoNotOptimize(movement.at(now));
  }
}

void job(benchmark::State& state) {
  Job movement(1, to_and_fro());
  play(state, movement);
}
BENCHMARK(job);

/// Rows of 10 ms, pushed as they are needed.
void stream(benchmark::State& state) {
  const int degree = static_cast<int>(state.range(0));
  FifoPath path(1, {.each = 32});
  int row = 0;
  const auto refill = [&] {
    const SegmentRow next{.x_end = 0.01 * (row + 1),
                          .p_end = 0,
                          .v_start = 0,
                          .v_end = degree == 2 ? SegmentRow::open : 0,
                          .degree = degree};
    if (path.fifos().push(0, next) != RowRule::none) return false;
    ++row;
    return true;
  };
  while (refill()) {
  }
  Moment now;
  if (path.begin({}, now) != Cause::none) return state.SkipWithError("refused");
  std::int64_t tick = 0;
  for (auto _ : state) {
    now.t = static_cast<double>(++tick) * 1e-3;
    benchmark::DoNotOptimize(path.at(now));
    if (tick % 10 == 0) refill();
  }
}
BENCHMARK(stream)->ArgName("degree")->Arg(2)->Arg(3)->Arg(5);

void follow(benchmark::State& state) {
  FifoFollow movement(1, {.each = 16, .stream = false, .loops = 0});
  movement.fifos().push(0, {.x_end = 20000, .p_end = 10000, .v_start = 0});
  movement.fifos().push(0, {.x_end = 40000, .p_end = 20000});
  play(state, movement);
}
BENCHMARK(follow);

void live_cam(benchmark::State& state) {
  LiveCam movement(1, cam());
  play(state, movement);
}
BENCHMARK(live_cam);

void live_gear(benchmark::State& state) {
  LiveGear movement(1, {.numerator = 1, .denominator = 2, .acceleration = 1e4});
  play(state, movement);
}
BENCHMARK(live_gear);

void live_gear_in_pos(benchmark::State& state) {
  LiveGearInPos movement(1, {.numerator = 1,
                             .denominator = 2,
                             .master_sync_position = 5000,
                             .slave_sync_position = 2000,
                             .master_start_distance = 4000});
  play(state, movement);
}
BENCHMARK(live_gear_in_pos);

void encoder_master(benchmark::State& state) {
  EncoderMaster master({.velocity = 3, .acceleration = 20});
  std::int64_t tick = 0;
  for (auto _ : state) {
    const double t = static_cast<double>(++tick) * 1e-3;
    master.read(t, std::floor(t * 20000) / 20000);
    benchmark::DoNotOptimize(master.at(t));
  }
}
BENCHMARK(encoder_master);

/// One sample is received and taken in each cycle.
void external_master(benchmark::State& state) {
  ExternalMaster master({.velocity = 3, .acceleration = 20});
  std::int64_t tick = 0;
  for (auto _ : state) {
    const double t = static_cast<double>(++tick) * 1e-3;
    master.receive({tick * 1'000'000, 1, t + 2e-4, t, true});
    benchmark::DoNotOptimize(master.at(t));
  }
}
BENCHMARK(external_master);

}  // namespace
