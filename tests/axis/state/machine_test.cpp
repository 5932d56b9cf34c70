// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/machine.hpp"

#include <cmath>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/axis/live_gear.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/tables.hpp"
#include "support/errors.hpp"

namespace jounce::machine_test {
namespace {

using namespace test;
using ::jounce::test::error_of;
using ::testing::HasSubstr;
using What = Follow::What;

MachineAxis axis(std::string name, Follow follow = {}) {
  return {.name = std::move(name), .config = {.limits = limits(10, 20)}, .follow = follow};
}

Follow setpoint_of(std::size_t index) {
  return {.what = What::setpoint, .index = index};
}

/// A machine with its images and its tick.
struct Rig {
  explicit Rig(std::vector<MachineAxis> axes, std::size_t masters = 0)
      : machine(std::move(axes), masters), images(machine.size()) {}

  void step(std::span<const Jet> masters = {}) {
    machine.step(++tick, images, masters);
    for (AxisImage& image : images) image.command = {};
  }
  void send(std::size_t i, const Command& command) {
    images[i].command = command;
    step();
  }

  Machine machine;
  std::vector<AxisImage> images;
  std::int64_t tick = -1;
};

// A machine adds nothing to its axes: beside each other they do what each does alone, to the bit.
TEST(Machine, StepsEachAxisAsIfItWereAlone) {
  Job first(1, there_and_back(0, 1, 2, Extrapolation::hold));
  Job second(2, trapezoid_table(5, 4, 20, 20));
  Rig rig({axis("feeder"), axis("knife")});
  Bench alone[] = {Bench({.limits = limits(10, 20)}), Bench({.limits = limits(10, 20)})};
  const auto both = [&](const Command& a, const Command& b) {
    rig.images[0].command = a;
    rig.images[1].command = b;
    rig.step();
    const Tick ticks[] = {alone[0].step(a), alone[1].step(b)};
    for (const std::size_t i : {0U, 1U}) {
      EXPECT_EQ(rig.images[i].tick.position, ticks[i].position);
      EXPECT_EQ(rig.images[i].tick.state, ticks[i].state);
      EXPECT_EQ(rig.images[i].tick.job, ticks[i].job);
    }
  };
  both({command::Enable{}}, {command::Enable{}});
  both({command::Arm{.movement = &first}}, {});
  both({command::Start{}}, {command::Arm{.movement = &second}});
  both({}, {command::Start{}});
  for (int i = 0; i < 500; ++i) both({}, {});
  both({command::Stop{}}, {});
  for (int i = 0; i < 3000; ++i) both({}, {});
  EXPECT_EQ(rig.images[0].tick.stopped, 1U);
  EXPECT_EQ(rig.images[1].tick.finished, 1U);
}

TEST(Machine, AFollowerSeesItsLeadersSetpointOfTheSameTick) {
  Job job(1, there_and_back(0, 1, 2, Extrapolation::hold));
  // Declared after those that follow it, through another one.
  Rig rig({axis("last", setpoint_of(1)), axis("middle", setpoint_of(2)), axis("leader")});
  for (const std::size_t i : {0U, 1U, 2U}) rig.send(i, {command::Enable{}});
  rig.send(2, {command::Arm{.movement = &job}});
  rig.send(2, {command::Start{}});
  for (int i = 0; i < 300; ++i) {
    rig.step();
    for (const std::size_t k : {1U, 2U}) {
      const Tick& leader = rig.images[k].tick;
      EXPECT_EQ(leader.tick, rig.tick);
      EXPECT_EQ(rig.images[k - 1].inputs.master,
                (Jet{leader.position, leader.velocity, leader.acceleration, 0}));
    }
  }
  EXPECT_GT(rig.images[1].inputs.master[0], 0.01);
}

TEST(Machine, AFollowerOfAnActualPositionFollowsTheDrive) {
  Rig rig({axis("feeder"), axis("knife", {.what = What::actual, .index = 0})});
  rig.images[0].inputs.feedback = {.position = 3, .velocity = 0.5};
  rig.step();
  EXPECT_EQ(rig.images[1].inputs.master, (Jet{3, 0.5, 0, 0}));
  rig.images[0].inputs.feedback.velocity = NAN;
  rig.step();
  EXPECT_TRUE(std::isnan(rig.images[1].inputs.master[0]));
}

TEST(Machine, HandsItsMastersOnAndNoneToWhoFollowsNothing) {
  Rig rig({axis("feeder"), axis("knife", {.what = What::master, .index = 1})}, 2);
  const std::vector<Jet> masters{{1, 2, 3, 4}, {5, 6, 7, 8}};
  rig.step(masters);
  EXPECT_EQ(rig.images[1].inputs.master, masters[1]);
  EXPECT_TRUE(std::isnan(rig.images[0].inputs.master[0]));
}

TEST(Machine, WhatBeganTogetherStopsTogether) {
  for (const std::size_t first : {0U, 1U})
    for (const Kind how : {Kind::stop, Kind::halt, Kind::abort, Kind::disable}) {
      std::vector<std::unique_ptr<Job>> jobs;
      Rig rig({axis("a"), axis("b"), axis("c")});
      for (const std::size_t i : {0U, 1U, 2U}) {
        jobs.push_back(std::make_unique<Job>(i + 1, trapezoid_table(50, 4, 10, 10)));
        rig.send(i, {command::Enable{}});
        const std::int64_t group = i < 2 ? 7 : 8;
        rig.send(i, {command::Arm{.movement = jobs.back().get(), .group = group}});
        rig.send(i, {command::Start{.tick = 300, .group = group}});
      }
      for (int k = 0; k < 500; ++k) rig.step();
      EXPECT_EQ(rig.images[first].tick.group, 7);
      rig.send(first, any({.kind = how}));
      rig.step();
      EXPECT_EQ(rig.images[1 - first].tick.state, State::stopping);
      EXPECT_EQ(rig.images[2].tick.state, State::discrete_motion) << "of another group";
      for (int k = 0; k < 1000; ++k) rig.step();
      EXPECT_EQ(rig.images[1 - first].tick.reason, Cause::group_stopped);
      EXPECT_EQ(rig.images[1 - first].tick.state, State::standstill);
    }
}

/// Two axes, armed in one group.
struct Together : Rig {
  Together() : Rig({axis("a"), axis("b")}) {
    for (const std::size_t i : {0U, 1U}) {
      send(i, {command::Enable{}});
      send(i, {command::Arm{.movement = &jobs[i], .group = 7}});
    }
  }
  void start(std::size_t i, std::int64_t at = 300) {
    send(i, {command::Start{.tick = at, .group = 7}});
  }
  /// Neither has left its place in the next half second.
  void none_moves() {
    for (int k = 0; k < 500; ++k) {
      step();
      for (const AxisImage& image : images) ASSERT_EQ(image.tick.position, 0) << "tick " << tick;
    }
    for (const AxisImage& image : images) EXPECT_FALSE(in_motion(image.tick));
  }
  Job jobs[2] = {Job(1, trapezoid_table(50, 4, 10, 10)), Job(2, trapezoid_table(50, 4, 10, 10))};
};

TEST(Machine, WhatShouldBeginTogetherDoesNotBeginAlone) {
  Together rig;
  for (const std::size_t i : {0U, 1U}) rig.start(i);
  rig.send(1, {command::Stop{}});
  rig.step();
  ASSERT_TRUE(rig.images[0].tick.dropped);
  EXPECT_EQ(rig.images[0].tick.dropped->cause, Cause::group_stopped);
  rig.none_moves();
}

TEST(Machine, AGroupWithoutAStartOfEachAxisDoesNotBegin) {
  for (const std::size_t missing : {0U, 1U}) {
    Together rig;
    rig.start(1 - missing);
    rig.none_moves();
    rig.start(missing, -1);
    ASSERT_TRUE(rig.images[missing].tick.refused) << "its group is broken";
    EXPECT_EQ(rig.images[missing].tick.refused->cause, Cause::group_stopped);
    rig.none_moves();
  }
}

TEST(Machine, AStartAfterTheGroupWasBrokenIsRejected) {
  for (const std::size_t first : {0U, 1U})
    for (const Kind how : {Kind::stop, Kind::abort, Kind::disable, Kind::disarm}) {
      Together rig;
      rig.send(first, any({.kind = how}));
      for (int k = 0; k < 10; ++k) rig.step();
      rig.start(1 - first, rig.tick + 50);
      ASSERT_TRUE(rig.images[1 - first].tick.refused);
      EXPECT_EQ(rig.images[1 - first].tick.refused->cause, Cause::group_stopped);
      rig.none_moves();
    }
}

// Whichever is stepped first has given out the first point of its table when the other one fails.
TEST(Machine, AFaultInTheTickOfTheStartMovesNoAxis) {
  for (const std::size_t fails : {0U, 1U}) {
    Together rig;
    for (const std::size_t i : {0U, 1U}) rig.start(i);
    while (rig.tick < 299) rig.step();
    rig.images[fails].inputs.feedback = {.position = 0, .fault = true};
    rig.step();
    EXPECT_EQ(rig.images[fails].tick.fault, Cause::drive_fault);
    rig.none_moves();
    EXPECT_EQ(rig.images[1 - fails].tick.state, State::standstill);
  }
}

// The start of the other axis goes with the movement that the arm replaces.
TEST(Machine, AnArmInTheTickOfTheStartMovesNoAxis) {
  for (const std::size_t armed : {0U, 1U}) {
    Together rig;
    for (const std::size_t i : {0U, 1U}) rig.start(i);
    while (rig.tick < 299) rig.step();
    Job again(3, trapezoid_table(50, 4, 10, 10));
    rig.send(armed, {command::Arm{.movement = &again, .group = 7}});
    rig.none_moves();
  }
}

TEST(Machine, ABrokenGroupBeginsWhenItIsArmedAnew) {
  Together rig;
  rig.send(0, {command::Stop{}});
  Job again(3, trapezoid_table(50, 4, 10, 10));
  rig.send(0, {command::Arm{.movement = &again, .group = 7}});
  for (const std::size_t i : {0U, 1U}) rig.start(i);
  while (rig.tick < 400) rig.step();
  for (const AxisImage& image : rig.images) EXPECT_GT(image.tick.position, 0);
  EXPECT_EQ(rig.images[0].tick.position, rig.images[1].tick.position);
}

TEST(Machine, AFollowerOfADisabledLeaderTakesNoStep) {
  // The leader's drive lags by 0.5 when it is let go, and is then turned by hand.
  Job job(1, there_and_back(0, 1, 1, Extrapolation::hold));
  LiveGear gear{2, {.numerator = 2, .denominator = 1, .acceleration = 20, .deceleration = 20}};
  Rig rig({axis("leader"), axis("slave", setpoint_of(0))});
  for (const std::size_t i : {0U, 1U}) rig.send(i, {command::Enable{}});
  rig.send(1, {command::Couple{.movement = &gear}});
  rig.images[0].inputs.feedback.position = -0.5;
  for (int k = 0; k < 10; ++k) rig.step();
  ASSERT_EQ(rig.images[1].tick.state, State::synchronized_motion);
  const double stood = rig.images[1].tick.position;
  rig.send(0, {command::Disable{}});
  for (int k = 0; k < 100; ++k) {
    EXPECT_EQ(rig.images[1].tick.position, stood);
    rig.images[0].inputs.feedback.position -= 1e-3;
    rig.step();
  }
  EXPECT_EQ(rig.images[0].tick.position, rig.images[0].inputs.feedback.position);
  EXPECT_EQ(rig.images[1].tick.fault, Cause::master_lost);
}

/// A leader and a slave that runs with twice its velocity.
struct InGear : Rig {
  InGear() : Rig({wide("leader", 5e3), wide("slave", 1e4, setpoint_of(0))}) {
    for (const std::size_t i : {0U, 1U}) send(i, {command::Enable{}});
    send(1, {command::Couple{.movement = &gear}});
  }
  static MachineAxis wide(std::string name, double acceleration, Follow follow = {}) {
    return {.name = std::move(name),
            .config = {.limits = limits(1000, acceleration)},
            .follow = follow};
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) step();
  }
  [[nodiscard]] const Tick& leader() const { return images[0].tick; }
  [[nodiscard]] const Tick& slave() const { return images[1].tick; }
  LiveGear gear{1, {.numerator = 2, .denominator = 1, .acceleration = 1e4, .deceleration = 1e4}};
};

TEST(Machine, ALeaderWithAnotherNameForItsPositionTakesNoFollowerWithIt) {
  InGear machine;
  machine.run(10);
  const double before = machine.slave().position;
  machine.send(0, {command::SetPosition{.position = 250}});
  ASSERT_FALSE(machine.leader().refused);
  EXPECT_EQ(machine.slave().position, before);
  EXPECT_EQ(machine.slave().master, 250) << "it sees the name";
  machine.send(0, {command::MoveRelative{.distance = 10}});
  machine.run(500);
  EXPECT_EQ(machine.leader().position, 260);
  EXPECT_NEAR(machine.slave().position, before + 20, 1e-9);
  EXPECT_EQ(machine.slave().state, State::synchronized_motion);
  EXPECT_EQ(machine.slave().fault, Cause::none);
}

TEST(Machine, ALeaderWithAnotherNameForItsPositionPassesNoStart) {
  InGear machine;
  LiveGear next{2, {.numerator = 1, .denominator = 1, .acceleration = 1e4, .deceleration = 1e4}};
  machine.send(1, {command::Arm{.movement = &next}});
  machine.send(1, {command::Start{.when = StartAt::master_position, .position = 100}});
  machine.send(0, {command::SetPosition{.position = 250}});
  machine.run(5);
  EXPECT_EQ(machine.slave().job, 1U);
  machine.send(0, {command::MoveRelative{.distance = -200, .dynamics = {.velocity = 100}}});
  machine.run(2500);
  EXPECT_EQ(machine.slave().job, 2U) << "that passes it";
}

TEST(Machine, AFollowerOfAFrozenLeaderBrakesWithinItsOwnLimits) {
  InGear machine;
  machine.send(0, {command::MoveVelocity{.velocity = 100}});
  machine.run(200);
  EXPECT_EQ(machine.slave().velocity, 200);
  machine.send(0, {command::Abort{}});
  EXPECT_EQ(machine.leader().velocity, 0);
  EXPECT_TRUE(machine.leader().frozen);
  EXPECT_EQ(machine.slave().fault, Cause::master_lost);
  Tick before = machine.slave();
  for (int i = 0; i < 50; ++i) {
    machine.step();
    const Tick& now = machine.slave();
    ASSERT_LE(std::abs(now.velocity - before.velocity), 20 * (1 + 1e-9));
    ASSERT_NEAR(now.position - before.position, 5e-4 * (now.velocity + before.velocity), 5.1e-3);
    before = now;
  }
  EXPECT_EQ(before.velocity, 0);
  EXPECT_FALSE(machine.leader().frozen);
}

std::string refused(std::vector<MachineAxis> axes) {
  return error_of([&] { Machine machine(std::move(axes)); });
}

TEST(Machine, RejectsAnInvalidMachine) {
  EXPECT_THAT(refused({}), HasSubstr("needs at least one axis"));
  EXPECT_THAT(refused({axis("a"), axis("a")}),
              HasSubstr("name = a: is the name of two axes of the machine: rename one of them"));
  EXPECT_THAT(refused({axis("")}), HasSubstr("needs a name"));
  EXPECT_THAT(refused({axis("a", {.what = What::master, .index = 0})}),
              HasSubstr("no such master"));
  EXPECT_THAT(refused({axis("a", setpoint_of(1))}), HasSubstr("no such axis"));
  EXPECT_THAT(refused({axis("a", setpoint_of(0))}), HasSubstr("cannot follow itself"));
  EXPECT_THAT(refused({axis("a", setpoint_of(1)), axis("b", setpoint_of(0))}), HasSubstr("ring"));
  MachineAxis slow = axis("slow");
  slow.config.period = 2'000'000;
  EXPECT_THAT(refused({axis("a"), slow}),
              HasSubstr("slow.cycle = 0.002: must be 0.001 s, the cycle of"));
  std::vector<MachineAxis> many;
  for (int i = 0; i < 64; ++i) many.push_back(axis("a" + std::to_string(i)));
  EXPECT_EQ(Machine{many}.size(), 64U);
  many.push_back(axis("one too many"));
  EXPECT_THAT(refused(many), HasSubstr("64"));
  // Axes may follow each other's measured positions.
  EXPECT_EQ(refused({axis("a", {.what = What::actual, .index = 1}),
                     axis("b", {.what = What::actual, .index = 0})}),
            "");
}

TEST(Machine, RejectsAWrongNumberOfImages) {
  Machine machine({axis("a"), axis("b")}, 1);
  std::vector<AxisImage> images(3);
  const std::vector<Jet> masters(2);
  const auto step = [&](std::size_t axes, std::size_t leads) {
    machine.step(0, std::span(images).first(axes), std::span(masters).first(leads));
  };
  EXPECT_THROW(step(1, 1), InputError);
  EXPECT_THROW(step(3, 1), InputError);
  EXPECT_THROW(step(2, 0), InputError);
  EXPECT_THROW(step(2, 2), InputError);
  step(2, 1);
  EXPECT_EQ(images[0].tick.tick, 0);
}

}  // namespace
}  // namespace jounce::machine_test
