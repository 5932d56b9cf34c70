// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/drive_stepper.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/validate/linear_drive.hpp"

#include "support/errors.hpp"
#include "validate/references.hpp"

namespace jounce::drive_stepper_test {
namespace {

/// Distance of the stepped drive from other samples at the same instants, as shares of the stroke
/// and of the peak torque.
struct Distance {
  double motor = 0;
  double load = 0;
  double torque = 0;
};

Distance distance(const Trajectory& f, const Drive& drive, double period,
                  const std::vector<DriveSample>& wanted) {
  DriveStepper stepper(drive, period);
  stepper.rest(f.jet(f.start())[0]);
  Distance most;
  double stroke = 0;
  double peak = 0;
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    const DriveSample& w = wanted[k];
    const bool over = w.time >= f.end();
    const Jet r = over ? Jet{f.jet(f.end(), Side::left)[0], 0, 0, 0} : f.jet(w.time);
    const DriveSample s = k == 0 ? stepper.now() : stepper.step(r);
    stroke = std::max(stroke, std::abs(r[0] - wanted[0].reference));
    peak = std::max(peak, std::abs(w.torque));
    most.motor = std::max(most.motor, std::abs(s.motor - w.motor));
    most.load = std::max(most.load, std::abs(s.load - w.load));
    if (k > 0) most.torque = std::max(most.torque, std::abs(s.torque - w.torque));
    EXPECT_NEAR(s.following_error, r[0] - s.motor, 1e-12 * stroke);
  }
  return {most.motor / stroke, most.load / stroke, most.torque / peak};
}

std::vector<double> every(double period, double length) {
  std::vector<double> times;
  for (int k = 0; k * period <= length * (1 + 1e-12); ++k) times.push_back(k * period);
  return times;
}

std::vector<DriveSample> integrated(const Trajectory& f, const Drive& drive, double settle,
                                    double period) {
  const auto samples = static_cast<std::size_t>(std::lround((f.length() + settle) / period)) + 1;
  return drive_through(f, drive, {.settle = settle, .samples = samples, .tolerance = 1e-9}).samples;
}

Drive unlimited(Drive drive) {
  drive.motor.torque_limit = 1e6;
  return drive;
}

TEST(DriveStepper, IsExactWhereTheReferenceIsTheQuintic) {
  const Trajectory move = test::law_345(360, 0.1);
  Drive drive = unlimited(servo_400w());
  for (const double lag : {0.0, 2e-4})
    for (const double delay : {0.0, 3e-4}) {
      SCOPED_TRACE(testing::Message() << "lag " << lag << ", delay " << delay);
      drive.motor.current_lag = lag;
      drive.controller.delay = delay;
      const auto times = every(0.001, 0.3);
      const Distance d = distance(move, drive, 0.001, exact_run(move, drive, times).samples);
      EXPECT_LT(d.motor, 1e-11);
      EXPECT_LT(d.load, 1e-11);
      EXPECT_LT(d.torque, 1e-9);
    }
}

TEST(DriveStepper, AgreesWithTheIntegrationOfAMotionWithAContinuousAcceleration) {
  for (const double scale : {360.0, 1e-3}) {
    Drive drive = servo_400w();
    drive.position_per_rev = scale;
    Segment law{.length = 0.4, .degree = 7, .c = {0, 0, 0, 0, 35, -84, 70, -20}};
    const Trajectory move({scaled(law, scale)}, 0, Extrapolation::hold);
    const Distance d = distance(move, drive, 0.001, integrated(move, drive, 0.2, 0.001));
    EXPECT_LT(d.motor, 1e-8);
    EXPECT_LT(d.load, 1e-8);
    EXPECT_LT(d.torque, 1e-5);
  }
}

TEST(DriveStepper, OfASteppingAccelerationTheErrorFallsWithTheSquareOfThePeriod) {
  const Trajectory move = test::trapezoid_move();  // its corners lie between setpoints
  const Drive drive = unlimited(servo_400w());
  const auto at = [&](double period) {
    return distance(move, drive, period,
                    exact_run(move, drive, every(period, move.length() + 0.2)).samples);
  };
  const Distance coarse = at(0.00101);
  const Distance fine = at(0.000101);
  EXPECT_LT(coarse.motor, 2e-5);
  EXPECT_LT(fine.motor, coarse.motor / 20);
}

TEST(DriveStepper, StandsAtTheTorqueLimitAsTheIntegrationDoes) {
  const Trajectory move = test::law_345(3600, 0.4);
  for (const double lag : {0.0, 5e-4})
    for (const double limit : {0.25, 0.33}) {
      SCOPED_TRACE(testing::Message() << "lag " << lag << ", limit " << limit);
      Drive drive = servo_400w();
      drive.motor.current_lag = lag;
      drive.motor.torque_limit = limit;
      const DriveResult whole = drive_through(move, drive, {.settle = 0.5});
      ASSERT_FALSE(whole.saturation.empty());
      const Distance d = distance(move, drive, 0.001, integrated(move, drive, 0.5, 0.001));
      EXPECT_LT(d.motor, 1e-7);
      EXPECT_LT(d.load, 1e-7);
      EXPECT_LT(d.torque, 2e-4);
    }
}

TEST(DriveStepper, HasLessTorqueBeyondTheRatedVelocity) {
  const Trajectory move = test::law_345(3600, 0.4);
  Drive drive = servo_400w();
  drive.motor.torque_limit = 0.5;
  drive.motor.rated_velocity = 50;
  drive.motor.max_velocity = 350;
  const DriveResult whole = drive_through(move, drive, {.settle = 0.5});
  ASSERT_FALSE(whole.saturation.empty());
  EXPECT_TRUE(std::any_of(whole.saturation.begin(), whole.saturation.end(),
                          [](const Saturation& s) { return s.envelope; }));
  const Distance d = distance(move, drive, 0.001, integrated(move, drive, 0.5, 0.001));
  EXPECT_LT(d.motor, 1e-7);
  EXPECT_LT(d.torque, 2e-4);
}

TEST(DriveStepper, ReadsRoundsLimitsAndDelaysAsASampledControllerDoes) {
  struct Case {
    double cycle, delay, counts, limit;
  };
  const Trajectory move = test::law_345(900, 0.15);
  for (const Case& c : {Case{1e-3, 1e-4, 0, 50}, Case{2.5e-4, 0, 0, 0.5},
                        Case{2.5e-4, 2.5e-4, 4096, 50}, Case{2.5e-4, 6e-4, 4096, 0.5}}) {
    SCOPED_TRACE(testing::Message()
                 << c.cycle << ' ' << c.delay << ' ' << c.counts << ' ' << c.limit);
    Drive drive = servo_400w();
    drive.motor.torque_limit = c.limit;
    drive.motor.current_lag = 2e-4;
    drive.controller.position_gain *= 0.3;
    drive.controller.velocity_gain *= 0.3;
    drive.controller.cycle = c.cycle;
    drive.controller.delay = c.delay;
    drive.controller.encoder_counts = c.counts;
    const DriveResult run =
        drive_through(move, drive, {.settle = 0.05, .samples = 201, .tolerance = 1e-11});
    ASSERT_EQ(run.saturation.empty(), c.limit == 50);
    const Distance d = distance(move, drive, 0.001, run.samples);
    EXPECT_LT(d.motor, 2e-8);
    EXPECT_LT(d.load, 2e-8);
  }
}

TEST(DriveStepper, HoldsALoadAtRest) {
  for (const double cycle : {0.0, 0.00025})
    for (const double integral : {0.0, 0.01}) {
      Drive drive = servo_400w();
      drive.train.at(0).load_torque = 0.7;
      drive.controller.cycle = cycle;
      drive.controller.integral_time = integral;
      DriveStepper stepper(drive, 0.001);
      stepper.rest(50);
      const DriveSample begin = stepper.now();
      for (int k = 0; k < 500; ++k) stepper.step({50, 0, 0, 0});
      EXPECT_NEAR(stepper.now().torque, 0.7, 1e-9);
      EXPECT_NEAR(stepper.now().motor, begin.motor, 1e-9);
      EXPECT_NEAR(stepper.now().load, begin.load, 1e-9);
      EXPECT_EQ(std::abs(stepper.now().motor - 50) < 1e-12, integral > 0);  // rounding, or 20 deg
    }
}

TEST(DriveStepper, TakesAPlaceUnderAnotherNameWithoutAMotion) {
  for (const double cycle : {0.0, 0.00025}) {
    Drive drive = servo_400w();
    drive.controller.cycle = cycle;
    DriveStepper plain(drive, 0.001);
    DriveStepper renamed(drive, 0.001);
    for (int k = 1; k < 300; ++k) {
      const double x = std::min(1.0, k / 100.0);
      const Jet r{180 * x * x * (3 - 2 * x), 180 * 6 * x * (1 - x) / 0.1,
                  x < 1 ? 180 * 6 * (1 - 2 * x) / 0.01 : 0, 0};
      const bool later = k > 150;
      if (k == 151) renamed.rename(1024);
      const DriveSample a = plain.step(r);
      const DriveSample b = renamed.step({r[0] + (later ? 1024 : 0), r[1], r[2], 0});
      EXPECT_NEAR(a.motor + (later ? 1024 : 0), b.motor, 1e-9);
      EXPECT_NEAR(a.torque, b.torque, 1e-9);
    }
  }
}

TEST(DriveStepper, SetpointsThatWereLeftOutAreBridged) {
  const Trajectory move = test::law_345(360, 0.1);  // one quintic: bridged exactly
  const Drive drive = unlimited(servo_400w());
  DriveStepper whole(drive, 0.001);
  DriveStepper gaps(drive, 0.001);
  for (int k = 1; k <= 100; ++k) whole.step(move.jet(k * 0.001, Side::left));
  int k = 0;
  for (const int gap : {1, 7, 2, 40, 50}) {
    k += gap;
    gaps.step(move.jet(k * 0.001, Side::left), gap);
  }
  EXPECT_NEAR(gaps.now().motor, whole.now().motor, 1e-9);
  EXPECT_NEAR(gaps.now().torque, whole.now().torque, 1e-7);
  EXPECT_EQ(gaps.now().time, whole.now().time);
}

TEST(DriveStepper, AFrozenSetpointIsNotLeftAgain) {
  DriveStepper stepper(unlimited(servo_400w()), 0.001);
  stepper.rest(0);
  for (int k = 1; k <= 20; ++k) stepper.step({0.5 * 1e5 * k * k * 1e-6, 1e5 * k * 1e-3, 1e5, 0});
  const double frozen = 0.5 * 1e5 * 400e-6;
  for (int k = 0; k < 3000; ++k) stepper.step({frozen, 0, 0, 0});
  EXPECT_NEAR(stepper.now().motor, frozen, 1e-9);
  EXPECT_NEAR(stepper.now().velocity, 0, 1e-9);
}

TEST(DriveStepper, RejectsByName) {
  const auto key = [](const Drive& drive, double period) {
    return test::key_of([&] { DriveStepper stepper(drive, period); }, "accepted");
  };
  Drive drive = servo_400w();
  EXPECT_EQ(key(drive, 0.001), "accepted");
  EXPECT_EQ(key(drive, 0), "period");
  drive.controller.encoder_counts = 1000;
  EXPECT_EQ(key(drive, 0.001), "controller.encoder_counts");
  drive.controller.cycle = 0.00025;
  EXPECT_EQ(key(drive, 0.001), "accepted");
  EXPECT_EQ(key(drive, 0.0011), "controller.cycle");
  EXPECT_EQ(key(drive, 0.0001), "controller.cycle");
  drive.motor.friction.coulomb = 0.01;
  EXPECT_EQ(key(drive, 0.001), "motor.friction.coulomb");
}

}  // namespace
}  // namespace jounce::drive_stepper_test
