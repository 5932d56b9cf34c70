// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/armed_motion.hpp"

#include <utility>

#include <gtest/gtest.h>

#include "axis/model/model_movements.hpp"

namespace jounce::armed_motion_test {
namespace {

using namespace test;

TEST(ArmedMotion, IsEmptyThenArmedThenWaits) {
  Gear gear(7, 1);
  ArmedMotion armed;
  EXPECT_FALSE(armed);
  EXPECT_FALSE(armed.waiting());
  armed.arm(&gear, 42);
  ASSERT_TRUE(armed);
  EXPECT_EQ(armed->id(), 7U);
  EXPECT_EQ(armed.group(), 42);
  EXPECT_TRUE(armed.is_live());
  EXPECT_FALSE(armed.waiting());
  EXPECT_FALSE(armed.accepted_in(10));
  armed.accept(StartAt::tick, 1600, 0, 10);
  EXPECT_TRUE(armed.waiting());
  EXPECT_TRUE(armed.accepted_in(10));
  EXPECT_FALSE(armed.accepted_in(11));
  EXPECT_EQ(armed.tick_or(-1), 1600);
}

TEST(ArmedMotion, AStartAtAnEventHasNoTick) {
  Gear gear(7, 1);
  ArmedMotion armed;
  armed.arm(&gear, 0);
  armed.accept(StartAt::master_position, 0, 460, 10);
  EXPECT_EQ(armed.tick_or(-1), -1);
  EXPECT_EQ(armed.position(), 460);
  EXPECT_EQ(armed.when(), StartAt::master_position);
}

TEST(ArmedMotion, AnArmReplacesTheStartOfTheOneBefore) {
  Gear gear(7, 1), other(8, 1);
  ArmedMotion armed;
  armed.arm(&gear, 42);
  armed.accept(StartAt::end_of_table, 0, 0, 10);
  armed.arm(&other, 0);
  EXPECT_EQ(armed->id(), 8U);
  EXPECT_EQ(armed.group(), 0);
  EXPECT_FALSE(armed.waiting());
  EXPECT_FALSE(armed.accepted_in(10));
  EXPECT_EQ(armed.when(), StartAt::tick);
}

TEST(ArmedMotion, IsEmptyOnceItBegins) {
  Gear gear(7, 1);
  ArmedMotion armed;
  armed.arm(&gear, 42);
  armed.accept(StartAt::tick, 5, 0, 5);
  const ArmedMotion begun = std::exchange(armed, {});
  EXPECT_FALSE(armed);
  EXPECT_FALSE(armed.waiting());
  EXPECT_EQ(begun.movement(), &gear);
  EXPECT_EQ(begun.group(), 42);
  EXPECT_EQ(begun.tick_or(9), 5);
}

}  // namespace
}  // namespace jounce::armed_motion_test
