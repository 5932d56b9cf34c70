// SPDX-License-Identifier: Apache-2.0
#include "stream/src/receiver/last_command.hpp"

#include <gtest/gtest.h>

namespace jounce::last_command_test {
namespace {

using Kind = LastCommand::Kind;
using wire::Outcome;

constexpr std::int64_t boot = 5;

TEST(LastCommand, NumbersTheCommandsOfAStreamerAlone) {
  EXPECT_EQ(command_number(wire::Start{.command = 3}), 3);
  EXPECT_EQ(command_number(wire::Heartbeat{.command = 4}), 4);
  EXPECT_EQ(command_number(wire::Header{}), 0);
  EXPECT_EQ(command_number(wire::Reply{.command = 3}), 0) << "from an executor";
}

TEST(LastCommand, TakesAscendingNumbers) {
  LastCommand record(boot);
  EXPECT_EQ(record.number(), 0);
  EXPECT_TRUE(record.begin(Kind::arm, 2));
  EXPECT_TRUE(record.begin(Kind::start, 4));
  EXPECT_FALSE(record.begin(Kind::stop, 3)) << "older";
  EXPECT_EQ(record.number(), 4);
  EXPECT_EQ(record.kind(), Kind::start);
}

TEST(LastCommand, RepeatsTheReplyOfARepeatedCommandOnly) {
  LastCommand record(boot);
  EXPECT_FALSE(record.take_reply());
  record.begin(Kind::arm, 2);
  auto reply = record.take_reply();
  ASSERT_TRUE(reply);
  EXPECT_EQ(reply->boot, boot);
  EXPECT_EQ(reply->command, 2);
  EXPECT_EQ(reply->outcome, Outcome::pending);
  EXPECT_FALSE(record.take_reply()) << "once";
  EXPECT_FALSE(record.begin(Kind::arm, 1));
  EXPECT_FALSE(record.take_reply()) << "an older command gets none";
  record.settle({});
  EXPECT_EQ(record.take_reply().value().outcome, Outcome::accepted);
  EXPECT_FALSE(record.begin(Kind::arm, 2));
  EXPECT_EQ(record.take_reply().value().outcome, Outcome::accepted) << "the recorded outcome";
}

TEST(LastCommand, WaitsForOneOutcome) {
  LastCommand record(boot);
  EXPECT_FALSE(record.waits(0)) << "no command";
  record.begin(Kind::arm, 2);
  EXPECT_TRUE(record.waits(2));
  EXPECT_FALSE(record.waits(1));
  record.settle({wire::Refusal::axis, "start_position", 41});
  EXPECT_FALSE(record.waits(2));
  const auto reply = record.take_reply().value();
  EXPECT_EQ(reply.outcome, Outcome::refused);
  EXPECT_EQ(reply.cause, 41);
  EXPECT_EQ(reply.reason, "start_position");
}

TEST(LastCommand, ANewCommandHasNothingOfTheOneBefore) {
  LastCommand record(boot);
  record.begin(Kind::command, 1);
  record.keep(command::Hold{});
  record.settle({wire::Refusal::axis, "moves", 41});
  record.begin(Kind::start, 2);
  EXPECT_FALSE(record.what());
  const auto reply = record.take_reply().value();
  EXPECT_EQ(reply.outcome, Outcome::pending);
  EXPECT_EQ(reply.refusal, wire::Refusal::none);
  EXPECT_EQ(reply.cause, 0);
  EXPECT_EQ(reply.reason, "");
}

TEST(LastCommand, OnlyNewOrWaitingCommandsProveThatTheSenderIsAlive) {
  LastCommand record(boot);
  EXPECT_TRUE(record.is_news(0)) << "a table, before the first command";
  record.begin(Kind::arm, 2);
  EXPECT_FALSE(record.is_news(0));
  EXPECT_FALSE(record.is_news(1));
  EXPECT_TRUE(record.is_news(2)) << "it waits for its outcome";
  record.settle({});
  EXPECT_FALSE(record.is_news(2));
  EXPECT_TRUE(record.is_news(3));
}

TEST(LastCommand, ForgetsForTheNextSession) {
  LastCommand record(boot);
  record.begin(Kind::arm, 9);
  record.clear();
  EXPECT_EQ(record.number(), 0);
  EXPECT_FALSE(record.take_reply());
  EXPECT_TRUE(record.begin(Kind::arm, 1));
  EXPECT_EQ(record.take_reply().value().boot, boot);
}

TEST(LastCommand, ReplacesByALowerNumberOfAnotherSender) {
  LastCommand record(boot);
  record.replace(Kind::stop, 9);
  record.settle({});
  record.replace(Kind::command, 1);
  EXPECT_TRUE(record.waits(1));
}

}  // namespace
}  // namespace jounce::last_command_test
