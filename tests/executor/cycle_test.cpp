#include "jounce/executor/cycle.hpp"

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <new>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/executor/realtime.hpp"

#include "executor/tables.hpp"
#include "executor/virtual_pacer.hpp"

namespace {

thread_local long allocations = 0;

void* counted(std::size_t bytes) {
  ++allocations;
  if (void* memory = std::malloc(bytes)) return memory;
  throw std::bad_alloc();
}

}  // namespace

// The whole test program counts what it takes from and gives back to the heap.
void* operator new(std::size_t bytes) {
  return counted(bytes);
}
void* operator new[](std::size_t bytes) {
  return counted(bytes);
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {  // std::stable_sort's
  ++allocations;
  return std::malloc(bytes);
}
void operator delete(void* memory) noexcept {
  ++allocations;
  std::free(memory);
}
void operator delete[](void* memory) noexcept {
  ++allocations;
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  ++allocations;
  std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
  ++allocations;
  std::free(memory);
}

namespace jounce {
namespace {

using namespace test;

/// With cam switches of every kind, on the position.
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

struct Rig {
  Machine machine{{{.name = "feeder", .config = config, .switches = {.table = switches}}}};
  VirtualPacer pacer;
  Post post{1};
  Mail* mail = post.mail.front().get();
  Cycle cycle{machine, pacer, post};

  Tick next() {
    cycle.once();
    Tick tick;
    EXPECT_TRUE(mail->ticks.pop(tick));
    return tick;
  }
  Tick tell(const Command& command) {
    EXPECT_TRUE(mail->commands.push(command));
    return next();
  }
};

TEST(Cycle, TakesOneCommandATickAndAnswersThoseWithANumber) {
  Job job(1, trapezoid_table(50, 10, 20, 20));
  Rig rig;
  rig.mail->commands.push({.kind = Kind::enable});
  rig.mail->commands.push({.kind = Kind::arm, .id = 5, .movement = &job});
  rig.mail->commands.push({.kind = Kind::arm, .id = 6});
  rig.mail->commands.push({.kind = Kind::start, .id = 7});
  EXPECT_EQ(rig.next().state, State::standstill);
  EXPECT_EQ(rig.next().armed, 1U);
  EXPECT_EQ(rig.next().armed, 1U);
  EXPECT_EQ(rig.next().state, State::discrete_motion);
  Answer answer;
  ASSERT_TRUE(rig.mail->answers.pop(answer));
  EXPECT_EQ(answer.id, 5U);
  EXPECT_FALSE(answer.refused);
  ASSERT_TRUE(rig.mail->answers.pop(answer));
  EXPECT_EQ(answer.id, 6U);
  ASSERT_TRUE(answer.refused);
  EXPECT_EQ(answer.refused->cause, Cause::no_value);
  ASSERT_TRUE(rig.mail->answers.pop(answer));
  EXPECT_EQ(answer.id, 7U);
  EXPECT_FALSE(rig.mail->answers.pop(answer));
  for (int i = 0; i < 5500; ++i) rig.next();
  ASSERT_TRUE(rig.mail->answers.pop(answer));  // the end of the motion
  EXPECT_EQ(answer.id, 0U);
  EXPECT_EQ(answer.handed_back[0], &job);
}

TEST(Cycle, LateCyclesGoOnWithTheTickTheTimeHasComeFor) {
  const TablePtr move = trapezoid_table(50, 10, 20, 20);
  Job job(1, move);
  Rig rig;
  rig.tell({.kind = Kind::enable});
  rig.tell({.kind = Kind::arm, .movement = &job});
  rig.tell({.kind = Kind::start});  // tick 2
  rig.pacer.delay = 999'999;        // a little less than a period: late for nothing
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

TEST(Cycle, CountsTicksThatNobodyTakes) {
  Rig rig;
  for (std::size_t i = 0; i < Mail::most_ticks + 10; ++i) rig.cycle.once();
  EXPECT_EQ(rig.cycle.counts().lost, 10);
}

TEST(Cycle, NeverTouchesTheHeap) {
  Job move(1, there_and_back(0, 1, 2, Outside::wrap));
  Job cam(2, trapezoid_table(720, 180, 360, 360),
          table(Axis::master, Rule::quintic_hermite, Outside::wrap,
                {{0, 180, 360}, {0, 0.5, 0}, {0, 0, 0}, {0, 0, 0}}));
  Job too_fast(3, there_and_back(0, 1000, 1, Outside::hold));
  Rig rig;
  const std::vector<Command> script{
      {.kind = Kind::enable, .id = 1},
      {.kind = Kind::arm, .id = 2, .movement = &too_fast},
      {.kind = Kind::arm, .id = 3, .movement = &cam},
      {.kind = Kind::start, .id = 4, .at = 1600},
      {.kind = Kind::stop, .id = 5},
      {.kind = Kind::set_position, .id = 6, .position = 0},
      {.kind = Kind::arm, .id = 7, .movement = &move},
      {.kind = Kind::start, .id = 8},
      {.kind = Kind::abort, .id = 9},
      {.kind = Kind::reset, .id = 10},
      {.kind = Kind::disable, .id = 11},
  };
  std::vector<State> states;
  states.reserve(script.size());
  long used = 0;
  std::size_t edges = 0;
  for (const Command& command : script) {
    ASSERT_TRUE(rig.mail->commands.push(command));
    rig.pacer.delay = 2'500'000;
    const long before = allocations;
    for (int i = 0; i < 500; ++i) rig.cycle.once();
    used += allocations - before;
    for (Tick tick; rig.mail->ticks.pop(tick);) {
      states.push_back(tick.state);
      edges += tick.switches.count;
    }
  }
  EXPECT_EQ(used, 0);
  EXPECT_GT(edges, 3U);
  // The counter counts, and the script went through every state.
  const long before = allocations;
  std::make_unique<int>(1).reset();
  EXPECT_EQ(allocations - before, 2);
  for (const State state : {State::disabled, State::standstill, State::discrete_motion,
                            State::synchronized_motion, State::stopping, State::error_stop})
    EXPECT_NE(std::count(states.begin(), states.end(), state), 0) << name(state);
}

TEST(Cycle, RunsOnTheMachinesClock) {
  Machine machine({{.name = "feeder", .config = config}});
  MonotonicPacer pacer;
  Post post(1);
  Cycle cycle(machine, pacer, post);
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
}  // namespace jounce
