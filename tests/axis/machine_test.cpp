#include "jounce/axis/machine.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axis/tables.hpp"
#include "support/errors.hpp"

namespace jounce {
namespace {

using namespace test;
using ::jounce::testing::error_of;
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
  void tell(std::size_t i, const Command& command) {
    images[i].command = command;
    step();
  }

  Machine machine;
  std::vector<AxisImage> images;
  std::int64_t tick = -1;
};

// A machine adds nothing to its axes: beside each other they do what each does alone, to the bit.
TEST(Machine, StepsEachAxisAsIfItWereAlone) {
  Job first(1, there_and_back(0, 1, 2, Outside::hold));
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
  both({.kind = Kind::enable}, {.kind = Kind::enable});
  both({.kind = Kind::arm, .movement = &first}, {});
  both({.kind = Kind::start}, {.kind = Kind::arm, .movement = &second});
  both({}, {.kind = Kind::start});
  for (int i = 0; i < 500; ++i) both({}, {});
  both({.kind = Kind::stop}, {});
  for (int i = 0; i < 3000; ++i) both({}, {});
  EXPECT_EQ(rig.images[0].tick.stopped, 1U);
  EXPECT_EQ(rig.images[1].tick.finished, 1U);
}

TEST(Machine, AFollowerSeesItsLeadersSetpointOfTheSameTick) {
  Job job(1, there_and_back(0, 1, 2, Outside::hold));
  // Declared after those that follow it, through another one.
  Rig rig({axis("last", setpoint_of(1)), axis("middle", setpoint_of(2)), axis("leader")});
  for (const std::size_t i : {0U, 1U, 2U}) rig.tell(i, {.kind = Kind::enable});
  rig.tell(2, {.kind = Kind::arm, .movement = &job});
  rig.tell(2, {.kind = Kind::start});
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

TEST(Machine, AFollowerOfAnActualPositionSeesWhatTheDriveSays) {
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

std::string refused(std::vector<MachineAxis> axes) {
  return error_of([&] { Machine machine(std::move(axes)); });
}

TEST(Machine, RefusesWhatIsNoMachine) {
  EXPECT_THAT(refused({}), HasSubstr("needs one axis"));
  EXPECT_THAT(refused({axis("a"), axis("a")}), HasSubstr("name = a: another axis"));
  EXPECT_THAT(refused({axis("")}), HasSubstr("needs a name"));
  EXPECT_THAT(refused({axis("a", {.what = What::master, .index = 0})}),
              HasSubstr("no such master"));
  EXPECT_THAT(refused({axis("a", setpoint_of(1))}), HasSubstr("no such axis"));
  EXPECT_THAT(refused({axis("a", setpoint_of(0))}), HasSubstr("cannot follow itself"));
  EXPECT_THAT(refused({axis("a", setpoint_of(1)), axis("b", setpoint_of(0))}), HasSubstr("ring"));
  MachineAxis slow = axis("slow");
  slow.config.period = 2'000'000;
  EXPECT_THAT(refused({axis("a"), slow}), HasSubstr("slow.cycle = 0.002: all axes"));
  std::vector<MachineAxis> many;
  for (int i = 0; i < 64; ++i) many.push_back(axis("a" + std::to_string(i)));
  EXPECT_EQ(Machine{many}.size(), 64U);
  many.push_back(axis("one too many"));
  EXPECT_THAT(refused(many), HasSubstr("64"));
  // What was measured is no reason not to follow each other.
  EXPECT_EQ(refused({axis("a", {.what = What::actual, .index = 1}),
                     axis("b", {.what = What::actual, .index = 0})}),
            "nothing is thrown");
}

}  // namespace
}  // namespace jounce
