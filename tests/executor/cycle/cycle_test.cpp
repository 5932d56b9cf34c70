// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/detail/cycle.hpp"

#include <thread>

#include <gtest/gtest.h>

#include "jounce/executor/realtime.hpp"

#include "axis/tables.hpp"
#include "executor/rig.hpp"

namespace jounce::cycle_test {
namespace {

using namespace test;

const AxisConfig config{.limits = limits(10, 20)};

TEST(Cycle, TakesOneCommandATickAndAnswersThoseWithANumber) {
  Job job(1, trapezoid_table(50, 10, 20, 20));
  Rig rig(config);
  rig.axis.commands.push({command::Enable{}});
  rig.axis.commands.push({.what = command::Arm{.movement = &job}, .id = 5});
  rig.axis.commands.push({.what = command::Arm{}, .id = 6});
  rig.axis.commands.push({.what = command::Start{}, .id = 7});
  EXPECT_EQ(rig.next().state, State::standstill);
  EXPECT_EQ(rig.next().armed, 1U);
  EXPECT_EQ(rig.next().armed, 1U);
  EXPECT_EQ(rig.next().state, State::discrete_motion);
  Answer answer;
  ASSERT_TRUE(rig.axis.answers.pop(answer));
  EXPECT_EQ(answer.id, 5U);
  EXPECT_FALSE(answer.refused);
  ASSERT_TRUE(rig.axis.answers.pop(answer));
  EXPECT_EQ(answer.id, 6U);
  ASSERT_TRUE(answer.refused);
  EXPECT_EQ(answer.refused->cause, Cause::no_value);
  ASSERT_TRUE(rig.axis.answers.pop(answer));
  EXPECT_EQ(answer.id, 7U);
  EXPECT_FALSE(rig.axis.answers.pop(answer));
  for (int i = 0; i < 5500; ++i) rig.next();
  ASSERT_TRUE(rig.axis.answers.pop(answer));  // the end of the motion
  EXPECT_EQ(answer.id, 0U);
  EXPECT_EQ(answer.handed_back[0], &job);
}

TEST(Cycle, LateCyclesGoOnWithTheTickTheTimeHasComeFor) {
  const TablePtr move = trapezoid_table(50, 10, 20, 20);
  Job job(1, move);
  Rig rig(config);
  rig.order({command::Enable{}});
  rig.order({command::Arm{.movement = &job}});
  rig.order({command::Start{}});  // tick 2
  rig.pacer.delay = 999'999;      // a little less than a period: late for nothing
  EXPECT_EQ(rig.next().tick, 3);
  rig.pacer.delay = 4'200'000;
  const Tick late = rig.next();  // due at 4, woken at 8.2
  EXPECT_EQ(late.tick, 8);
  EXPECT_EQ(late.skipped, 4);
  EXPECT_EQ(late.position, move->jet(0.006)[0]);
  EXPECT_EQ(rig.next().tick, 9);
  EXPECT_EQ(rig.next().tick, 10);
  const CycleCounts& counts = rig.cycle.counts();
  EXPECT_EQ(counts.ticks, 7);
  EXPECT_EQ(counts.late, 1);
  EXPECT_EQ(counts.skipped, 4);
  EXPECT_EQ(counts.latest_ns, 4'200'000);
  EXPECT_EQ(counts.lost, 0);
}

TEST(Cycle, StopsTheAxesWhereTheOtherThreadIsSilent) {
  Machine machine({{.name = "feeder", .config = {.limits = limits(1000, 1e4)}}});
  VirtualPacer pacer;
  MachineExchange exchange{1};
  Cycle cycle{machine, pacer, exchange, {.patience = 10}};
  Tick tick;
  const auto turn = [&](bool alive, const Command& command = {}) {
    if (command.kind() != Kind::none) {
      ASSERT_TRUE(exchange.axes[0]->commands.push(command));
    }
    exchange.cycle.alive += alive ? 1 : 0;
    cycle.once();
    ASSERT_TRUE(exchange.axes[0]->ticks.pop(tick));
  };
  turn(true, {command::Enable{}});
  turn(true, {command::MoveVelocity{.velocity = 100}});
  for (int i = 0; i < 50; ++i) turn(true);
  for (int i = 0; i < 10; ++i) turn(false);
  EXPECT_EQ(tick.velocity, 100) << "within its patience";
  for (int i = 0; i < 50; ++i) turn(false);
  EXPECT_EQ(tick.fault, Cause::watchdog);
  EXPECT_EQ(tick.velocity, 0);
}

TEST(Cycle, CountsTicksThatAreNotRead) {
  Rig rig(config);
  for (std::size_t i = 0; i < AxisExchange::most_ticks + 10; ++i) rig.cycle.once();
  EXPECT_EQ(rig.cycle.counts().lost, 10);
}

TEST(Cycle, RunsOnTheMachinesClock) {
  Machine machine({{.name = "feeder", .config = config}});
  MonotonicPacer pacer;
  MachineExchange exchange(1);
  Cycle cycle(machine, pacer, exchange);
  const std::int64_t begin = pacer.now();
  std::string note;
  std::thread thread([&] {
    note = make_realtime({.priority = 1});
    for (int i = 0; i < 20; ++i) cycle.once();
  });
  thread.join();
  EXPECT_FALSE(note.empty());
  EXPECT_EQ(cycle.counts().ticks, 20);
  // Never early: tick 19 and those skipped before it belong to instants 19 ms and more later.
  EXPECT_GE(pacer.now() - begin, (19 + cycle.counts().skipped) * 1'000'000);
}

}  // namespace
}  // namespace jounce::cycle_test
