// SPDX-License-Identifier: Apache-2.0
#include "jounce/stream/sender/operate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/stream/sender/banks.hpp"

#include "stream/rows.hpp"

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

}  // namespace
}  // namespace jounce::operate_test
