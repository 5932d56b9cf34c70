// SPDX-License-Identifier: Apache-2.0
// 64 axes in one cycle: what a cycle computes, all axes playing. A cycle of 1 kHz has 1000 us.
#include <algorithm>
#include <chrono>
#include <memory>
#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include "jounce/axis/job.hpp"
#include "jounce/executor/detail/cycle.hpp"

namespace {

using namespace jounce;

/// Time passes by a period a cycle; now() within one is the real one, so that computing is counted.
class FreePacer final : public Pacer {
 public:
  std::int64_t now() override { return asleep_ + real() - woken_; }
  void sleep_until(std::int64_t instant) override {
    asleep_ = instant;
    woken_ = real();
  }

 private:
  static std::int64_t real() { return std::chrono::steady_clock::now().time_since_epoch().count(); }
  std::int64_t asleep_ = 0;
  std::int64_t woken_ = real();
};

std::vector<MachineAxis> axes(std::size_t count, bool follow) {
  std::vector<MachineAxis> all;
  for (std::size_t i = 0; i < count; ++i) {
    MachineAxis axis{.name = "axis" + std::to_string(i), .config = {}};
    axis.config.limits.velocity = 1000;
    axis.config.limits.acceleration = 1e5;
    axis.config.longest_gap = 1'000'000'000;
    if (follow && i > 0) axis.follow = {.what = Follow::What::setpoint, .index = i - 1};
    all.push_back(axis);
  }
  return all;
}

/// There and back in a second, without end, over 1000 knots.
std::shared_ptr<const Table> table() {
  Columns columns;
  for (int i = 0; i <= 1000; ++i) {
    const double s = i / 1000.0;
    columns.x.push_back(s);
    columns.p.push_back(100 * s * s * (1 - s) * (1 - s) * 16);
    columns.v.push_back(100 * 16 * 2 * s * (1 - s) * (1 - 2 * s));
  }
  return std::make_shared<const Table>(Domain::time, Interpolation::cubic_hermite,
                                       Extrapolation::wrap, std::move(columns));
}

void cycle(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  Machine machine(axes(count, state.range(1) != 0));
  FreePacer pacer;
  MachineExchange exchange(count);
  Cycle cycle(machine, pacer, exchange);
  const auto played = table();
  std::vector<std::unique_ptr<Job>> jobs;
  for (std::size_t i = 0; i < count; ++i) {
    jobs.push_back(std::make_unique<Job>(i + 1, played));
    exchange.axes[i]->commands.push({command::Enable{}});
    exchange.axes[i]->commands.push({command::Arm{.movement = jobs[i].get()}});
    exchange.axes[i]->commands.push({command::Start{}});
  }
  for (int i = 0; i < 10; ++i) cycle.once();
  Tick tick;
  for (auto _ : state) {
    cycle.once();
    state.PauseTiming();
    for (auto& axis : exchange.axes)
      while (axis->ticks.pop(tick)) benchmark::DoNotOptimize(tick);
    state.ResumeTiming();
  }
  if (tick.job == 0) state.SkipWithError("the axes do not play");
  state.counters["p99.9_us_at_most"] = upper_bound(exchange.cycle.computing.counts(), 0.999);
}
BENCHMARK(cycle)
    ->ArgNames({"axes", "follow"})
    ->Args({1, 0})
    ->Args({8, 0})
    ->Args({64, 0})
    ->Args({64, 1});

}  // namespace
