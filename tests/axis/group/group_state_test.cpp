// SPDX-License-Identifier: Apache-2.0
#include "axis/src/group/group_state.hpp"

#include <gtest/gtest.h>

namespace jounce::group_state_test {
namespace {

using Groups = std::array<std::int64_t, 2>;

TEST(GroupState, ABreakStaysUntilTheGroupIsArmedAgain) {
  GroupState groups;
  EXPECT_EQ(groups.broken(), (Groups{0, 0}));
  groups.break_motion(42, 10);
  groups.break_armed(43, false, 10);
  EXPECT_EQ(groups.broken(), (Groups{42, 43}));
  groups.join(44, 11);
  EXPECT_EQ(groups.broken(), (Groups{42, 43}));
  groups.join(42, 11);
  EXPECT_EQ(groups.broken(), (Groups{0, 43}));
}

TEST(GroupState, ABreakOfThisTickStays) {
  GroupState groups;
  groups.break_motion(42, 10);
  groups.join(42, 10);
  EXPECT_EQ(groups.broken(), (Groups{42, 0}));
  groups.break_armed(42, true, 11);
  groups.join(42, 11);
  EXPECT_EQ(groups.broken(), (Groups{42, 42}));
  groups.join(42, 12);
  EXPECT_EQ(groups.broken(), (Groups{0, 0}));
}

TEST(GroupState, AnArmedMovementWithoutAStartOrAGroupBreaksNothingForOthers) {
  GroupState groups;
  groups.break_armed(42, false, 10);
  groups.join(42, 10);
  EXPECT_EQ(groups.broken(), (Groups{0, 0}));
  groups.break_armed(0, true, 10);
  EXPECT_EQ(groups.broken(), (Groups{0, 0}));
}

}  // namespace
}  // namespace jounce::group_state_test
