// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/sender/operate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/stream/receiver/receiver_options.hpp"
#include "jounce/stream/sender/banks.hpp"

#include "stream/sender/rows.hpp"

namespace jounce::operate_test {
namespace {

using test::World;
using testing::ElementsAre;
using wire::Outcome;
using wire::Refusal;

TEST(Operate, AReplyIsAnOutcome) {
  EXPECT_TRUE(outcome_of({.outcome = Outcome::accepted}, "feeder").ok());
  EXPECT_EQ(outcome_of({.outcome = Outcome::pending}, "feeder").error,
            StreamError::command_timeout);
  wire::Reply refused{.outcome = Outcome::refused};
  refused.refusal = Refusal::axis;
  refused.reason = "not_enabled";
  EXPECT_EQ(outcome_of(refused, "feeder").error, StreamError::refused);
  EXPECT_EQ(outcome_of(refused, "feeder").reason, "axis: not_enabled");
}

TEST(Banks, PlayInTheirOrder) {
  World world;
  Client client(world.link, "feeder", {}, world.clock);
  const BankPlan plan{
      .queue = {.units = {"s", "mm"}, .mode = wire::QueueMode::static_, .capacity = 16},
      .first = test::source_of(3)(3),
      .second = test::source_of(4)(4)};
  const CallOutcome outcome = play_banks(client, plan, {.until = BankOptions::Until::accepted});
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_EQ(world.executor->rows.size(), 7U);
}

TEST(Banks, ACancelledPlanStartsNothing) {
  World world;
  Client client(world.link, "feeder", {}, world.clock);
  const BankPlan plan{
      .queue = {.units = {"s", "mm"}, .mode = wire::QueueMode::static_, .capacity = 16},
      .first = test::source_of(3)(3)};
  EXPECT_TRUE(play_banks(client, plan, {.cancelled = [] { return true; }}).ok());
  EXPECT_TRUE(world.executor->rows.empty());
}

TEST(Operate, KeepsAHoldToRunJogUntilItIsCancelled) {
  World world;
  int asked = 0;
  bool begun = false;
  const CallOutcome outcome = execute_command(
      world.link, "feeder", command::MoveVelocity{.velocity = 5, .hold_to_run = true},
      {.held = [&] { begun = true; }, .cancelled = [&] { return ++asked > 2; }}, world.clock);
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
  EXPECT_TRUE(begun);
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(world.executor->pump.receiver().session(), 0) << "the session has ended";
}

TEST(Operate, AHoldToRunJogReportsTheStopOfAnotherOperator) {
  World world;
  int asked = 0;
  const CallOutcome outcome = execute_command(
      world.link, "feeder", command::MoveVelocity{.velocity = 5, .hold_to_run = true},
      {.cancelled =
           [&] {
             if (++asked == 2) {
               EXPECT_TRUE(operator_stop(world.link, "feeder", wire::StopMode::stop,
                                         std::chrono::seconds(1), {}, world.clock));
             }
             return asked > 20;
           }},
      world.clock);
  EXPECT_EQ(outcome.error, StreamError::stopped);
  EXPECT_EQ(outcome.reason, "another operator stopped the axis");
  EXPECT_LT(asked, 20);
  EXPECT_EQ(world.executor->pump.receiver().session(), 0) << "it does not take the axis again";
}

TEST(Operate, AHoldToRunJogReportsItsEarlyEnd) {
  for (const bool faulty : {false, true}) {
    World world;
    wire::Status status{.state = State::continuous_motion, .cycle_ns = 1'000'000};
    world.each_turn = [&] { world.executor->pump.publish(status); };
    int asked = 0;
    const CallOutcome outcome = execute_command(
        world.link, "feeder", command::MoveVelocity{.velocity = 5, .hold_to_run = true},
        {.cancelled =
             [&] {
               if (++asked == 3) {
                 status.state = faulty ? State::error_stop : State::standstill;
                 const Cause why = faulty ? Cause::positive_soft_limit : Cause::group_stopped;
                 (faulty ? status.last_error : status.reason) = static_cast<std::int32_t>(why);
               }
               return asked > 20;
             }},
        world.clock);
    EXPECT_EQ(outcome.error, StreamError::stopped);
    EXPECT_THAT(outcome.reason, testing::HasSubstr(faulty ? "the jog has ended: positive_soft_limit"
                                                          : "the jog has ended: group_stopped"));
    EXPECT_LT(asked, 20);
  }
}

TEST(Operate, AnOrderWaitsAMomentForTheEndOfAnotherOne) {
  ReceiverOptions options;
  options.session_timeout = std::chrono::milliseconds(10);
  World soon(options);
  Client first(soon.link, "feeder", {}, soon.clock);
  ASSERT_TRUE(first.enable().ok());
  ASSERT_NE(soon.executor->pump.receiver().session(), 0);
  const CallOutcome after = execute_command(
      soon.link, "feeder", command::MoveVelocity{.velocity = 5, .hold_to_run = true},
      {.cancelled = [] { return true; }}, soon.clock);
  EXPECT_TRUE(after.ok()) << after.reason;

  World owned;
  Client streamer(owned.link, "feeder", {}, owned.clock);
  ASSERT_TRUE(streamer.enable().ok());
  const CallOutcome busy = execute_command(
      owned.link, "feeder", command::MoveVelocity{.velocity = 5, .hold_to_run = true},
      {.cancelled = [] { return true; }}, owned.clock);
  EXPECT_EQ(busy.refusal, Refusal::busy) << "but not for a program that keeps the axis";
}

TEST(Operate, ARejectedJogHasNotBegun) {
  World world;
  world.executor->objection = "not_enabled";
  bool begun = false;
  const CallOutcome outcome = execute_command(
      world.link, "feeder", command::MoveVelocity{.velocity = 5, .hold_to_run = true},
      {.held = [&] { begun = true; }}, world.clock);
  EXPECT_EQ(outcome.error, StreamError::refused);
  EXPECT_FALSE(begun);
}

TEST(Operate, SendsAnyOtherCommandOnce) {
  World world;
  const CallOutcome outcome =
      execute_command(world.link, "feeder", command::Enable{}, {}, world.clock);
  EXPECT_TRUE(outcome.ok()) << outcome.reason;
}

/// The executor publishes a status in each millisecond of the world.
void publish(World& world) {
  world.each_turn = [&world] {
    world.executor->pump.publish(
        {.state = State::standstill, .tick = world.now.count() / 1'000'000, .cycle_ns = 1'000'000});
  };
}

TEST(Operate, StopsAndWaitsForRest) {
  World world;
  EXPECT_FALSE(stop_axis(world.link, "feeder", wire::StopMode::stop, std::chrono::milliseconds(5),
                         {}, world.clock)
                   .rest)
      << "no status arrives";
  publish(world);
  const StopResult result = stop_axis(world.link, "feeder", wire::StopMode::stop,
                                      std::chrono::seconds(1), {}, world.clock);
  EXPECT_TRUE(result.confirmed);
  EXPECT_EQ(result.rest, State::standstill);
}

/// An axis that moves until a time of the world, then rests for this cause.
struct Moving {
  explicit Moving(Nanos end, Cause cause = Cause::none) : end(end), cause(cause) {
    world.each_turn = [this] {
      wire::Status status{.state = State::discrete_motion, .slave_velocity = 5};
      if (world.now >= this->end)
        status = {.state = State::standstill,
                  .slave_position = 39.7,
                  .reason = static_cast<std::int32_t>(this->cause)};
      status.units = {"s", "mm"};
      if (sends) world.executor->pump.publish(status);
    };
    EXPECT_TRUE(client.command(command::MoveRelative{.distance = 50}).ok());
  }

