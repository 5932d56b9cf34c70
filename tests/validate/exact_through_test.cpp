// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/validate/linear_drive.hpp"
#include "jounce/validate/tolerances.hpp"

#include "support/random.hpp"
#include "validate/references.hpp"

namespace jounce::exact_through_test {
namespace {

Trajectory s_curve_move() {
  return s_curve({.from = 0, .to = 720, .velocity = 5000, .acceleration = 40'000, .jerk = 1e6})
      .curve();
}

Trajectory trapezoid_move() {
  return trapezoid({.from = 0, .to = 360, .velocity = 4000, .acceleration = 30'000}).curve();
}

Drive two_mass() {
  Drive drive = servo_400w();
  drive.motor.torque_limit = 1e6;
  return drive;
}

Drive with_everything() {
  Drive drive = two_mass();
  drive.motor.current_lag = 2e-4;
  drive.motor.torque_constant = 0.5;
  drive.motor.resistance = 2;
  drive.motor.rated_torque = 1.2;
  drive.motor.thermal_time = 600;
  drive.controller.delay = 3e-4;
  drive.controller.torque_feed_forward = 0.7;
  drive.train[0].load_torque = 0.2;
  drive.pendulum = Pendulum{6, 0.05, 0.3};
  return drive;
}

Drive rigid() {
  Drive drive = two_mass();
  drive.train[0].stiffness = drive.train[0].damping = 0;
  return drive;
}

std::vector<Drive> drives() {
  return {two_mass(), with_everything(), rigid()};
}

std::vector<Trajectory> moves() {
  return {s_curve_move(), trapezoid_move(), test::law_345(360, 0.1)};
}

DriveResult run(const Trajectory& move, const Drive& drive, const DriveOptions& options = {}) {
  const auto found = exact_through(move, drive, options);
  EXPECT_TRUE(found);
  return found.value_or(DriveResult{});
}

std::vector<double> instants(double from, double to, int count) {
  std::vector<double> times;
  for (int i = 0; i <= count; ++i) times.push_back(from + (to - from) * i / count);
  return times;
}

// ---- peaks --------------------------------------------------------------------------------------

/// No instant of many has more, and the instant that is named has it.
void expect_peak(const Peak& peak, double DriveSample::*what, const Trajectory& move,
                 const Drive& drive, double from, double to) {
  const ExactRun dense = exact_run(move, drive, instants(from, to, 20'000));
  double most = 0;
  for (const DriveSample& s : dense.samples) most = std::max(most, std::abs(s.*what));
  EXPECT_LE(most, std::abs(peak.value) * (1 + 1e-10));
  // at a step of acceleration the torque has two limits, and the peak may be the other
  const std::vector<double> there{std::max(from, peak.where - 1e-9), peak.where, peak.where + 1e-9};
  double nearest = INFINITY;
  for (const DriveSample& s : exact_run(move, drive, there).samples)
    nearest = std::min(nearest, std::abs(s.*what - peak.value));
  EXPECT_LE(nearest, 2e-6 * std::abs(peak.value));
}

TEST(ExactThrough, PeaksAreThoseOfTheWholeMotion) {
  for (const Trajectory& move : moves())
    for (const Drive& drive : drives()) {
      const DriveResult found = run(move, drive);
      const double end = move.end() + 0.2;
      expect_peak(found.torque, &DriveSample::torque, move, drive, 0, end);
      expect_peak(found.velocity, &DriveSample::velocity, move, drive, 0, end);
      expect_peak(found.following_error, &DriveSample::following_error, move, drive, 0, end);
    }
}

TEST(ExactThrough, APeakIsAStationaryPointToRounding) {
  const Trajectory move = test::law_345(360, 0.1);
  for (const Drive& drive : drives()) {
    const Peak peak = run(move, drive).following_error;
    const double near = 1e-5;
    const std::vector<double> times{peak.where - near, peak.where, peak.where + near};
    const ExactRun about = exact_run(move, drive, times);
    EXPECT_NEAR(about.samples[1].following_error, peak.value, 1e-11 * 360);
    EXPECT_LT(std::abs(about.samples[0].following_error), std::abs(peak.value));
    EXPECT_LT(std::abs(about.samples[2].following_error), std::abs(peak.value));
  }
}

TEST(ExactThrough, AgreesWithTheIntegration) {
  for (const Trajectory& move : moves())
    for (const Drive& drive : drives()) {
      DriveOptions options;
      options.tolerance = 1e-11;
      options.limits.settling_band = 0.02;
      options.limits.following_error = 0.05;
      options.sync = {{0.02, 0.05}};
      const DriveResult exact = run(move, drive, options);
      const DriveResult by_steps = drive_through(move, drive, options);
      ASSERT_TRUE(by_steps.integration.ok());
      // integrals, within 1e-8
      EXPECT_NEAR(exact.rms_torque, by_steps.rms_torque, 1e-8 * by_steps.rms_torque);
      EXPECT_NEAR(exact.rms_current, by_steps.rms_current, 1e-8 * by_steps.rms_current);
      EXPECT_NEAR(exact.energy.copper, by_steps.energy.copper, 1e-8 * by_steps.energy.copper);
      const double work = by_steps.energy.driving + by_steps.energy.regenerated;
      EXPECT_NEAR(exact.energy.driving - exact.energy.regenerated,
                  by_steps.energy.driving - by_steps.energy.regenerated, 1e-8 * work);
      EXPECT_NEAR(exact.end_following_error, by_steps.end_following_error, 1e-8 * 360);
      // the curve is a parabola there
      const auto near = [](const Peak& a, const Peak& b) {
        EXPECT_NEAR(a.value, b.value, 1e-4 * std::abs(b.value) + 1e-12);
        EXPECT_GE(std::abs(a.value), std::abs(b.value) * (1 - 1e-4));
      };
      near(exact.torque, by_steps.torque);
      near(exact.velocity, by_steps.velocity);
      near(exact.current, by_steps.current);
      near(exact.following_error, by_steps.following_error);
      near(exact.residual, by_steps.residual);
      near(exact.swing, by_steps.swing);
      near(exact.i2t, by_steps.i2t);
      EXPECT_LE(std::abs(exact.sync_following_error.value),
                std::abs(by_steps.sync_following_error.value) * (1 + 1e-4));
      EXPECT_NEAR(exact.energy.driving, by_steps.energy.driving, 2e-4 * work);
      ASSERT_EQ(exact.settling_time.has_value(), by_steps.settling_time.has_value());
      EXPECT_NEAR(exact.settling_time.value_or(0), by_steps.settling_time.value_or(0), 1e-6);
      ASSERT_EQ(exact.beyond_following_error.size(), by_steps.beyond_following_error.size());
      for (std::size_t i = 0; i < exact.beyond_following_error.size(); ++i) {
        EXPECT_NEAR(exact.beyond_following_error[i].from, by_steps.beyond_following_error[i].from,
                    1e-6);
        EXPECT_NEAR(exact.beyond_following_error[i].to, by_steps.beyond_following_error[i].to,
                    1e-6);
      }
      EXPECT_NEAR(exact.residual_frequency, by_steps.residual_frequency,
                  0.02 * by_steps.residual_frequency);
    }
}

// ---- integrals and zeros ------------------------------------------------------------------------

TEST(ExactThrough, WorkIsDividedWhereThePowerTurns) {
  const Trajectory move = test::law_345(360, 0.1);
  for (const Drive& drive : drives()) {
    const DriveResult found = run(move, drive, {.settle = 0});
    const int count = 200'000;
    const ExactRun dense = exact_run(move, drive, instants(0, move.end(), count));
    double driving = 0;
    for (std::size_t i = 1; i < dense.samples.size(); ++i) {
      const auto power = [&](std::size_t k) {
        return std::max(0.0, dense.samples[k].torque * dense.samples[k].velocity);
      };
      driving += (power(i - 1) + power(i)) / 2 * move.end() / count;
    }
    EXPECT_NEAR(found.energy.driving, driving, 1e-8 * driving);
  }
}

TEST(ExactThrough, TheLoadStaysWithinTheBandFromTheSettlingTimeOn) {
  const Trajectory move = trapezoid_move();
  Drive drive = two_mass();
  drive.train[0].damping = 1e-3;
  const double band = 0.05;
  DriveOptions options;
  options.settle = 1;
  options.limits.settling_band = band;
  const DriveResult found = run(move, drive, options);
  ASSERT_TRUE(found.settling_time);
  const double since = move.end() + *found.settling_time;
  const std::vector<double> entry{since};
  EXPECT_NEAR(std::abs(exact_run(move, drive, entry).samples[0].load - 360), band, 1e-9);
  for (const DriveSample& s : exact_run(move, drive, instants(since, move.end() + 1, 5000)).samples)
    ASSERT_LE(std::abs(s.load - 360), band * (1 + 1e-9));
  for (const Interval& i : found.beyond_following_error) EXPECT_LT(i.from, i.to);
}

TEST(ExactThrough, TheFrequencyIsThatOfTheMode) {
  const Trajectory move = trapezoid_move();
  Drive drive = two_mass();
  drive.pendulum = Pendulum{12, 0.001, 0.1};
  drive.train[0].damping = 0.05;
  const DriveResult found = run(move, drive, {.settle = 4});
  double nearest = INFINITY;
  for (const DriveMode& mode : modes(drive))
    nearest = std::min(nearest, std::abs(mode.frequency - found.residual_frequency));
  EXPECT_LT(nearest, 0.02);
}

TEST(ExactThrough, AStandstillDoesNothing) {
  const Trajectory still({line(5, 10, 10)}, 3, Extrapolation::hold);
  for (const Drive& drive : drives()) {
    const DriveResult found = run(still, drive);
    // the twist of a loaded shaft, a quarter of a degree, is solved for to rounding
    EXPECT_NEAR(found.velocity.value, 0, 1e-11);
    EXPECT_NEAR(found.following_error.value, 0, 1e-11);
    EXPECT_NEAR(found.energy.driving, 0, 1e-12);
    EXPECT_EQ(found.residual_frequency, 0);
  }
}

TEST(ExactThrough, PlaceAndInstantOfTheStartDoNotMatter) {
  const Trajectory move = s_curve_move();
  const DriveResult here = run(move, with_everything());
  const DriveResult far = run(shifted(move, 64, 4096), with_everything());
  EXPECT_NEAR(far.torque.value, here.torque.value, 1e-9 * here.torque.value);
  EXPECT_NEAR(far.torque.where, here.torque.where + 64, 1e-9);
  EXPECT_NEAR(far.residual.value, here.residual.value, 1e-9);
}

// ---- where there is none ------------------------------------------------------------------------

TEST(ExactThrough, IsEmptyForAnotherDrive) {
  const Trajectory move = s_curve_move();
  Drive rubs = two_mass();
  rubs.motor.friction.coulomb = 0.1;
  EXPECT_FALSE(exact_through(move, rubs));
  Drive sampled = two_mass();
  sampled.controller.cycle = 1e-3;
  EXPECT_FALSE(exact_through(move, sampled));
}

TEST(ExactThrough, IsEmptyWhereTheTorqueMeetsItsLimit) {
  const Trajectory move = s_curve_move();
  for (Drive drive : drives()) {
    drive.motor.current_lag = 0;  // the torque asked for is the torque
    const double peak = std::abs(run(move, drive).torque.value);
    drive.motor.torque_limit = peak * (1 + 1e-9);
    EXPECT_TRUE(exact_through(move, drive));
    drive.motor.torque_limit = peak * (1 - 1e-9);
    EXPECT_FALSE(exact_through(move, drive));
  }
}

TEST(ExactThrough, IncludesTheLimitAtHighSpeed) {
  const Trajectory move = s_curve_move();
  Drive drive = servo_400w();
  drive.motor.rated_velocity = 10;
  drive.motor.max_velocity = 1000;
  EXPECT_TRUE(exact_through(move, drive));
  drive.motor.max_velocity = 1.001 * std::abs(run(move, drive).velocity.value);
  const bool saturates = !drive_through(move, drive).saturation.empty();
  EXPECT_TRUE(saturates);
  EXPECT_EQ(exact_through(move, drive).has_value(), !saturates);
}

TEST(ExactThrough, RejectsWhatTheRunRejects) {
  const Trajectory move = s_curve_move();
  DriveOptions options;
  options.sync = {{0.1, 99}};
  EXPECT_THROW(exact_through(move, two_mass(), options), InputError);
  Drive none = two_mass();
  none.motor.inertia = 0;
  EXPECT_THROW(exact_through(move, none), InputError);
}

// ---- random -------------------------------------------------------------------------------------

TEST(ExactThrough, HoldsForRandomDrives) {
  test::Random random(3);
  const Trajectory move = test::law_345(360, 0.08);
  int stable = 0;
  for (int i = 0; i < 60; ++i) {
    Drive drive = two_mass();
    drive.train[0].inertia *= random.log_uniform(0.3, 3);
    drive.train[0].stiffness *= random.log_uniform(0.2, 30);
    drive.train[0].damping *= random.log_uniform(0.1, 3);
    drive.controller.position_gain *= random.log_uniform(0.3, 2);
    drive.motor.current_lag = random.log_uniform(1e-6, 1e-3);
    bool grows = false;
    for (const DriveMode& mode : modes(drive)) grows = grows || mode.rate <= 1;
    if (grows) continue;
    ++stable;
    SCOPED_TRACE("case " + std::to_string(i));
    const DriveResult found = run(move, drive);
    const ExactRun dense = exact_run(move, drive, instants(0, move.end() + 0.2, 5000));
    for (const DriveSample& s : dense.samples) {
      ASSERT_LE(std::abs(s.torque), std::abs(found.torque.value) * (1 + 1e-10)) << s.time;
      ASSERT_LE(std::abs(s.following_error), std::abs(found.following_error.value) * (1 + 1e-10));
      const double residual = s.time > move.end() ? std::abs(s.load - 360) : 0;
      ASSERT_LE(residual, std::abs(found.residual.value) * (1 + 1e-10));
    }
    EXPECT_NEAR(found.rms_torque, dense.rms_torque, 1e-10 * dense.rms_torque);
  }
  EXPECT_GT(stable, 40);
}

}  // namespace
}  // namespace jounce::exact_through_test
