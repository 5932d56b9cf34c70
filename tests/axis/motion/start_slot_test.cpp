// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/start_slot.hpp"

#include <gtest/gtest.h>

#include "axis/model/model_movements.hpp"

namespace jounce::start_slot_test {
namespace {

using namespace test;

using Groups = std::array<std::int64_t, 2>;

TEST(StartSlot, AMovementThatBeginsLeavesTheSlotAndSetsTheGroup) {
  Gear gear(7, 1);
  StartSlot slot;
  slot.arm(gear, 42, 10);
  EXPECT_EQ(slot.waiting(), nullptr) << "its start was not accepted";
  slot.accept(StartAt::tick, 15, 0, 10);
  EXPECT_EQ(slot.waiting(), &gear);
  EXPECT_EQ(slot.group(), 0) << "its group does not move yet";
  const ArmedMotion begun = slot.take();
  EXPECT_EQ(begun.movement(), &gear);
  EXPECT_EQ(slot.group(), 42);
  EXPECT_FALSE(slot.armed());
  EXPECT_EQ(slot.empty(11), nullptr) << "it leaves once";
  EXPECT_EQ(slot.broken(), (Groups{0, 0}));
}

TEST(StartSlot, ADroppedMovementBreaksItsGroup) {
  Gear gear(7, 1);
  StartSlot slot;
  slot.arm(gear, 42, 10);
  EXPECT_EQ(slot.empty(11), &gear);
  EXPECT_EQ(slot.empty(11), nullptr);
  EXPECT_EQ(slot.broken(), (Groups{0, 42}));
  slot.arm(gear, 42, 12);
  EXPECT_EQ(slot.broken(), (Groups{0, 0}));
}

TEST(StartSlot, AMotionThatEndsEarlyBreaksItsOwnGroup) {
  Gear gear(7, 1), other(8, 1);
  StartSlot slot;
  slot.arm(gear, 42, 10);
  (void)slot.take();
  slot.arm(other, 43, 11);
  slot.break_motion(12);
  EXPECT_EQ(slot.broken(), (Groups{42, 0}));
  slot.reject_start(44, 12);
  EXPECT_EQ(slot.broken(), (Groups{42, 44}));
}

TEST(StartSlot, TheOtherAxesReadOnlyTheStartOfAGroup) {
  Gear gear(7, 1);
  StartSlot slot;
  slot.arm(gear, 0, 10);
  slot.accept(StartAt::tick, 15, 0, 10);
  EXPECT_EQ(slot.next().group, 0);
  EXPECT_FALSE(slot.next().accepted);
  EXPECT_EQ(slot.empty(10), &gear);
  slot.arm(gear, 42, 10);
  EXPECT_EQ(slot.next().group, 42);
  EXPECT_FALSE(slot.next().accepted);
  slot.accept(StartAt::tick, 15, 0, 10);
  EXPECT_TRUE(slot.next().accepted);
  EXPECT_EQ(slot.next().tick, 15);
}

}  // namespace
}  // namespace jounce::start_slot_test
