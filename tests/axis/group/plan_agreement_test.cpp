// SPDX-License-Identifier: Apache-2.0
// Commands of a group as a program, and the time up to which two plans agree.
#include "jounce/axis/detail/plan_agreement.hpp"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/axis/detail/path_commands.hpp"

#include "axis/group/group_rig.hpp"
#include "support/errors.hpp"
#include "support/loop_limit.hpp"

namespace jounce::plan_agreement_test {
namespace {

using namespace test;
using ::jounce::test::error_of;
using ::testing::HasSubstr;

command::MoveLinearAbsolute line(double px, double py, PathBuffer buffer = PathBuffer::look_ahead,
                                 double deviation = 0.2) {
  command::MoveLinearAbsolute to{
      .path = {.along = {.velocity = 120}, .buffer = buffer, .deviation = deviation}};
  to.to[0] = px;
  to.to[1] = py;
  return to;
}

Plan planned(const PathCommands& commands) {
  return plan(commands.program(), {.axes = std::vector<Limits>(2, limits(200, 2000, 1e5))});
}

/// `count` lines with corners.
PathCommands stairs(int count) {
  PathCommands commands(2, {});
  for (int k = 1; k <= count; ++k) commands.append(line(8.0 * k, 5.0 * ((k + 1) / 2)));
  return commands;
}

/// The greatest distance of both plans from t0 to t1 of the first one, by their values alone.
double apart(const Plan& before, const Plan& after, const Agreement& where, double t0, double t1) {
  std::array<Motion, 2> a;
  std::array<Motion, 2> b;
  double most = 0;
  for (int k = 0; k <= 1000; ++k) {
    const double t = t0 + (t1 - t0) * k / 1000;
    before.at(t, a);
    after.at(t - where.shift, b);
    for (const std::size_t i : {0U, 1U}) {
      most = std::max({most, std::abs(a[i].position - b[i].position),
                       std::abs(a[i].velocity - b[i].velocity) * 1e-3,
                       std::abs(a[i].acceleration - b[i].acceleration) * 1e-6});
    }
  }
  return most;
}

TEST(PlanAgreement, ALongerPlanAgreesUntilTheShorterOneBrakes) {
  const Plan before = planned(stairs(20));
  const Plan after = planned(stairs(21));
  const auto where = agreement(before, after, 0);
  ASSERT_TRUE(where);
  EXPECT_EQ(where->position, 0);
  EXPECT_EQ(where->shift, 0);
  EXPECT_GT(where->until, 0.8 * before.duration());
  EXPECT_LT(where->until, before.duration());
  EXPECT_LT(apart(before, after, *where, 0, where->until), 1e-11);
  EXPECT_GT(apart(before, after, *where, where->until, before.duration()), 1e-3);
}

TEST(PlanAgreement, AStopAtTheJointAgreesToTheEnd) {
  PathCommands commands = stairs(20);
  const Plan before = planned(commands);
  commands.append(line(200, 0));
  const Plan after = planned(commands.stopping());
  const auto where = agreement(before, after, 0.5 * before.path().length());
  ASSERT_TRUE(where);
  EXPECT_NEAR(where->until, before.duration(), 1e-12);
  EXPECT_LT(apart(before, after, *where, 0, before.duration()), 1e-11);
}

TEST(PlanAgreement, APlanFromALaterCommandAgreesAfterItsApproach) {
  const PathCommands all = stairs(40);
  const Plan before = planned(all);
  PathCommands rest = all.from(10);
  EXPECT_EQ(rest.first(), 10);
  rest.append(line(400, 0));
  const Plan after = planned(rest);
  const double q = before.path().length() / 2;
  const auto where = agreement(before, after, q);
  ASSERT_TRUE(where);
  EXPECT_GT(where->shift, 0);
  double t = 0;
  for (test::LoopLimit loop; before.law().at(t).position < q && loop.goes_on();) t += 1e-3;
  ASSERT_GT(where->until, t);
  EXPECT_LT(apart(before, after, *where, t, where->until), 1e-9);
  // At the start of the later command, the group moves in one plan and rests in the other.
  EXPECT_FALSE(agreement(before, after, where->position + 1e-3));
}

TEST(PlanAgreement, PlansOnOtherPathsDoNotAgree) {
  const Plan before = planned(stairs(20));
  PathCommands other(2, {});
  for (int k = 1; k <= 21; ++k) other.append(line(8.0 * k, -5.0 * ((k + 1) / 2)));
  const auto where = agreement(before, planned(other), 60);
  EXPECT_TRUE(!where || where->until < 0.1) << where->until;
}

TEST(PathCommands, NumbersFollowTheLines) {
  PathCommands commands(2, {});
  commands.append(line(10, 0, PathBuffer::buffered, as_configured));
  commands.append(line(15, 0, PathBuffer::look_ahead, as_configured));
  commands.append(line(20, 0, PathBuffer::look_ahead, as_configured));
  EXPECT_EQ(commands.last(), 3);
  EXPECT_EQ(commands.number_at(1, 9), 1);
  EXPECT_EQ(commands.number_at(1, 12), 2);
  EXPECT_EQ(commands.number_at(2, 4), 2);
  EXPECT_EQ(commands.number_at(1, 19), 3);
  EXPECT_EQ(commands.from(3).position()[0], 20);
  EXPECT_EQ(commands.from(4).size(), 0U);
}

/// HIMC 8.1.6 Ex. 4: five turns of radius 50 up to 100.
TEST(PathCommands, AnArcWithAThirdCoordinateIsAHelix) {
  PathCommands commands(3, {});
  command::MoveCircularAbsolute helix{.path = {.along = {.velocity = 50}}};
  helix.to[0] = 0;
  helix.to[1] = 0;
  helix.to[2] = 100;
  helix.center = {0, 50};
  helix.turns = 4;
  commands.append(helix);
  const Plan motion =
      plan(commands.program(), {.axes = std::vector<Limits>(3, limits(200, 2000, 1e5))});
  EXPECT_NEAR(motion.path().length(), std::hypot(5 * 2 * std::numbers::pi * 50, 100), 1e-9);
  std::array<Motion, 3> at;
  for (double t = 0; t < motion.duration(); t += 0.01) {
    motion.at(t, at);
    ASSERT_NEAR(std::hypot(at[0].position, at[1].position - 50), 50, 1e-12) << t;
  }
  motion.at(motion.duration(), at);
  EXPECT_EQ(at[2].position, 100);
}

TEST(PathCommands, AnInvalidCommandIsNamed) {
  PathCommands commands(2, {5, 0});
  EXPECT_THAT(error_of([&] { commands.append(line(5, 0)); }), HasSubstr("has no length"));
  command::MoveLinearAbsolute both = line(9, 9);
  both.path.corner_distance = 1;
  EXPECT_THAT(error_of([&] { commands.append(both); }), HasSubstr("cannot be combined"));
  command::MoveCircularAbsolute arc{};
  arc.to[0] = 10;
  EXPECT_THAT(error_of([&] { commands.append(arc); }),
              HasSubstr("needs exactly one of --via, --center and --radius"));
  arc.via = {7, 0, as_configured};
  EXPECT_THAT(error_of([&] { commands.append(arc); }), HasSubstr("via"));
  EXPECT_TRUE(commands.empty());
}

TEST(GroupExtension, TakesALongerPlanUpToItsTime) {
  const Limits axis = limits(200, 2000, 1e5);
  const auto program = [&](const PathCommands& commands) {
    return group_program(std::make_shared<const Plan>(planned(commands)),
                         std::vector<AxisConfig>(2, Plotter::config(axis)),
                         std::vector<std::string>{"x", "y"});
  };
  const PathCommands first = stairs(6);
  PathCommands longer = first;
  longer.append(line(100, 0));
  const GroupProgram before = program(first);
  const GroupProgram after = program(longer);
  const auto where = agreement(*before.plan, *after.plan, 0);
  ASSERT_TRUE(where);
  for (const bool late : {false, true}) {
    Plotter rig(axis);
    GroupPath path(1, before);
    GroupPath next(2, after);
    rig.enable();
    EXPECT_EQ(rig.send(Plotter::group, command::Extend{&next, 0, 0, where->until}),
              Cause::no_movement);
    rig.send(Plotter::group, command::Arm{&path});
    rig.send(Plotter::group, command::Start{});
    const int ticks = static_cast<int>(where->until * 1e3) + (late ? 2 : -2);
    rig.steps(ticks);
    const Tick was = rig.at(Plotter::x);
    const Cause refused = rig.send(Plotter::group, command::Extend{&next, 0, 0, where->until});
    EXPECT_EQ(refused, late ? Cause::too_late : Cause::none);
    EXPECT_EQ(rig.at(Plotter::group).handed_back[0], late ? &next : &path);
    EXPECT_TRUE(keeps_limits(resolved(Plotter::config(axis)), was, rig.at(Plotter::x), true));
    rig.steps(4000);
    EXPECT_EQ(rig.at(Plotter::x).position, late ? 48 : 100);
    EXPECT_EQ(rig.at(Plotter::group).finished, 1U);
    EXPECT_EQ(rig.at(Plotter::x).fault, Cause::none);
  }
}

TEST(GroupExtension, AnAxisAloneAndAnOverrideOfAMemberAreRejected) {
  Plotter rig;
  rig.start();
  rig.steps(100);
  EXPECT_EQ(rig.send(Plotter::x, command::Override{0.5}), Cause::in_group);
  EXPECT_EQ(rig.send(Plotter::x, command::Extend{}), Cause::in_group);
}

}  // namespace
}  // namespace jounce::plan_agreement_test
