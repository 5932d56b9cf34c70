#include "jounce/executor/drive.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/executor/recording_drive.hpp"
#include "jounce/profiles/error.hpp"

#include "tables.hpp"

namespace jounce {
namespace {

using test::Bench;
using test::Kind;

TEST(NullDrive, IsInTheNextCycleWhereItWasToldToBe) {
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

TEST(DriveSetpoint, SaysWhatTheTickDoes) {
  Bench bench({.limits = test::limits(1000, 1e4), .position = 5});
  const Tick off = bench.step();
  EXPECT_FALSE(drive_setpoint(off, {}, off).enable);
  const Tick on = bench.tell(Kind::enable);
  EXPECT_TRUE(drive_setpoint(on, {.kind = Kind::enable}, off).enable);
  EXPECT_EQ(drive_setpoint(on, {.kind = Kind::enable}, off).position, 5);

  const Command rename{.kind = Kind::set_position, .position = 40};
  const Tick named = bench.step(rename);
  EXPECT_EQ(drive_setpoint(named, rename, on).renamed, 35);
  const Tick after = bench.step();
  EXPECT_EQ(drive_setpoint(after, {}, named).renamed, 0);

  const Tick failed = bench.tell(Kind::abort);
  EXPECT_TRUE(drive_setpoint(failed, {.kind = Kind::abort}, after).quick_stop);
  const Tick refused = bench.step(rename);
  EXPECT_EQ(drive_setpoint(refused, rename, failed).renamed, 0) << "it was refused";
  const Tick well = bench.tell(Kind::reset);
  EXPECT_TRUE(drive_setpoint(well, {.kind = Kind::reset}, refused).reset);
  EXPECT_FALSE(drive_setpoint(well, {.kind = Kind::reset}, refused).quick_stop);
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
}  // namespace jounce
