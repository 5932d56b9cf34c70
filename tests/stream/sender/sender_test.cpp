// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/detail/sender.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "stream/harness.hpp"

namespace jounce::sender_test {
namespace {

using namespace std::chrono_literals;
using testing::IsEmpty;
using wire::Refusal;

/// A sender in session 1 whose executor is played by the test.
class SenderTest : public testing::Test {
 protected:
  void hear(wire::Body body) { sender.receive({"feeder", 1, std::move(body)}, now); }
  void hear_ack(std::uint32_t next, bool complete = false) {
    hear(wire::Ack{.boot = 5, .next = next, .credit = 8, .complete = complete});
  }
  void hear_reply(std::int32_t command, wire::Outcome outcome = wire::Outcome::accepted) {
    hear(wire::Reply{.boot = 5, .command = command, .outcome = outcome});
  }

  /// The only message of a poll.
  template <class Body>
  Body says() {
    const auto messages = sender.poll(now);
    EXPECT_EQ(messages.size(), 1U);
    if (messages.size() != 1) return {};
    const auto* const body = std::get_if<Body>(&messages[0].body);
    EXPECT_NE(body, nullptr) << "kind " << messages[0].body.index();
    return body != nullptr ? *body : Body{};
  }

  Nanos now{};
  Table table = test::sine_table(1000);
  Sender sender{test::plan_of(table), 1, {.pace = {.chunk = 1600}}};
};

TEST_F(SenderTest, AnnouncesSendsArmsStartsHoldsReleases) {
  const auto header = says<wire::Header>();
  EXPECT_EQ(header.knots, 1000U);
  EXPECT_EQ(header.chunks, 2U);
  EXPECT_EQ(header.hash, content_hash(table, test::move_units));
  hear_ack(0);
  EXPECT_EQ(sender.poll(now).size(), 2U);
  hear_ack(2, true);
  const auto arm = says<wire::Arm>();
  EXPECT_EQ(arm.command, 1);
  EXPECT_EQ(arm.slave, header.hash);
  hear_reply(1);
  EXPECT_EQ(says<wire::Start>().command, 2);
  EXPECT_FALSE(sender.outcome().started);
  hear_reply(2);
  EXPECT_TRUE(sender.outcome().started);
  EXPECT_TRUE(sender.at_goal());
  EXPECT_THAT(sender.poll(now), IsEmpty());
  now += 100ms;
  EXPECT_FALSE(says<wire::Heartbeat>().release);
  hear_reply(3);
  sender.release();
  EXPECT_TRUE(says<wire::Heartbeat>().release);
  EXPECT_FALSE(sender.ended());
  hear_reply(4);
  EXPECT_TRUE(sender.ended());
  EXPECT_TRUE(sender.outcome().ok());
  EXPECT_THAT(sender.poll(now), IsEmpty());
}

TEST_F(SenderTest, StopsAtItsGoalUntilItIsRaised) {
  Sender careful(test::plan_of(table, StreamGoal::download), 1);
  static_cast<void>(careful.poll(now));
  careful.receive({"feeder", 1, wire::Ack{.boot = 5, .next = 2, .complete = true}}, now);
  EXPECT_TRUE(careful.at_goal());
  EXPECT_TRUE(careful.outcome().downloaded);
  EXPECT_THAT(careful.poll(now), IsEmpty());
  careful.raise(StreamGoal::arm);
  EXPECT_FALSE(careful.at_goal());
  const auto messages = careful.poll(now);
  ASSERT_EQ(messages.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<wire::Arm>(messages[0].body));
}

TEST_F(SenderTest, RepeatsWhatIsNotAnswered) {
  static_cast<void>(says<wire::Header>());
  now += 19ms;
  EXPECT_THAT(sender.poll(now), IsEmpty());
  now += 1ms;
  static_cast<void>(says<wire::Header>());
  hear_ack(2, true);
  EXPECT_EQ(says<wire::Arm>().command, 1);
  now += 20ms;
  EXPECT_EQ(says<wire::Arm>().command, 1) << "the same number";
  hear_reply(1, wire::Outcome::pending);
  now += 20ms;
  EXPECT_EQ(says<wire::Arm>().command, 1);
}

TEST_F(SenderTest, ShowsASignOfLifeWhereChunksMayNotFlow) {
  static_cast<void>(says<wire::Header>());
  hear(wire::Ack{.boot = 5, .credit = 0});
  now += 99ms;
  EXPECT_THAT(sender.poll(now), IsEmpty());
  now += 1ms;
  static_cast<void>(says<wire::Header>());
}

TEST_F(SenderTest, ReportsThatNoExecutorAnswers) {
  static_cast<void>(sender.poll(now));
  now += 5s;
  static_cast<void>(sender.poll(now));
  EXPECT_FALSE(sender.ended());
  now += 1ns;
  EXPECT_THAT(sender.poll(now), IsEmpty()) << "no farewell without a receiver";
  EXPECT_EQ(sender.outcome().error, StreamError::no_answer);
  EXPECT_EQ(sender.outcome().reason, "no answer from feeder for 5000 ms");
}

TEST_F(SenderTest, ReportsALostContact) {
  static_cast<void>(sender.poll(now));
  now += 4s;
  hear_ack(0);
  now += 5s + 1ns;
  EXPECT_TRUE(says<wire::Heartbeat>().release) << "its farewell";
  EXPECT_EQ(sender.outcome().error, StreamError::contact_lost);
}

TEST_F(SenderTest, ReportsThatNoChunkArrives) {
  static_cast<void>(sender.poll(now));
  for (int i = 0; i < 101 && !sender.ended(); ++i) {
    hear_ack(0);
    now += 100ms;
    static_cast<void>(sender.poll(now));
  }
  EXPECT_EQ(sender.outcome().error, StreamError::stalled);
}

TEST_F(SenderTest, StopsWhatMayHaveStarted) {
  static_cast<void>(sender.poll(now));
  hear_ack(2, true);
  static_cast<void>(sender.poll(now));
  hear_reply(1);
  EXPECT_EQ(says<wire::Start>().command, 2);
  for (int i = 0; i < 51; ++i) {
    now += 100ms;
    hear_reply(2, wire::Outcome::pending);
  }
  // Its farewell: the motion stops, and the axis is free for the next streamer. Any of it may be lost.
  for (int i = 0; i < 5; ++i, now += 20ms) {
    const auto messages = sender.poll(now);
    ASSERT_EQ(messages.size(), 2U);
    EXPECT_EQ(std::get<wire::Stop>(messages[0].body).command, 3);
    const auto release = std::get<wire::Heartbeat>(messages[1].body);
    EXPECT_EQ(release.command, 4);
    EXPECT_TRUE(release.release);
    EXPECT_EQ(sender.done(), i == 4);
  }
  EXPECT_THAT(sender.poll(now), IsEmpty());
  EXPECT_EQ(sender.outcome().error, StreamError::command_timeout);
  EXPECT_FALSE(sender.outcome().started);
}

TEST_F(SenderTest, EndsItsFarewellWhereTheEndOfItsSessionIsAnswered) {
  static_cast<void>(sender.poll(now));
  hear(wire::Ack{.boot = 5, .refusal = Refusal::too_large, .reason = "at most 500 knots"});
  EXPECT_TRUE(says<wire::Heartbeat>().release);
  EXPECT_FALSE(sender.done());
  hear_reply(1);
  EXPECT_TRUE(sender.done());
  now += 1s;
  EXPECT_THAT(sender.poll(now), IsEmpty());
}

TEST_F(SenderTest, ReportsARejectionByName) {
  static_cast<void>(sender.poll(now));
  hear(wire::Ack{.boot = 5, .refusal = Refusal::too_large, .reason = "at most 500 knots"});
  EXPECT_EQ(sender.outcome().error, StreamError::refused);
  EXPECT_EQ(sender.outcome().refusal, Refusal::too_large);
  EXPECT_EQ(sender.outcome().reason, "too_large: at most 500 knots");
}

TEST_F(SenderTest, ReportsAStopOfAnOperatorDuringTheMotion) {
  static_cast<void>(sender.poll(now));
  hear_ack(2, true);
  static_cast<void>(sender.poll(now));
  hear_reply(1);
  static_cast<void>(sender.poll(now));
  hear_reply(2);
  ASSERT_TRUE(sender.outcome().started);
  now += 100ms;
  static_cast<void>(says<wire::Heartbeat>());
  hear(wire::Reply{.boot = 5,
                   .command = 3,
                   .outcome = wire::Outcome::refused,
                   .refusal = Refusal::session_ended});
  EXPECT_EQ(sender.outcome().error, StreamError::stopped);
  EXPECT_EQ(sender.outcome().reason,
            "the executor ended the session: an operator stopped the axis, or heartbeats were "
            "missing");
}

TEST_F(SenderTest, IgnoresWhatIsNotForIt) {
  static_cast<void>(sender.poll(now));
  const wire::Ack no{.boot = 5, .refusal = Refusal::busy};
  sender.receive({"feeder", 2, no}, now);
  sender.receive({"cutter", 1, no}, now);
  hear(wire::Ack{.boot = 5, .table = 1, .refusal = Refusal::busy});
  hear(wire::Reply{.boot = 5, .command = 1, .outcome = wire::Outcome::accepted});
  hear(wire::Stop{.command = 1});
  EXPECT_FALSE(sender.ended());
  EXPECT_FALSE(sender.outcome().armed);
}

TEST_F(SenderTest, BeginsAnewWhereTheExecutorHasRestarted) {
  static_cast<void>(says<wire::Header>());
  hear_ack(0);
  EXPECT_EQ(sender.poll(now).size(), 2U);
  hear_ack(1);
  EXPECT_EQ(sender.outcome().progress.arrived, 1U);
  hear(wire::Ack{.boot = 6, .refusal = Refusal::unknown_session});
  EXPECT_EQ(sender.outcome().progress.arrived, 0U);
  static_cast<void>(says<wire::Header>());
  hear_ack(2, true);  // from before the restart
  EXPECT_FALSE(sender.outcome().downloaded);
  hear(wire::Ack{.boot = 6, .credit = 8});
  EXPECT_EQ(sender.poll(now).size(), 2U) << "both chunks again";
}

TEST_F(SenderTest, GivesUpWhereTheExecutorRestartsLater) {
  static_cast<void>(sender.poll(now));
  hear_ack(2, true);
  static_cast<void>(sender.poll(now));
  hear(wire::Reply{.boot = 6, .command = 1, .outcome = wire::Outcome::accepted});
  EXPECT_EQ(sender.outcome().error, StreamError::restarted);
  EXPECT_FALSE(sender.outcome().armed);
}

TEST_F(SenderTest, StopTakesTheGoalBack) {
  static_cast<void>(sender.poll(now));
  hear_ack(2, true);
  EXPECT_EQ(says<wire::Arm>().command, 1);
  sender.stop(wire::StopMode::abort);
  const auto stop = says<wire::Stop>();
  EXPECT_EQ(stop.command, 2);
  EXPECT_EQ(stop.mode, wire::StopMode::abort);
  hear_reply(1);
  EXPECT_FALSE(sender.at_goal()) << "the arm's outcome does not count any more";
  hear_reply(2);
  EXPECT_TRUE(sender.at_goal());
  EXPECT_TRUE(sender.outcome().stopped);
  EXPECT_FALSE(sender.outcome().started);
  sender.raise(StreamGoal::start);
  EXPECT_TRUE(sender.at_goal()) << "what was stopped stays stopped";
}

TEST_F(SenderTest, LeavesADownloadWithoutStoppingTheAxis) {
  static_cast<void>(sender.poll(now));
  hear_ack(0);
  sender.stop(wire::StopMode::stop);
  EXPECT_TRUE(says<wire::Heartbeat>().release);
}

TEST_F(SenderTest, DoesNotWaitForEverToBeReleased) {
  static_cast<void>(sender.poll(now));
  hear_ack(0);
  sender.release();
  static_cast<void>(sender.poll(now));
  now += 5s + 1ns;
  static_cast<void>(sender.poll(now));
  EXPECT_TRUE(sender.ended());
  EXPECT_TRUE(sender.outcome().ok());
  EXPECT_EQ(sender.outcome().reason, "the executor did not confirm the release");
}

TEST_F(SenderTest, RejectsAPlanThatCannotBeSentOrArmed) {
  const auto refuses = [&](auto change, SenderOptions options = {}) {
    StreamPlan plan = test::plan_of(table);
    change(plan);
    try {
      Sender refused(plan, 1, options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  EXPECT_EQ(refuses([](StreamPlan& /*as it is*/) {}), "nothing");
  EXPECT_EQ(refuses([](StreamPlan& p) { p.executor = "my axis"; }),
            "executor = my axis: must have 1 to 23 characters, each a letter A-Z or a-z, a digit, "
            "_ or -");
  EXPECT_EQ(refuses([](StreamPlan& p) { p.tables.clear(); }), "tables = 0: must be 1 to 64");
  EXPECT_EQ(refuses([](StreamPlan& p) { p.tables[0].units.position = "millimillimeters"; }),
            "unit of position = millimillimeters: must be shorter than 16 bytes");
  EXPECT_EQ(
      refuses([](StreamPlan& p) { p.mode = wire::ArmMode::follow_table; }),
      "table: the table of the axis is over time, but it must be over the position of a master");
  EXPECT_EQ(refuses([](StreamPlan& p) { p.tables[0].units.x = "ms"; }),
            "table: the slave table is over ms, must be over s");
  EXPECT_EQ(refuses([](StreamPlan& p) { p.start_tick = -2; }),
            "start_tick = -2: must be -1 or more");
  EXPECT_EQ(refuses([](StreamPlan& /*as it is*/) {}, {.pace = {.window = 65}}),
            "window = 65: must be 1 to 64");
}

TEST_F(SenderTest, NamesEachErrorAndStage) {
  EXPECT_STREQ(name(StreamError::refused), "refused");
  EXPECT_STREQ(name(StreamError::none), "none");
  EXPECT_STREQ(name(StreamStage::downloading), "downloading");
  EXPECT_STREQ(name(StreamStage::failed), "failed");
}

}  // namespace
}  // namespace jounce::sender_test