  RestOutcome rest(const RestOptions& options = {}) {
    return await_rest(world.link, "feeder", client, options, world.clock);
  }

  World world;
  Client client{world.link, "feeder", {}, world.clock};
  Nanos end;
  Cause cause;
  bool sends = true;
};

TEST(Rest, IsTheEndOfTheMotionAndKeepsTheSession) {
  Moving axis(std::chrono::seconds(5));
  const auto session = axis.client.session();
  const RestOutcome rest = axis.rest();
  EXPECT_TRUE(rest.ok()) << rest.reason;
  EXPECT_EQ(rest.state, State::standstill);
  EXPECT_EQ(rest.position, 39.7);
  EXPECT_EQ(axis.world.executor->pump.receiver().session(), session);
}

TEST(Rest, OfAMotionThatWasCutShortIsAnError) {
  Moving axis(std::chrono::seconds(1), Cause::following_error);
  const RestOutcome rest = axis.rest();
  EXPECT_EQ(rest.error, StreamError::stopped);
  EXPECT_EQ(rest.cause, static_cast<std::int32_t>(Cause::following_error));
  EXPECT_THAT(rest.reason,
              testing::StartsWith("the motion ended early, at 39.7 mm: following_error"));
  EXPECT_TRUE(axis.rest().ok()) << "reported once";
}

TEST(Rest, AfterAStopByAnOperatorIsAnErrorOnce) {
  for (const auto later : {std::chrono::milliseconds(0), std::chrono::milliseconds(700)}) {
    Moving axis(std::chrono::seconds(1), Cause::stopped);
    ASSERT_TRUE(operator_stop(axis.world.link, "feeder", wire::StopMode::stop,
                              std::chrono::seconds(1), {}, axis.world.clock));
    axis.end = axis.world.now + later;
    axis.world.pass(later);
    const RestOutcome rest = axis.rest();
    EXPECT_EQ(rest.error, StreamError::stopped);
    EXPECT_EQ(rest.reason, "another operator stopped the axis; the axis rests at 39.7 mm");
    EXPECT_TRUE(axis.client.beat().ok()) << "reported already";
  }
}

TEST(Rest, AfterTheSessionEndedAtRestIsNotAnError) {
  Moving axis(std::chrono::milliseconds(100));
  axis.world.pass(std::chrono::seconds(5));
  EXPECT_EQ(axis.world.executor->pump.receiver().session(), 0);
  const RestOutcome rest = axis.rest();
  EXPECT_TRUE(rest.ok()) << rest.reason;
}

TEST(Rest, IsNotAwaitedFromAnExecutorThatSendsNothing) {
  Moving axis(std::chrono::seconds(100));
  axis.sends = false;
  const Nanos begin = axis.world.now;
  const RestOutcome lost = axis.rest();
  EXPECT_EQ(lost.error, StreamError::contact_lost);
  EXPECT_EQ(lost.reason, "no status of feeder for 2000 ms");
  EXPECT_LT(axis.world.now - begin, std::chrono::seconds(3));
}

TEST(Rest, IsAwaitedUntilTheTimeIsOver) {
  Moving axis(std::chrono::seconds(100));
  const RestOutcome late = axis.rest({.patience = std::chrono::milliseconds(1500)});
  EXPECT_EQ(late.error, StreamError::out_of_time);
  EXPECT_EQ(late.reason, "not at rest within 1.5 s");
  EXPECT_FALSE(late.state);
}

TEST(Rest, IsAwaitedAfterTheStopOfACancelledWait) {
  Moving axis(std::chrono::seconds(2));
  int asked = 0;
  const RestOutcome rest = axis.rest({.cancelled = [&] { return ++asked == 3; }});
  EXPECT_EQ(rest.error, StreamError::stopped);
  EXPECT_EQ(rest.reason, "the wait was cancelled; the axis rests at 39.7 mm");
  EXPECT_EQ(axis.world.executor->log.back(), "stop " + std::to_string(axis.client.session()));
}

TEST(Operate, CountsTicksFromTheStatus) {
  World world;
  EXPECT_FALSE(tick_after(world.link, "feeder", 0, {}, world.clock)) << "no status arrives";
  publish(world);
  const std::int64_t now = world.now.count() / 1'000'000;
  const auto tick = tick_after(world.link, "feeder", 2.5, {}, world.clock);
  ASSERT_TRUE(tick);
  EXPECT_GE(*tick, now + 2500) << "cycles of 1 ms";
  EXPECT_LE(*tick, now + 2510);
}

}  // namespace
}  // namespace jounce::operate_test
