// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/stream/detail/sender.hpp"
#include "jounce/stream/sender/driver.hpp"

#include "axis/tables.hpp"
#include "executor/site.hpp"
#include "executor/src/server/events.hpp"

namespace jounce::several_axes_test {
namespace {

using namespace test;
using namespace std::chrono_literals;

const Units over_time{.x = "s", .position = "mm"};

std::vector<ExecutorOptions> feeder_and_knife() {
  std::vector<ExecutorOptions> axes{axis_named("feeder", limits(1000, 1e5)),
                                    axis_named("knife", limits(1000, 1e5))};
  axes[0].switches = {.table = {.switches = {{.first_on_position = 2, .last_on_position = 4}}}};
  axes[1].follow = {.what = Follow::What::setpoint, .index = 0};
  return axes;
}

/// Two axes on one link, the second following the first, and their clients.
struct Two : Site {
  Two() : Site(feeder_and_knife()) {
    for (const auto& one : axes)
      for (const auto lane : {wire::Lane::reply, wire::Lane::event})
        link.subscribe(wire::channel(one.receiver.executor, lane), 64);
  }
  StreamOutcome play_on(const std::string& name, const TablePtr& table) {
    return stream({.executor = name, .tables = {{*table, over_time}}});
  }
};

TEST(SeveralAxes, EachHasItsOwnSessionsAndStopsAlone) {
  Two site;
  ASSERT_TRUE(site.play_on("feeder", there_and_back(0, 10, 1, Extrapolation::wrap)).ok());
  ASSERT_TRUE(site.play_on("knife", there_and_back(0, 5, 1, Extrapolation::wrap)).ok());
  site.advance(300ms);
  EXPECT_TRUE(operator_stop(site.link, "knife", wire::StopMode::stop, 2s, {}, site.clock));
  site.advance(1s);
  EXPECT_EQ(site.last(1).stopped, 1U);
  EXPECT_EQ(site.last(1).state, State::standstill);
  EXPECT_EQ(site.last(0).state, State::discrete_motion);
}

TEST(SeveralAxes, AnOperatorsOverrideReachesTheAxisThatIsNamed) {
  Two site;
  ASSERT_TRUE(site.play_on("feeder", there_and_back(0, 10, 1, Extrapolation::wrap)).ok());
  const wire::Reply reply = operator_command(
      site.link, "feeder", wire::Command{.kind = CommandKind::override_, .value = {0.5}}, 2s, {},
      site.clock);
  EXPECT_EQ(reply.outcome, wire::Outcome::accepted) << reply.reason;
  site.advance(200ms);
  EXPECT_EQ(site.last(0).override_, 0.5);
  EXPECT_EQ(site.last(1).override_, 1);
}

TEST(SeveralAxes, TheAnswerToAnOverrideNamesTheHighestFactor) {
  Two site;
  ASSERT_TRUE(site.play_on("feeder", trapezoid_table(400, 800, 1e4, 1e4)).ok());
  site.advance(100ms);
  const wire::Reply reply = operator_command(
      site.link, "feeder", wire::Command{.kind = CommandKind::override_, .value = {2}}, 2s, {},
      site.clock);
  EXPECT_EQ(reply.outcome, wire::Outcome::accepted);
  EXPECT_EQ(reply.reason, "the limits permit at most 125 % of the speed of the present motion")
      << "1000 mm/s over 800 mm/s";
}

TEST(SeveralAxes, EdgesOfSwitchesAreMessagesTwiceEach) {
  Two site;
  ASSERT_TRUE(site.play_on("feeder", trapezoid_table(5, 50, 1000, 1000)).ok());
  site.advance(500ms);
  std::vector<wire::Event> events;
  Rejects rejects;
  while (const auto message = next_message(site.link, 0ns, rejects))
    if (const auto* event = std::get_if<wire::Event>(&message->body)) events.push_back(*event);
  ASSERT_EQ(events.size(), 4U);
  for (const auto& event : events) {
    EXPECT_EQ(event.kind, wire::EventKind::track);
    EXPECT_EQ(event.number, 1U);
    EXPECT_EQ(event.on, event.count == 1);
    EXPECT_NEAR(event.position, event.on ? 2 : 4, 1e-9);
    EXPECT_GE(event.offset_s, 0);
    EXPECT_LE(event.offset_s, 1e-3);
  }
}

// The instant is the one at which the position is passed: 1/2 * 1000 * t^2 = 2 of a ramp from rest.
TEST(SeveralAxes, AnEventHasItsTimeBetweenTheTicks) {
  Tick before{.tick = 62, .position = 500 * 0.062 * 0.062, .velocity = 62};
  Tick now{.tick = 64, .position = 500 * 0.064 * 0.064, .velocity = 64, .skipped = 1};
  const double at = std::sqrt(2.0 / 500);  // 63.2 ms
  now.switches.count = 1;
  now.switches.edge[0] = {.time = at - 0.062, .track = 3, .on = true};
  const auto events = events_of(before, now, {}, 1'000'000, 7);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].count, 8);
  EXPECT_EQ(events[0].number, 3U);
  EXPECT_EQ(events[0].tick, 64);
  EXPECT_NEAR(events[0].offset_s, 0.064 - at, 1e-12);
  EXPECT_NEAR(events[0].position, 2, 1e-12);
}

// Arm and start that have reached the axis are a first tick of motion two cycles later.
TEST(SeveralAxes, FromAnArmAtTheAxisToTheFirstTickAreTwoCycles) {
  Two site;
  site.advance(10ms);
  Job job(77, there_and_back(0, 1, 1, Extrapolation::hold));
  AxisExchange& axis = *site.exchange.axes[1];
  axis.commands.push({command::Arm{.movement = &job}});
  axis.commands.push({command::Start{}});
  site.cycle.once();
  site.cycle.once();
  Tick last;
  while (axis.ticks.pop(last)) {
  }
  EXPECT_EQ(last.job, 77U);
  EXPECT_EQ(last.state, State::discrete_motion);
}

// The same from the wire on, where a message comes between two cycles: the arm goes out after one, its
// answer and the start after the next, and the one after that is the first tick of motion.
TEST(SeveralAxes, FromTheArmOnTheWireToTheFirstTickAreTwoCycles) {
  Two site;
  const StreamPlan plan{.executor = "knife",
                        .tables = {{*there_and_back(0, 1, 1, Extrapolation::hold), over_time}},
                        .goal = StreamGoal::download};
  Sender sender(plan, 4711);
  Rejects rejects;
  const auto talk = [&] {
    while (const auto message = next_message(site.link, 0ns, rejects))
      sender.receive(*message, site.clock());
    for (const auto& message : sender.poll(site.clock())) send_message(site.link, message);
    site.dispatcher.turn(0ns);
  };
  for (int turn = 0; turn < 100 && !sender.at_goal(); ++turn) talk();
  ASSERT_TRUE(sender.at_goal()) << sender.outcome().reason;
  sender.raise(StreamGoal::start);
  std::int64_t asked = 0, tick = 0, moving = 0;
  for (; moving == 0 && tick < 50; ++tick) {
    talk();
    site.cycle.once();
    site.dispatcher.turn(0ns);
    if (asked == 0) asked = site.last(1).tick;
    if (site.last(1).job != 0) moving = site.last(1).tick;
  }
  EXPECT_EQ(moving - asked + 1, 2);
}

}  // namespace
}  // namespace jounce::several_axes_test
