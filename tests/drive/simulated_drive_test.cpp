// SPDX-License-Identifier: Apache-2.0
#include "jounce/drive/simulated_drive.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/tables.hpp"

namespace jounce::simulated_drive_test {
namespace {

using test::Bench;
using test::Kind;

/// A cam of 360 by 360 deg, one turn in half a second, at rest at both ends of every law.
std::shared_ptr<const Table> smooth_cam() {
  return test::table(
      Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
      {{0, 120, 180, 300, 360}, {0, 90, 90, 0, 0}, {0, 0, 0, 0, 0}, {0, 0, 0, 0, 0}});
}

TEST(SimulatedDrive, FollowsAPlayedCamAsIntegrated) {
  const auto master = test::constant_master(360, 720);
  Job job(1, master, smooth_cam());
  Bench bench({.limits = test::limits(1e4, 1e6)});
  const Drive model = servo_400w();
  SimulatedDrive drive(model, 0.001);
  const auto cam = smooth_cam();
  const Trajectory time = master->curve<OverTime>();
  const Cam curve = cam->curve<OverMaster>();
  const Followed reference(curve, time);
  const DriveResult whole =
      drive_through(reference, model, {.settle = 0.1, .samples = 601, .tolerance = 1e-10});
  ASSERT_EQ(whole.samples.size(), 601U);

  bench.send(Kind::enable);
  bench.arm(job);
  double error = 0;
  double torque = 0;
  double most_torque = 0;
  double behind = 0;
  for (std::size_t k = 0; k <= 600; ++k) {
    const Tick tick = k == 0 ? bench.send(Kind::start) : bench.step();
    DriveSetpoint asked = drive_setpoint(tick, {});
    asked.enable = true;
    drive.command(asked);
    const DriveSample& wanted = whole.samples[k];
    const Feedback said = drive.feedback();
    error = std::max(error, std::abs(said.position - wanted.motor));
    if (k > 0)
      torque = std::max(torque, std::abs(said.torque * model.motor.torque_limit - wanted.torque));
    most_torque = std::max(most_torque, std::abs(wanted.torque));
    behind = std::max(behind, std::abs(wanted.following_error));
    EXPECT_TRUE(said.ready);
  }
  EXPECT_GT(behind, 1e-3) << "there is a following error to be seen";
  EXPECT_LT(error, 1e-6 * 90);
  EXPECT_LT(torque, 1e-3 * most_torque);
}

TEST(SimulatedDrive, StandsByItsBrakeUntilItIsEnabled) {
  Drive model = servo_400w();
  model.motor.rated_torque = 1.27;
  SimulatedDrive drive(model, 0.001, 30);
  EXPECT_EQ(drive.feedback().position, 30);
  for (std::int64_t k = 0; k < 100; ++k) {
    drive.command({.tick = k, .position = 77, .velocity = 5});
    EXPECT_EQ(drive.feedback().position, 30);
    EXPECT_EQ(drive.feedback().torque, 0);
    EXPECT_FALSE(drive.feedback().ready);
  }
  for (std::int64_t k = 100; k < 600; ++k)
    drive.command({.tick = k, .position = 31, .enable = true});
  EXPECT_TRUE(drive.feedback().ready);
  EXPECT_NEAR(drive.feedback().position, 31, 1e-6);
  drive.command({.tick = 600, .position = 32, .velocity = 1000, .enable = true});
  drive.command({.tick = 601, .position = 33, .velocity = 1000, .enable = true});
  drive.command({.tick = 602, .position = 34});
  const double stopped = drive.feedback().position;
  EXPECT_GT(stopped, 31);
  drive.command({.tick = 603, .position = 35});
  EXPECT_EQ(drive.feedback().position, stopped);
  EXPECT_EQ(drive.feedback().velocity, 0);
}

TEST(SimulatedDrive, ReportsTheTorqueAsAShareOfTheRatedOne) {
  for (const double rated : {0.0, 1.25}) {
    Drive model = servo_400w();
    model.motor.rated_torque = rated;
    model.train.at(0).load_torque = 0.5;
    SimulatedDrive drive(model, 0.001);
    for (std::int64_t k = 0; k < 2000; ++k) drive.command({.tick = k, .enable = true});
    EXPECT_NEAR(drive.feedback().torque, 0.5 / (rated > 0 ? rated : model.motor.torque_limit),
                1e-6);
  }
}

TEST(SimulatedDrive, RejectsWhatItCannotBe) {
  Drive model = servo_400w();
  model.train.at(0).backlash = 0.01;
  EXPECT_THROW(SimulatedDrive(model, 0.001), InputError);
}

}  // namespace
}  // namespace jounce::simulated_drive_test
