// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/drive.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/drive/recording_drive.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::drive_test {
namespace {

TEST(NullDrive, HasItsSetpointInTheNextCycle) {
  NullDrive drive(7);
  EXPECT_EQ(drive.feedback().position, 7);
  drive.command({.position = 1.25, .velocity = -3});
  const Feedback said = drive.feedback();
  EXPECT_EQ(said.position, 1.25);
  EXPECT_EQ(said.velocity, -3);
  EXPECT_TRUE(std::isnan(said.torque));
  EXPECT_TRUE(said.ready);
  EXPECT_FALSE(said.fault);
}

TEST(DriveSetpoint, HasTheSetpointOfTheTick) {
  Tick tick;
  EXPECT_FALSE(drive_setpoint(tick, {}).enable);
  tick.tick = 12;
  tick.time = 0.012;
  tick.position = 40;
  tick.offset = 35;
  tick.velocity = 3;
  tick.acceleration = -7;
  tick.power = true;
  const DriveSetpoint asked = drive_setpoint(tick, {command::SetPosition{}});
  EXPECT_EQ(asked.tick, 12);
  EXPECT_EQ(asked.time, 0.012);
  EXPECT_EQ(asked.position, 5) << "where it was before it was called 40";
  EXPECT_EQ(asked.velocity, 3);
  EXPECT_EQ(asked.acceleration, -7);
  EXPECT_TRUE(asked.enable);
  EXPECT_FALSE(asked.reset);
  EXPECT_TRUE(drive_setpoint(tick, {command::Reset{}}).reset);
  tick.refused = Refusal{.cause = Cause::not_enabled};
  EXPECT_FALSE(drive_setpoint(tick, {command::Reset{}}).reset);
}

TEST(RecordingDrive, KeepsTheLastAndPassesOn) {
  NullDrive behind;
  RecordingDrive recording(behind, 3);
  EXPECT_EQ(recording.size(), 0U);
  for (int i = 1; i <= 5; ++i) recording.command({.tick = i, .position = 10.0 * i});
  ASSERT_EQ(recording.size(), 3U);
  EXPECT_EQ(recording.count(), 5U);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(recording[i].tick, static_cast<std::int64_t>(i) + 3);
  EXPECT_EQ(recording.feedback().position, 50);
  EXPECT_THROW(RecordingDrive(behind, 0), InputError);
}

}  // namespace
}  // namespace jounce::drive_test
