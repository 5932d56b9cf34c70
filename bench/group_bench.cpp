// SPDX-License-Identifier: Apache-2.0
// A cycle of a group and its axes, which play a path of short lines with rounded corners.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

#include "jounce/axis/detail/group_path.hpp"
#include "jounce/axis/machine.hpp"
#include "jounce/path/plan.hpp"

namespace {

using namespace jounce;

const Limits limits{.velocity = 500, .acceleration = 5000, .jerk = 1e5};

/// A closed path of lines of about 2 u, with corners of 0.05 u, on all axes.
Program lines(std::size_t axes, int count) {
  Program program(axes);
  program.set({.velocity = 100, .corner = Corner::deviation, .value = 0.05});
  Point at{};
  for (int i = 1; i <= count; ++i) {
    for (std::size_t k = 0; k < axes; ++k)
      at[k] = std::sin(0.02 * i * static_cast<double>(k + 1)) * 40 + 0.5 * std::sin(1.7 * i);
    program.line(at, i);
  }
  program.line({});
  return program;
}

double share(std::vector<double>& all, double part) {
  const auto at =
      all.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), at, all.end());
  return *at;
}

void group_cycle(benchmark::State& state) {
  const auto count = static_cast<std::size_t>(state.range(0));
  const std::vector<AxisConfig> configs(count, AxisConfig{.limits = limits});
  std::vector<MachineAxis> axes;
  AxisGroup group;
  std::vector<std::string> names;
  for (std::size_t k = 0; k < count; ++k) {
    names.push_back("axis" + std::to_string(k));
    group.axes.push_back(k);
    axes.push_back({.name = names.back(), .config = configs[k]});
  }
  axes.push_back({.name = "group", .config = group_config(configs), .group = group});
  Machine machine(axes);
  std::vector<AxisImage> images(count + 1);
  const GroupProgram program =
      group_program(std::make_shared<const Plan>(
                        plan(lines(count, 2000), {.axes = std::vector<Limits>(count, limits)})),
                    configs, names);
  std::unique_ptr<GroupPath> path;
  std::int64_t tick = -1;
  const auto step = [&] {
    machine.step(++tick, images);
    for (AxisImage& image : images) image.command = {};
  };
  const auto start = [&] {
    path = std::make_unique<GroupPath>(1, program);
    images[count].command = {command::Arm{path.get()}};
    step();
    images[count].command = {command::Start{}};
    step();
  };
  for (AxisImage& image : images) image.command = {command::Enable{}};
  images[count].command = {};
  step();
  images[count].command = {command::Enable{}};
  step();
  start();
  std::vector<double> us;
  us.reserve(10'000'000);
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    machine.step(++tick, images);
    const auto end = std::chrono::steady_clock::now();
    us.push_back(std::chrono::duration<double, std::micro>(end - begin).count());
    images[count].command = {};
    if (images[count].tick.job == 0) start();
  }
  if (images[count].tick.state != State::discrete_motion) state.SkipWithError("the group rests");
  state.counters["median_us"] = share(us, 0.5);
  state.counters["p99.9_us"] = share(us, 0.999);
}
BENCHMARK(group_cycle)->ArgName("axes")->Arg(2)->Arg(6)->Arg(9);

/// Plans a program of 20000 lines in one thread, with or without the check against the limits of the
/// axes. Another thread evaluates the path of a group with the same number of axes every millisecond.
/// `segments_per_s` counts the lines.
void group_planning(benchmark::State& state) {
  constexpr int count = 20'000;
  const auto axes = static_cast<std::size_t>(state.range(0));
  const std::vector<AxisConfig> configs(axes, AxisConfig{.limits = limits});
  const std::vector<std::string> names(axes, "axis");
  const Program program = lines(axes, count);
  const GroupLimits group_limits{.axes = std::vector<Limits>(axes, limits)};
  GroupPath path(
      1, group_program(std::make_shared<const Plan>(plan(lines(axes, 2000), group_limits)), configs,
                       names));
  std::jthread cycle([&](const std::stop_token& leave) {
    auto due = std::chrono::steady_clock::now();
    for (double t = 0; !leave.stop_requested(); t += 1e-3) {
      std::this_thread::sleep_until(due += std::chrono::milliseconds(1));
      benchmark::DoNotOptimize(path.at({.t = std::fmod(t, path.known()), .dt = 1e-3}));
    }
  });
  const bool checked = state.range(1) != 0;
  for (auto _ : state) {
    auto planned = std::make_shared<const Plan>(plan(program, group_limits));
    if (checked)
      benchmark::DoNotOptimize(group_program(std::move(planned), configs, names));
    else
      benchmark::DoNotOptimize(planned);
  }
  state.counters["segments_per_s"] =
      benchmark::Counter(count, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(group_planning)
    ->ArgNames({"axes", "checked"})
    ->ArgsProduct({{2, 6}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
