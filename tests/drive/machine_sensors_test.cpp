// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/machine_sensors.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

namespace jounce::machine_sensors_test {
namespace {

TEST(MachineSensors, ASwitchIsOnFromItsPositionForItsWidth) {
  SimulatedSwitch cam({.position = 10, .width = 5});
  const auto at = [&](double p) { return cam.step(p, p, 1e-3); };
  EXPECT_FALSE(at(9.999).on);
  EXPECT_TRUE(at(10).on);
  EXPECT_TRUE(at(14.999).on);
  EXPECT_FALSE(at(15).on);
  EXPECT_TRUE(std::isnan(at(15).edge));
}

TEST(MachineSensors, TheFirstEdgeOnTheWayIsLatched) {
  SimulatedSwitch cam({.position = 10, .width = 5});
  const Sensor in = cam.step(9, 12, 1e-3);
  EXPECT_TRUE(in.wired && in.on);
  EXPECT_EQ(in.edge, 10);
  const Sensor over = cam.step(9, 16, 1e-3);  // both edges in one cycle
  EXPECT_FALSE(over.on);
  EXPECT_EQ(over.edge, 10);
  EXPECT_EQ(cam.step(16, 9, 1e-3).edge, 15);
}

TEST(MachineSensors, AnInvertedSwitchIsOnElsewhere) {
  SimulatedSwitch cam({.position = 10, .width = 5, .inverted = true});
  EXPECT_TRUE(cam.step(9, 9, 1e-3).on);
  EXPECT_FALSE(cam.step(9, 10, 1e-3).on);
  SimulatedSwitch below(negative_switch(-100));
  EXPECT_TRUE(below.step(-100.001, -100.001, 1e-3).on);
  EXPECT_FALSE(below.step(-100, -100, 1e-3).on);
}

TEST(MachineSensors, AContactBouncesForItsTimeAndEndsOnItsLevel) {
  SimulatedSwitch cam({.position = 10, .bounce = 0.005});
  EXPECT_TRUE(cam.step(9.9, 10.1, 1e-3).on);
  int changes = 0;
  bool on = true;
  for (int k = 0; k < 20; ++k) {
    const Sensor now = cam.step(10.1, 10.1, 1e-3);
    EXPECT_EQ(now.on != on, std::isfinite(now.edge)) << k;
    changes += now.on != on;
    on = now.on;
  }
  EXPECT_EQ(changes, 4);
  EXPECT_TRUE(on);
}

TEST(MachineSensors, TheIndexComesOnceAPeriod) {
  const MachineIndex index{.period = 10, .offset = 3};
  EXPECT_TRUE(std::isnan(index_between(index, 4, 12.9)));
  EXPECT_EQ(index_between(index, 4, 13), 13);
  EXPECT_EQ(index_between(index, 13, 4), 13);
  EXPECT_EQ(index_between(index, 12, 2), 3);
  EXPECT_EQ(index_between(index, 2, 50), 3) << "the first on the way";
  EXPECT_EQ(index_between(index, -6, -8), -7);
}

TEST(MachineSensors, TheEncoderCountsFromElsewhere) {
  DriveOnMachine drive(std::make_shared<NullDrive>(0),
                       {.encoder_offset = 40,
                        .home = MachineSwitch{.position = 50},
                        .index = MachineIndex{.period = 100, .offset = 45}},
                       1e-3);
  EXPECT_FALSE(drive.feedback().sensors.home.on);
  EXPECT_FALSE(drive.feedback().sensors.positive.wired);
  drive.command({.position = 12, .enable = true});
  const Feedback now = drive.feedback();
  EXPECT_EQ(now.position, 12);
  EXPECT_TRUE(now.sensors.home.on);
  EXPECT_EQ(now.sensors.home.edge, 10);
  EXPECT_EQ(now.sensors.index.edge, 5);
}

TEST(MachineSensors, RejectWhatNoSwitchCanBe) {
  EXPECT_THROW(SimulatedSwitch({.width = 0}), InputError);
  EXPECT_THROW(SimulatedSwitch({.bounce = -1}), InputError);
  EXPECT_THROW(SimulatedSwitch({.position = NAN}), InputError);
  const auto drive = std::make_shared<NullDrive>(0);
  EXPECT_THROW(DriveOnMachine(drive, {.index = MachineIndex{}}, 1e-3), InputError);
  EXPECT_THROW(DriveOnMachine(drive, {.encoder_offset = INFINITY}, 1e-3), InputError);
}

TEST(MachineMarks, ReportTheExactInstantsOfTheirEdges) {
  const SimulatedMarks marks(
      {.first = 10, .distance = 100, .width = 4, .missing = {2}, .extra = {250}});
  Triggers seen;
  marks.step(105, 115, 1e-3, 0, seen);
  ASSERT_EQ(seen.count, 2);
  EXPECT_EQ(seen.wired, 1);
  EXPECT_TRUE(seen.change[0].rising);
  EXPECT_NEAR(seen.change[0].age, 0.5e-3, 1e-15);
  EXPECT_EQ(seen.change[0].position, 110);
  EXPECT_FALSE(seen.change[1].rising);
  EXPECT_NEAR(seen.change[1].age, 0.1e-3, 1e-15);
  EXPECT_TRUE(marks.at(110));
  EXPECT_FALSE(marks.at(114));
  EXPECT_FALSE(marks.at(211)) << "it is missing";
  EXPECT_TRUE(marks.at(251)) << "a false mark";
  EXPECT_FALSE(marks.at(-88)) << "before the first";
  Triggers back;
  marks.step(115, 109, 1e-3, 2e-3, back);
  ASSERT_EQ(back.count, 2);
  EXPECT_NEAR(back.change[0].age + back.change[1].age, 4e-3 + (5.0 + 1.0) / 6 * 1e-3, 1e-12);
}

TEST(MachineMarks, WanderAndEnd) {
  const SimulatedMarks marks(
      {.first = 0, .distance = 100, .width = 1, .wander = 10, .wander_marks = 4, .count = 3});
  EXPECT_TRUE(marks.at(110.5));  // sin(pi/2)
  EXPECT_TRUE(marks.at(200.5));
  EXPECT_FALSE(marks.at(290.5));
}

TEST(MachineMarks, MoreChangesThanFitAreLost) {
  const SimulatedMarks marks({.first = 1, .distance = 1, .width = 0.2});
  Triggers seen;
  marks.step(0.5, 9.5, 1e-3, 0, seen);
  EXPECT_EQ(seen.count, Triggers::most_changes);
}

TEST(MachineMarks, OfNumbersThatADoubleCannotCountDoNotExist) {
  const SimulatedMarks marks({.distance = 1, .width = 0.2});
  EXPECT_FALSE(marks.at(1e17));
  Triggers seen;
  marks.step(1e17, 2e17, 1e-3, 0, seen);
  EXPECT_EQ(seen.count, 0);
}

// Marks on the master: the drive reports an edge one cycle later, with its age.
TEST(MachineMarks, OnTheMasterAreReportedByTheDrive) {
  MachineSensorsSpec spec;
  spec.marks.push_back({.input = 3, .on_master = true, .first = 10, .distance = 100, .width = 4});
  DriveOnMachine drive(std::make_shared<NullDrive>(), spec, 1e-3);
  EXPECT_EQ(drive.feedback().triggers.wired, 0b100);
  drive.command({.tick = 5, .master = 8});
  EXPECT_EQ(drive.feedback().triggers.count, 0);
  drive.command({.tick = 6, .master = 12});
  const Triggers seen = drive.feedback().triggers;
  ASSERT_EQ(seen.count, 1);
  EXPECT_EQ(seen.on, 0b100);
  EXPECT_EQ(seen.change[0].input, 3);
  EXPECT_NEAR(seen.change[0].age, 1.5e-3, 1e-15);
  EXPECT_TRUE(std::isnan(seen.change[0].position));
  drive.command({.tick = 7});  // the master is lost
  EXPECT_EQ(drive.feedback().triggers.count, 0);
}

// Two cycles are left out before the second setpoint, and three before the feedback.
TEST(MachineMarks, HaveTheirAgeAfterLateCycles) {
  MachineSensorsSpec spec;
  spec.marks.push_back({.on_master = true, .first = 10, .distance = 100, .width = 4});
  DriveOnMachine drive(std::make_shared<NullDrive>(), spec, 1e-3);
  drive.command({.tick = 5, .master = 8});
  drive.command({.tick = 8, .master = 12});
  drive.begin(12);
  const Triggers seen = drive.feedback().triggers;
  ASSERT_EQ(seen.count, 1);
  EXPECT_NEAR(seen.change[0].age, 4e-3 + 1.5e-3, 1e-15);
}

TEST(MachineMarks, InvalidOnesAreRejectedByTheirKeys) {
  const MachineMarks good{.first = 0, .distance = 10, .width = 1};
  for (const auto& [key, bad] : std::vector<std::pair<std::string, MachineMarks>>{
           {"input", {.input = 5, .distance = 10, .width = 1}},
           {"distance", {.distance = 0, .width = 1}},
           {"width", {.distance = 10, .width = 5}},
           {"wander", {.distance = 10, .width = 1, .wander = 3}}}) {
    MachineSensorsSpec spec;
    spec.marks = {good, bad};
    try {
      DriveOnMachine drive(std::make_shared<NullDrive>(), spec, 1e-3);
      ADD_FAILURE() << key;
    } catch (const InputError& error) {
      EXPECT_EQ(error.key(), "machine.marks[2]." + key);
    }
  }
}

}  // namespace
}  // namespace jounce::machine_sensors_test
