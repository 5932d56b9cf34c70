// SPDX-License-Identifier: Apache-2.0
#include "executor/src/server/movement_builder.hpp"

#include <chrono>
#include <memory>
#include <thread>

#include <gtest/gtest.h>

#include "axis/tables.hpp"

namespace jounce::movement_builder_test {
namespace {

using namespace test;

/// The arm of a table of three knots.
ArmRequested arm(std::int32_t command) {
  ArmRequested arm{.session = 3, .command = command, .slave = {}, .master = {}};
  arm.slave.table = there_and_back(0, 10, 1, Extrapolation::hold);
  return arm;
}

constexpr std::int64_t period = 1'000'000;

/// Waits for the worker, for 10 s at most.
std::optional<MovementBuilder::Done> result(MovementBuilder& builder) {
  using namespace std::chrono_literals;
  for (int i = 0; i < 10'000; ++i) {
    if (auto done = builder.take()) return done;
    std::this_thread::sleep_for(1ms);
  }
  return std::nullopt;
}

TEST(MovementBuilder, ASmallTableIsBuiltAtOnce) {
  Worker worker;
  MovementBuilder builder(worker, 3);
  const auto built = builder.build(arm(12), 7, period, 0);
  ASSERT_TRUE(built);
  EXPECT_EQ(built->arm.command, 12);
  ASSERT_TRUE(built->made.movement);
  EXPECT_EQ(built->made.movement->id(), 7U);
  EXPECT_FALSE(builder.busy());
  EXPECT_FALSE(builder.take());
}

TEST(MovementBuilder, ALargeTableIsBuiltByTheWorker) {
  Worker worker;
  MovementBuilder builder(worker, 2);
  EXPECT_FALSE(builder.build(arm(12), 7, period, 0));
  EXPECT_TRUE(builder.busy());
  const auto done = result(builder);
  ASSERT_TRUE(done && done->built);
  EXPECT_EQ(done->built->arm.command, 12);
  EXPECT_EQ(done->built->made.movement->id(), 7U);
  EXPECT_FALSE(done->next);
  EXPECT_FALSE(builder.busy());
}

TEST(MovementBuilder, TheNewestArmWaitsForTheBuild) {
  Worker worker;
  MovementBuilder builder(worker, 2);
  EXPECT_FALSE(builder.build(arm(12), 7, period, 0));
  builder.wait(arm(13));
  builder.wait(arm(14));
  const auto done = result(builder);
  ASSERT_TRUE(done && done->built && done->next);
  EXPECT_EQ(done->built->arm.command, 12);
  EXPECT_EQ(done->next->command, 14);
  EXPECT_FALSE(builder.take()) << "it returns each of them once";
}

TEST(MovementBuilder, ACanceledBuildReturnsNothingButItsEnd) {
  Worker worker;
  MovementBuilder builder(worker, 2);
  EXPECT_FALSE(builder.build(arm(12), 7, period, 0));
  builder.wait(arm(13));
  builder.cancel();
  EXPECT_TRUE(builder.busy()) << "the worker still has it";
  builder.wait(arm(14));
  const auto done = result(builder);
  ASSERT_TRUE(done);
  EXPECT_FALSE(done->built);
  ASSERT_TRUE(done->next);
  EXPECT_EQ(done->next->command, 14);
}

}  // namespace
}  // namespace jounce::movement_builder_test
