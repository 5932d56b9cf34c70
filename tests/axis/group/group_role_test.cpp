// SPDX-License-Identifier: Apache-2.0
#include "axis/src/group/group_role.hpp"

#include <gtest/gtest.h>

namespace jounce::group_role_test {
namespace {

TEST(GroupRole, AnAxisAloneAcceptsEveryKind) {
  EXPECT_EQ(against_role(Peers::ready, CommandKind::move_absolute), Cause::none);
  EXPECT_EQ(against_role(Peers::missing, CommandKind::extend), Cause::none);
}

TEST(GroupRole, AnAxisOfAnEnabledGroupAcceptsNoMotion) {
  EXPECT_EQ(against_role(Peers::grouped, CommandKind::move_absolute), Cause::in_group);
  EXPECT_EQ(against_role(Peers::led, CommandKind::hold), Cause::in_group);
  EXPECT_EQ(against_role(Peers::led, CommandKind::stop), Cause::none);
}

TEST(GroupRole, AGroupAcceptsThePathAndWhatAnAxisOfItAccepts) {
  EXPECT_EQ(against_role(Peers::together, CommandKind::hold), Cause::none);
  EXPECT_EQ(against_role(Peers::together, CommandKind::stop), Cause::none);
  EXPECT_EQ(against_role(Peers::together, CommandKind::move_absolute), Cause::single_axis);
}

TEST(GroupRole, NamesTheAxisThatIsNotReadyOrAway) {
  Inputs inputs;
  inputs.master = {3.5, 4.5, 2, 9};
  inputs.peers = Peers::together;
  EXPECT_FALSE(against_axes(inputs));
  inputs.peers = Peers::failed;
  ASSERT_TRUE(against_axes(inputs));
  EXPECT_EQ(against_axes(inputs)->cause, Cause::axis_not_ready);
  EXPECT_EQ(against_axes(inputs)->where, 2);
  EXPECT_EQ(against_axes(inputs)->value, 9);
  inputs.peers = Peers::away;
  EXPECT_EQ(against_axes(inputs)->cause, Cause::axis_away);
  EXPECT_EQ(against_axes(inputs)->value, 3.5);
  EXPECT_EQ(against_axes(inputs)->limit, 4.5);
}

TEST(GroupRole, AGroupThatLeftItsPathMayBeResetWithAnAxisAway) {
  Inputs inputs;
  inputs.peers = Peers::away;
  EXPECT_TRUE(against_reset(inputs, true));
  EXPECT_FALSE(against_reset(inputs, false));
  inputs.peers = Peers::failed;
  EXPECT_TRUE(against_reset(inputs, false));
}

}  // namespace
}  // namespace jounce::group_role_test
