// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/machine_sensors.hpp"

#include <cmath>

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

TEST(MachineSensors, RefuseWhatNoSwitchCanBe) {
  EXPECT_THROW(SimulatedSwitch({.width = 0}), InputError);
  EXPECT_THROW(SimulatedSwitch({.bounce = -1}), InputError);
  EXPECT_THROW(SimulatedSwitch({.position = NAN}), InputError);
  const auto drive = std::make_shared<NullDrive>(0);
  EXPECT_THROW(DriveOnMachine(drive, {.index = MachineIndex{}}, 1e-3), InputError);
  EXPECT_THROW(DriveOnMachine(drive, {.encoder_offset = INFINITY}, 1e-3), InputError);
}

}  // namespace
}  // namespace jounce::machine_sensors_test
