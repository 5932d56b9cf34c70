// SPDX-License-Identifier: Apache-2.0
// A group of the machine: its states, its path, and its axes.
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/path/path_length.hpp"

#include "axis/group/group_rig.hpp"
#include "support/errors.hpp"
#include "support/loop_limit.hpp"

namespace jounce::group_test {
namespace {

using namespace test;
using namespace test::on_plotter;
using ::jounce::test::error_of;
using ::testing::HasSubstr;

constexpr double on_path = 1e-12;  ///< u, rounding of the closed form

void expect_on_path(const Plotter& rig) {
  const auto [px, py] = contour_at(rig.at(group).position);
  EXPECT_NEAR(rig.at(x).position, px, on_path) << "tick " << rig.tick;
  EXPECT_NEAR(rig.at(y).position, py, on_path) << "tick " << rig.tick;
}

TEST(Group, PlaysItsPlanToTheLastBit) {
  Plotter rig;
  rig.start();
  const std::int64_t begin = rig.tick;
  EXPECT_EQ(rig.at(group).state, State::discrete_motion);
  std::vector<Motion> wanted(2);
  int compared = 0;
  for (; rig.at(group).job != 0; rig.step(), ++compared) {
    const double t = static_cast<double>((rig.tick - begin) * 1'000'000) / 1e9;
    rig.plan->at(t, wanted);
    for (const std::size_t i : {x, y}) {
      ASSERT_EQ(rig.at(i).position, wanted[i].position) << t;
      ASSERT_EQ(rig.at(i).velocity, wanted[i].velocity) << t;
      ASSERT_EQ(rig.at(i).acceleration, wanted[i].acceleration) << t;
      ASSERT_EQ(rig.at(i).state, State::synchronized_motion) << t;
    }
    ASSERT_EQ(rig.at(group).time, rig.at(x).time);
  }
  EXPECT_EQ(compared, static_cast<int>(std::ceil(rig.plan->duration() * 1000)));
  for (const std::size_t i : {x, y, group}) {
    EXPECT_EQ(rig.at(i).state, State::standstill);
    EXPECT_EQ(rig.at(i).finished, 1U);
    EXPECT_EQ(rig.at(i).velocity, 0);
  }
  EXPECT_EQ(rig.at(x).position, 0);
  EXPECT_EQ(rig.at(y).position, 0);
}

/// Pulses at equal lengths along rounded corners: at the instants of the planned motion, and as many after a hold.
TEST(Group, ComparesTheLengthOfTheToolsPath) {
  Program corners(2);
  corners.set({.velocity = 190, .corner = Corner::distance, .value = 5});
  corners.line({30, 0}, 1);
  corners.line({30, 30}, 2);
  corners.line({5, 40}, 3);
  const PositionCompare list{
      .mode = CompareMode::linear, .points = evenly(0.5, 1, 86), .pulse = 1e-5};
  for (const bool holds : {false, true}) {
    Plotter rig(limits(200, 2000, 1e5), corners);
    std::vector<MachineAxis> axes = Plotter::axes_of(limits(200, 2000, 1e5));
    axes[group].compare.list = list;
    rig.machine = Machine(axes);
    GroupProgram program = rig.program;
    program.length = std::make_shared<const PathLength>(*rig.plan);
    GroupPath path(9, program);
    rig.enable();
    rig.send(group, command::Arm{&path});
    rig.send(group, command::Start{});
    const std::int64_t begin = rig.tick;
    std::vector<double> times;
    for (; rig.at(group).job != 0; rig.step()) {
      for (const OutputEdge& edge : rig.at(group).compare.edges())
        if (edge.on) times.push_back(static_cast<double>(rig.tick - 1 - begin) / 1000 + edge.time);
      if (holds && rig.tick == begin + 300) rig.images[group].command = {command::Hold{}};
      if (holds && rig.tick == begin + 600) rig.images[group].command = {command::Resume{}};
    }
    const std::vector<CompareEvent> wanted =
        compared(list, length_over_time(*rig.plan).curve).events;
    ASSERT_GT(wanted.size(), 80U);
    ASSERT_LT(wanted.size(), 86U) << "the corners are shorter than their sides";
    ASSERT_EQ(times.size(), wanted.size());
    if (holds) continue;
    for (std::size_t k = 0; k < times.size(); ++k) EXPECT_NEAR(times[k], wanted[k].time, 1e-7) << k;
  }
}

/// Against samples of the plan. The lines have 40, 150, 20 and 10 mm/s.
TEST(GroupProgram, PartsHaveThePeaksFromTheirRestToTheEnd) {
  Program lines(2);
  const double feed[] = {40, 150, 20, 10};
  const double at[] = {50, 150, 170, 190};
  for (int i = 0; i < 4; ++i) {
    lines.set({.velocity = feed[i], .corner = Corner::stop});
    lines.line({at[i], i % 2 == 0 ? 0.0 : 10.0}, i + 1);
  }
  const Plotter rig(limits(200, 2000, 1e5), lines);
  const std::vector<ProgramPart>& parts = rig.program.parts;
  ASSERT_EQ(parts.size(), 3U) << "the first and the second line have the same greatest magnitudes";
  EXPECT_EQ(parts[0].start, 0);
  for (const ProgramPart& part : parts) {
    EXPECT_EQ(&part_at(rig.program, part.start), &part);
    EXPECT_EQ(&part_at(rig.program, part.start + 1), &part);
    Peaks along;
    std::vector<Peaks> axes(2);
    const auto raise = [](Peaks& peaks, const Motion& m) {
      peaks.velocity = std::max(peaks.velocity, std::abs(m.velocity));
      peaks.acceleration = std::max(peaks.acceleration, std::abs(m.acceleration));
      peaks.jerk = std::max(peaks.jerk, std::abs(m.jerk));
    };
    std::vector<Motion> motion(2);
    for (double t = 0; t < rig.plan->duration(); t += 1e-5) {
      const Motion q = rig.plan->law().at(t);
      if (q.position <= part.start) continue;
      rig.plan->at(t, motion);
      raise(along, q);
      for (const std::size_t k : {x, y}) raise(axes[k], motion[k]);
    }
    const auto expect_near = [&](const Peaks& peaks, const Peaks& sampled) {
      EXPECT_LE(sampled.velocity, peaks.velocity * (1 + 1e-9));
      EXPECT_LE(sampled.acceleration, peaks.acceleration * (1 + 1e-9));
      EXPECT_LE(sampled.jerk, peaks.jerk * (1 + 1e-9));
      EXPECT_GE(sampled.velocity, 0.999 * peaks.velocity);
      EXPECT_GE(sampled.jerk, 0.999 * peaks.jerk);
    };
    expect_near(part.along, along);
    for (const std::size_t k : {x, y}) {
      expect_near(part.axes[k], axes[k]);
      EXPECT_GE(axes[k].acceleration, 0.99 * part.axes[k].acceleration);
    }
  }
  EXPECT_EQ(&part_at(rig.program, 1e9), &parts.back());
}

TEST(Group, IsEnabledOnlyWithItsAxes) {
  Plotter rig;
  rig.send(x, command::Enable{});
  EXPECT_EQ(rig.send(group, command::Enable{}), Cause::axis_not_ready);
  EXPECT_EQ(rig.at(group).state, State::disabled);
  rig.images[group].command = {command::Enable{}};
  rig.step();
  EXPECT_THAT(rig.at(group).refused->text(), HasSubstr("Axis 2 of the group is disabled."));
  rig.send(y, command::Enable{});
  EXPECT_EQ(rig.send(group, command::Enable{}), Cause::none);
  EXPECT_EQ(rig.at(group).state, State::standstill);
}

TEST(Group, AnAxisOfItMovesAloneOnlyWhileItIsDisabled) {
  Plotter rig;
  rig.enable();
  for (const AxisCommand& move :
       {AxisCommand{command::MoveAbsolute{.position = 5}}, AxisCommand{command::MoveVelocity{3}},
        AxisCommand{command::Home{}}, AxisCommand{command::SetPosition{4}},
        AxisCommand{command::Halt{}}})
    EXPECT_EQ(rig.send(x, move), Cause::in_group);
  EXPECT_EQ(rig.send(group, command::MoveAbsolute{.position = 5}), Cause::single_axis);
  EXPECT_EQ(rig.send(group, command::SetPosition{5}), Cause::single_axis);
  EXPECT_EQ(rig.send(group, command::Disable{}), Cause::none);
  EXPECT_EQ(rig.send(x, command::MoveAbsolute{.position = 5}), Cause::none);
  EXPECT_EQ(rig.send(group, command::Enable{}), Cause::axis_not_ready) << "x moves";
}

TEST(Group, StartsOnlyWhereItsAxesStand) {
  Plotter rig;
  for (const std::size_t i : {x, y}) rig.send(i, command::Enable{});
  rig.send(y, command::SetPosition{0.5});
  rig.send(group, command::Enable{});
  rig.send(group, command::Arm{&rig.path});
  rig.images[group].command = {command::Start{}};
  rig.step();
  EXPECT_THAT(rig.at(group).refused->text(),
              HasSubstr("Axis 2 of the group is at 0.5 instead of 0."));
  rig.steps(10);
  EXPECT_EQ(rig.at(group).state, State::standstill);
  rig.send(group, command::Disable{});
  rig.send(y, command::SetPosition{0});
  rig.send(group, command::Enable{});
  rig.send(group, command::Arm{&rig.path});
  EXPECT_EQ(rig.send(group, command::Start{}), Cause::none);
  EXPECT_TRUE(rig.moves());
  rig.send(group, command::Stop{});
  rig.steps(1000);
  rig.send(group, command::Arm{&rig.path});
  EXPECT_EQ(rig.send(group, command::Start{}), Cause::no_movement) << "it is played once";
}

TEST(Group, NamesTheGroupAsTheReasonWhileItMoves) {
  Plotter rig;
  rig.start();
  rig.steps(20);
  EXPECT_EQ(rig.send(x, command::SetPosition{4}), Cause::in_group);
  EXPECT_EQ(rig.send(x, command::GearOut{}), Cause::in_group);
  EXPECT_EQ(rig.send(group, command::SetPosition{5}), Cause::single_axis);
}

TEST(Group, HoldsAtAnyInstantOnItsPathAndContinues) {
  for (int hold = 1; hold < 5000; hold += 37) {
    Plotter rig;
    rig.start();
    rig.steps(hold);
    if (rig.at(group).job == 0) break;
    ASSERT_EQ(rig.send(group, command::Hold{}), Cause::none);
    for (int i = 0; rig.moves(); ++i, rig.step()) {
      ASSERT_LT(i, 2000);
      expect_on_path(rig);
    }
    EXPECT_EQ(rig.at(x).state, State::standstill);
    EXPECT_EQ(rig.at(x).velocity, 0);
    if (rig.at(group).job == 0) continue;  // it reached the end before it came to rest
    const double there = rig.at(group).position;
    EXPECT_EQ(rig.at(group).state, State::discrete_motion);
    EXPECT_EQ(rig.send(x, command::MoveAbsolute{.position = 5}), Cause::in_group);
    rig.steps(20);
    ASSERT_EQ(rig.at(group).position, there);
    ASSERT_EQ(rig.send(group, command::Resume{}), Cause::none);
    for (int i = 0; rig.at(group).job != 0; ++i, rig.step()) {
      ASSERT_LT(i, 6000);
      expect_on_path(rig);
    }
    EXPECT_EQ(rig.at(group).finished, 1U);
    EXPECT_EQ(rig.at(y).position, 0);
  }
}

TEST(Group, AnOverrideDoesNotChangeItsPath) {
  Plotter rig;
  rig.start();
  rig.send(group, command::Override{0.3});
  rig.steps(1000);
  EXPECT_EQ(rig.at(group).rate, 0.3);
  expect_on_path(rig);
  rig.send(group, command::Override{0});
  rig.steps(500);
  EXPECT_FALSE(rig.moves());
  EXPECT_EQ(rig.at(x).state, State::standstill);
  rig.send(group, command::Override{2});
  EXPECT_EQ(rig.at(group).override_, 1) << "the plan uses the full acceleration of its axes";
  for (; rig.at(group).job != 0; rig.step()) expect_on_path(rig);
  EXPECT_EQ(rig.at(group).finished, 1U);
}

// The plan has a reserve: half of the velocity and a tenth of the acceleration of its axes.
TEST(Group, AnOverrideAboveOneUsesTheReserveOfItsAxes) {
  const Limits axis = limits(200, 2000, 1e5);
  Program program(2);
  program.set({.velocity = 50, .acceleration = 200, .deceleration = 200, .jerk = 1e4});
  program.line({100, 60});
  Plotter rig(axis, program);
  rig.start();
  rig.send(group, command::Override{1.8});
  rig.steps(900);
  EXPECT_EQ(rig.at(group).rate, 1.8);
  EXPECT_NEAR(std::hypot(rig.at(x).velocity, rig.at(y).velocity), 90, 1e-9);
}

TEST(Group, HaltsAndStopsOnItsPath) {
  for (const bool stop : {false, true}) {
    Plotter rig;
    rig.start();
    rig.steps(700);
    const AxisCommand ending = stop ? AxisCommand{command::Stop{}} : AxisCommand{command::Halt{}};
    ASSERT_EQ(rig.send(group, ending), Cause::none);
    EXPECT_EQ(rig.at(group).state, stop ? State::stopping : State::discrete_motion);
    EXPECT_EQ(rig.send(group, command::Disable{}), Cause::in_motion);
    for (; rig.moves(); rig.step()) expect_on_path(rig);
    EXPECT_EQ(rig.at(group).state, State::standstill);
    EXPECT_EQ(rig.at(group).reason, stop ? Cause::stopped : Cause::halted);
    EXPECT_EQ(rig.at(y).state, State::standstill);
    EXPECT_EQ(rig.send(group, command::Resume{}), Cause::no_movement);
  }
}

TEST(Group, AStopOfAnAxisStopsTheGroupOnItsPath) {
  Plotter rig;
  rig.start();
  rig.steps(700);
  EXPECT_EQ(rig.send(y, command::Stop{}), Cause::none);
  EXPECT_EQ(rig.at(group).state, State::stopping);
  for (; rig.moves(); rig.step()) expect_on_path(rig);
  EXPECT_EQ(rig.at(group).reason, Cause::group_stopped);
  EXPECT_EQ(rig.at(y).state, State::standstill);
  EXPECT_EQ(rig.at(y).fault, Cause::none);
}

TEST(Group, TheFaultOfAnAxisStopsTheGroupAndItContinuesFromThere) {
  Plotter rig;
  rig.start();
  rig.steps(700);
  rig.images[y].inputs.feedback.fault = true;
  rig.step();
  EXPECT_EQ(rig.at(y).state, State::disabled);
  rig.step();
  EXPECT_EQ(rig.at(group).state, State::error_stop);
  EXPECT_EQ(rig.at(group).fault, Cause::axis_fault);
  for (; rig.moves(); rig.step())
    EXPECT_NEAR(rig.at(x).position, contour_at(rig.at(group).position).first, on_path);
  EXPECT_EQ(rig.at(x).state, State::standstill);
  EXPECT_FALSE(in_motion(rig.at(group)));
  rig.images[y].inputs.feedback.fault = false;
  EXPECT_EQ(rig.send(group, command::Reset{}), Cause::axis_not_ready);
  rig.send(y, command::Reset{});
  rig.send(y, command::Enable{});
  EXPECT_EQ(rig.send(group, command::Reset{}), Cause::axis_away);
  const double place = contour_at(rig.at(group).position).second;
  EXPECT_EQ(rig.send(y, command::MoveAbsolute{.position = place}), Cause::none);
  rig.steps(1000);
  EXPECT_EQ(rig.send(group, command::Reset{}), Cause::none);
  EXPECT_EQ(rig.send(group, command::Resume{}), Cause::none);
  rig.steps(2);
  for (; rig.at(group).job != 0; rig.step()) expect_on_path(rig);
  EXPECT_EQ(rig.at(group).finished, 1U);
  EXPECT_EQ(rig.at(y).fault, Cause::none);
}

TEST(Group, TheOverrideMovesNothingInAFaultAndIsAcceptedAlikeAtEachValue) {
  Plotter rig;
  rig.start();
  rig.steps(700);
  rig.images[y].inputs.feedback.fault = true;
  rig.step();
  rig.step();
  for (; rig.moves(); rig.step()) {
  }
  rig.images[y].inputs.feedback.fault = false;
  rig.send(y, command::Reset{});
  rig.send(y, command::Enable{});
  const double place = contour_at(rig.at(group).position).second;
  ASSERT_EQ(rig.send(group, command::Reset{}), Cause::axis_away);
  for (const double factor : {0.0, 1.0, 0.5, 2.0}) {
    EXPECT_EQ(rig.send(group, command::Override{factor}), Cause::none) << factor;
    rig.steps(50);
    EXPECT_EQ(rig.at(group).state, State::error_stop);
    EXPECT_EQ(rig.at(group).rate, 0);
  }
  EXPECT_EQ(rig.send(group, command::Override{0.5}), Cause::none);
  EXPECT_EQ(rig.send(y, command::MoveAbsolute{.position = place}), Cause::none);
  rig.steps(1000);
  EXPECT_EQ(rig.send(group, command::Reset{}), Cause::none);
  EXPECT_EQ(rig.send(group, command::Override{0.25}), Cause::none) << "held: it moves nothing";
  EXPECT_EQ(rig.at(group).rate, 0);
  EXPECT_EQ(rig.send(group, command::Resume{}), Cause::none);
  rig.steps(500);
  EXPECT_EQ(rig.at(group).rate, 0.25);
  for (; rig.at(group).job != 0; rig.step()) expect_on_path(rig);
  EXPECT_EQ(rig.at(group).finished, 1U);
}

TEST(Group, TheWatchdogStopsItOnItsPath) {
  Plotter rig;
  rig.start();
  rig.steps(700);
  for (AxisImage& image : rig.images) image.inputs.watchdog = true;
  rig.step();
  EXPECT_EQ(rig.at(group).fault, Cause::watchdog);
  for (; rig.moves(); rig.step()) expect_on_path(rig);
  EXPECT_EQ(rig.at(x).fault, Cause::none);
  EXPECT_EQ(rig.at(x).state, State::standstill);
}

TEST(Group, AProgramBeyondTheLimitsOfAnAxisIsRejected) {
  const Limits fast = limits(200, 2000, 1e5);
  const auto plan = std::make_shared<const Plan>(
      jounce::plan(contour(150), {.axes = std::vector<Limits>(2, fast)}));
  std::vector<AxisConfig> configs(2, Plotter::config(fast));
  const std::vector<std::string> names{"x", "y"};
  EXPECT_NO_THROW(group_program(plan, configs, names));
  configs[1].limits.acceleration = 1500;
  EXPECT_THAT(error_of([&] { group_program(plan, configs, names); }), HasSubstr("y.acceleration"));
  configs[1] = Plotter::config(fast);
  configs[0].limits.position_max = 99;
  EXPECT_THAT(error_of([&] { group_program(plan, configs, names); }),
              HasSubstr("exceeds position_max of the axis, 99"));
}

/// The acceleration of an axis steps by v^2 / r between a line and a tangent arc.
TEST(Group, AStepOfTheAccelerationCountsAsAJerk) {
  const Limits axis = limits(200, 2000, 5e4);
  Program program(2);
  program.set({.velocity = 150});
  program.line({100, 0}, 1);
  program.arc(arc_about(program.position(), {100, 50}, {100, 100}, Plane{0, 1},
                        ArcRotation::counterclockwise),
              2);
  const auto sharp =
      std::make_shared<const Plan>(jounce::plan(program, {.axes = std::vector<Limits>(2, axis)}));
  std::vector<AxisConfig> configs(2, Plotter::config(axis));
  const std::vector<std::string> names{"x", "y"};
  const std::string error = error_of([&] { group_program(sharp, configs, names); });
  EXPECT_THAT(error, HasSubstr("y.acceleration"));
  EXPECT_THAT(error, HasSubstr("the jerk limit times one cycle"));
  for (AxisConfig& config : configs) config.limits.jerk.reset();
  EXPECT_NO_THROW(group_program(sharp, configs, names)) << "without a jerk limit, it may step";

  const Limits no_jerk{.velocity = 200, .acceleration = 2000};
  const auto trapezoids = std::make_shared<const Plan>(
      jounce::plan(contour(150), {.axes = std::vector<Limits>(2, no_jerk)}));
  configs.assign(2, Plotter::config(axis));
  EXPECT_THAT(error_of([&] { group_program(trapezoids, configs, names); }),
              HasSubstr("x.acceleration"));
}

TEST(Group, APathThatIsArmedDuringAHoldDoesNotMoveTheEndOfTheHeldOne) {
  Plotter rig;
  Program elsewhere(2, Point{50, 50});
  elsewhere.set({.velocity = 150});
  elsewhere.line({10, 10}, 1);
  const Limits axis = limits(200, 2000, 1e5);
  const auto plan =
      std::make_shared<const Plan>(jounce::plan(elsewhere, {.axes = std::vector<Limits>(2, axis)}));
  GroupPath next(8, group_program(plan, std::vector<AxisConfig>(2, Plotter::config(axis)),
                                  std::vector<std::string>{"x", "y"}));
  rig.start();
  rig.steps(500);
  EXPECT_EQ(rig.send(group, command::Hold{}), Cause::none);
  rig.steps(500);
  ASSERT_EQ(rig.at(group).rate, 0);
  EXPECT_EQ(rig.send(group, command::Arm{&next}), Cause::none);
  EXPECT_EQ(rig.send(group, command::Resume{}), Cause::none);
  for (test::LoopLimit loop; rig.at(group).job != 0 && loop.goes_on();) {
    rig.step();
    expect_on_path(rig);
  }
  for (const std::size_t i : {x, y, group}) {
    EXPECT_EQ(rig.at(i).fault, Cause::none);
    EXPECT_EQ(rig.at(i).state, State::standstill);
  }
  EXPECT_EQ(rig.at(x).position, 0);
  EXPECT_EQ(rig.at(y).position, 0);
  rig.step();
  EXPECT_EQ(rig.send(group, command::Start{}), Cause::axis_away)
      << "the armed path begins elsewhere";
}

TEST(Group, ImpossibleGroupsAreRejected) {
  auto axes = Plotter::axes_of(limits(200, 2000, 1e5));
  axes[2].group->axes = {0, 0};
  EXPECT_THAT(error_of([&] { Machine{axes}; }), HasSubstr("is already an axis of the group"));
  axes[2].group->axes = {0, 2};
  EXPECT_THAT(error_of([&] { Machine{axes}; }),
              HasSubstr("plotter: must be an axis of the machine, and not a group"));
  axes[2].group->axes = {};
  EXPECT_THAT(error_of([&] { Machine{axes}; }), HasSubstr("1 to 9 axes"));
  axes[2].group->axes = {0, 1};
  axes[0].follow = {.what = Follow::What::setpoint, .index = 1};
  EXPECT_THAT(error_of([&] { Machine{axes}; }), HasSubstr("follows a master"));
  axes[0].follow = {};
  axes[2].group->tolerance = 1;
  EXPECT_THAT(error_of([&] { Machine{axes}; }), HasSubstr("must be at most 0.2"));
  axes[2].group->tolerance = -1;
  EXPECT_THAT(error_of([&] { Machine{axes}; }), HasSubstr("must not be negative"));
}

}  // namespace
}  // namespace jounce::group_test
