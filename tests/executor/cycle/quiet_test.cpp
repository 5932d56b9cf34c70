// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <mutex>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/axis/live_gear.hpp"
#include "jounce/axis/master.hpp"
#include "jounce/drive/encoder.hpp"
#include "jounce/executor/detail/cycle.hpp"
#include "jounce/executor/detail/recorder.hpp"

#include "axis/tables.hpp"
#include "executor/cycle/virtual_pacer.hpp"
#include "executor/hooks.hpp"

namespace jounce::quiet_test {
namespace {

using namespace test;

/// Cam switches of every kind, on the position.
const CamSwitchSpec switches{.switches = {{.first_on_position = 0.1, .last_on_position = 0.3},
                                          {.track = 2,
                                           .first_on_position = 0.8,
                                           .last_on_position = 0.2,
                                           .axis_direction = AxisDirection::negative},
                                          {.track = 3,
                                           .first_on_position = 0.25,
                                           .mode = CamSwitchMode::time,
                                           .duration = 0.1}},
                             .tracks = {{.on_compensation = -0.01, .off_compensation = 0.005},
                                        {.track = 2, .hysteresis = 0.01},
                                        {.track = 3, .on_compensation = 0.002, .inverted = true}},
                             .period = 1};

const AxisConfig config{.limits = limits(10, 20)};

/// Three axes: one with switches and a drive, one that follows it, one alone.
struct Rig {
  Machine machine{{{.name = "feeder", .config = config, .switches = {.table = switches}},
                   {.name = "knife",
                    .config = config,
                    .switches = {.of = SwitchesOf::master, .table = switches},
                    .follow = {.what = Follow::What::setpoint, .index = 0}},
                   {.name = "tape", .config = config}}};
  VirtualPacer pacer;
  MachineExchange exchange{3};
  NullDrive drive;
  Cycle cycle{machine, pacer, exchange, {.drives = {&drive, nullptr, nullptr}, .patience = 5000}};
};

/// Counts the forbidden operations of the cyclic thread in `cycles` cycles, one of which is late.
Noise noise_of(Rig& rig, int cycles) {
  rig.pacer.delay = 2'500'000;
  const Noise before = noise();
  for (int i = 0; i < cycles; ++i) rig.cycle.once();
  return noise() - before;
}

TEST(Quiet, ACycleNeitherTouchesTheHeapNorLocksNorWrites) {
  Job move(1, there_and_back(0, 1, 2, Extrapolation::wrap));
  Job cam(2, trapezoid_table(720, 180, 360, 360),
          table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
                {{0, 180, 360}, {0, 0.5, 0}, {0, 0, 0}, {0, 0, 0}}));
  Job too_fast(3, there_and_back(0, 1000, 1, Extrapolation::hold));
  Rig rig;
  const std::vector<Command> script{
      {.what = command::Enable{}, .id = 1},
      {.what = command::Arm{.movement = &too_fast}, .id = 2},
      {.what = command::Arm{.movement = &cam}, .id = 3},
      {.what = command::Start{.tick = 1600}, .id = 4},
      {.what = command::Stop{}, .id = 5},
      {.what = command::SetPosition{.position = 0}, .id = 6},
      {.what = command::Arm{.movement = &move}, .id = 7},
      {.what = command::Start{}, .id = 8},
      {.what = command::Abort{}, .id = 9},
      {.what = command::Reset{}, .id = 10},
      {.what = command::Disable{}, .id = 11},
  };
  std::vector<State> states;
  std::size_t edges = 0;
  for (const Command& command : script) {
    ASSERT_TRUE(rig.exchange.axes[0]->commands.push(command));
    EXPECT_EQ(noise_of(rig, 500), Noise{}) << "command " << command.id;
    for (Tick tick; rig.exchange.axes[0]->ticks.pop(tick);) {
      states.push_back(tick.state);
      edges += tick.switches.count;
    }
  }
  EXPECT_GT(edges, 3U);
  for (const State state : {State::disabled, State::standstill, State::discrete_motion,
                            State::synchronized_motion, State::stopping, State::error_stop})
    EXPECT_NE(std::count(states.begin(), states.end(), state), 0) << name(state);
}

// Followers of a line on the bus and of an encoder on the feeder's drive: through coming, going and another clock.
TEST(Quiet, ExternalMasters) {
  ExternalMaster line({.velocity = 10, .acceleration = 50});
  auto drive = std::make_shared<ObservedDrive>(std::make_shared<NullDrive>());
  EncoderReading reading({.resolution = 1e-4, .noise = 1e-5});
  EncoderMaster encoder({.velocity = 10, .acceleration = 50},
                        [&] { return reading(drive->position()); });
  Machine machine(
      {{.name = "knife", .config = config, .follow = {.what = Follow::What::master, .index = 0}},
       {.name = "label", .config = config, .follow = {.what = Follow::What::master, .index = 1}}},
      2);
  VirtualPacer pacer;
  MachineExchange exchange(2, 2);
  const auto buffer = std::make_unique<RecordBuffer>();
  Cycle cycle(
      machine, pacer, exchange,
      {.drives = {drive.get(), nullptr}, .masters = {&line, &encoder}, .record = buffer.get()});
  LiveGear gear(1, {.numerator = 1, .denominator = 2, .acceleration = 10});
  LiveGear other(2, {.numerator = 1, .denominator = 2, .acceleration = 10});
  const auto run = [&](int cycles, std::int32_t clock, bool valid) {
    Noise noise_of_cycles{};
    for (int i = 0; i < cycles; ++i) {
      const double now = static_cast<double>(pacer.now() - exchange.cycle.start) * 1e-9;
      if (clock > 0)
        line.receive({static_cast<std::int64_t>(now * 1e9), clock, now, 2 * now, valid});
      const Noise before = noise();
      cycle.once();
      noise_of_cycles = noise() - before;
      if (!(noise_of_cycles == Noise{})) return noise_of_cycles;
    }
    return noise_of_cycles;
  };
  for (std::size_t i = 0; i < 2; ++i) exchange.axes[i]->commands.push({command::Enable{}});
  EXPECT_EQ(run(200, 1, true), Noise{});
  exchange.axes[0]->commands.push({.what = command::Couple{.movement = &gear}, .id = 1});
  exchange.axes[1]->commands.push({.what = command::Couple{.movement = &other}, .id = 1});
  EXPECT_EQ(run(1000, 1, true), Noise{});
  EXPECT_FALSE(exchange.masters[0]->read()->lost());
  EXPECT_FALSE(exchange.masters[1]->read()->lost());
  EXPECT_EQ(run(200, 2, true), Noise{});
  EXPECT_EQ(run(200, 2, false), Noise{});
  EXPECT_TRUE(exchange.masters[0]->read()->lost());
  EXPECT_EQ(run(500, 0, true), Noise{});
  Tick last;
  while (exchange.axes[0]->ticks.pop(last)) {
  }
  EXPECT_EQ(last.fault, Cause::master_lost);
}

TEST(Quiet, FullRingsAndAWatchdog) {
  Rig rig;
  EXPECT_EQ(noise_of(rig, 6000), Noise{});
  EXPECT_GT(rig.cycle.counts().lost, 3000);
}

// The hooks do count: a silent result is evidence.
TEST(Quiet, TheHooksDetectAllocationsLocksAndWrites) {
  Noise before = noise();
  int* volatile memory = new int(1);  // volatile: or the compiler spares itself the way
  delete memory;
  EXPECT_EQ((noise() - before).heap, 2);
#ifndef __SANITIZE_THREAD__
  std::mutex mutex;
  before = noise();
  { const std::lock_guard lock(mutex); }
  const long locks = (noise() - before).locks;
  EXPECT_EQ(locks, 1);
  before = noise();
  EXPECT_EQ(write(STDERR_FILENO, "", 0), 0);
  EXPECT_EQ((noise() - before).writes, 1);
#endif
}

}  // namespace
}  // namespace jounce::quiet_test
