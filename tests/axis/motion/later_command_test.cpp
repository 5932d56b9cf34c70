// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/later_command.hpp"

#include <gtest/gtest.h>

#include "axis/model/model_movements.hpp"

namespace jounce::later_command_test {
namespace {

using namespace test;

const Command hold_at_50{.what = command::Hold{}, .at = 50};

TEST(LaterCommand, ComesDueOnceInItsTick) {
  LaterCommand later;
  EXPECT_FALSE(later.postpone(hold_at_50, 10));
  EXPECT_TRUE(later.waits());
  EXPECT_EQ(later.tick(), 50);
  EXPECT_FALSE(later.take_due(49));
  const auto due = later.take_due(50);
  ASSERT_TRUE(due);
  EXPECT_EQ(due->kind(), CommandKind::hold);
  EXPECT_EQ(due->at, -1);
  EXPECT_FALSE(later.waits());
  EXPECT_FALSE(later.take_due(51));
}

TEST(LaterCommand, ComesDueAfterSkippedTicks) {
  LaterCommand later;
  later.postpone(hold_at_50, 10);
  EXPECT_TRUE(later.take_due(53));
}

TEST(LaterCommand, AtMostOneWaits) {
  LaterCommand later;
  later.postpone(hold_at_50, 10);
  const auto no = later.postpone({.what = command::Resume{}, .at = 60}, 10);
  ASSERT_TRUE(no);
  EXPECT_EQ(no->cause, Cause::buffer_full);
  EXPECT_EQ(no->limit, 50);
  EXPECT_EQ(later.take_due(50)->kind(), CommandKind::hold);
}

TEST(LaterCommand, RejectsThePastAndMovements) {
  LaterCommand later;
  EXPECT_EQ(later.postpone(hold_at_50, 51)->cause, Cause::too_late);
  Gear gear(1, 1);
  EXPECT_EQ(later.postpone({.what = command::Arm{.movement = &gear}, .at = 50}, 10)->cause,
            Cause::no_value);
  EXPECT_FALSE(later.waits());
}

TEST(LaterCommand, ADroppedCommandIsReportedOnce) {
  LaterCommand later;
  EXPECT_FALSE(later.forget());
  later.postpone(hold_at_50, 10);
  const auto why = later.forget();
  ASSERT_TRUE(why);
  EXPECT_EQ(why->cause, Cause::replaced);
  EXPECT_EQ(why->value, 50);
  EXPECT_FALSE(later.forget());
  EXPECT_EQ(later.tick(), -1);
}

}  // namespace
}  // namespace jounce::later_command_test
