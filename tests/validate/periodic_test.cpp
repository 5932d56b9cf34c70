// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/validate/linear_drive.hpp"
#include "jounce/validate/loop.hpp"

#include "support/errors.hpp"
#include "validate/references.hpp"

namespace jounce::periodic_test {
namespace {

Drive strong() {
  Drive drive = servo_400w();
  drive.motor.torque_limit = 1e6;
  return drive;
}

Drive with_everything() {
  Drive drive = strong();
  drive.motor.current_lag = 2e-4;
  drive.controller.delay = 3e-4;
  drive.controller.torque_feed_forward = 0.7;
  drive.train[0].load_torque = 0.2;
  drive.pendulum = Pendulum{6, 0.05, 0.3};
  return drive;
}

Drive without_integral() {
  Drive drive = with_everything();
  drive.controller.integral_time = 0;
  return drive;
}

/// A rise, and the way back at once: nothing comes to rest before the next period.
Trajectory to_and_fro() {
  return Trajectory({quintic(0.06, 0, 0, 0, 90, 0, 0), quintic(0.05, 90, 0, 0, 0, 0, 0)}, 2,
                    Extrapolation::hold);
}

/// A rotary slave, with a step of velocity where the period begins anew.
Trajectory advancing() {
  return Trajectory({quintic(0.1, 0, 800, 0, 360, 5000, 0)}, 0, Extrapolation::hold);
}

Trajectory repeated(const Trajectory& period, int times) {
  std::vector<Segment> segments;
  const double advance =
      period.jet(period.end(), Side::left)[0] - period.jet(period.start(), Side::right)[0];
  for (int k = 0; k < times; ++k)
    for (const Segment& f : period.segments()) segments.push_back(scaled(f, 1, k * advance));
  return Trajectory(segments, period.start(), Extrapolation::hold);
}

std::vector<double> instants(const Trajectory& period, int count) {
  std::vector<double> times;
  for (int i = 0; i < count; ++i)
    times.push_back(period.start() + period.length() * (i + 0.5) / count);
  return times;
}

TEST(ExactPeriod, IsWhatManyPeriodsTendTo) {
  for (const Trajectory& period : {to_and_fro(), advancing()})
    for (const Drive& drive : {strong(), with_everything(), without_integral()}) {
      constexpr int many = 300;  // the pendulum's mode has decayed by 1e-20 by then
      const std::vector<double> times = instants(period, 40);
      std::vector<double> late = times;
      for (double& t : late) t += (many - 1) * period.length();
      const ExactRun steady = exact_period(period, drive, times);
      const ExactRun waited = exact_run(repeated(period, many), drive, late);
      for (std::size_t i = 0; i < times.size(); ++i) {
        ASSERT_NEAR(steady.samples[i].following_error, waited.samples[i].following_error, 1e-8);
        ASSERT_NEAR(steady.samples[i].torque, waited.samples[i].torque, 1e-8);
        ASSERT_NEAR(steady.samples[i].velocity, waited.samples[i].velocity, 1e-7);
      }
    }
}

TEST(ExactPeriod, EndsAsItBegan) {
  const Trajectory period = to_and_fro();
  for (const Drive& drive : {strong(), with_everything(), without_integral()}) {
    const std::vector<double> ends{period.start(), period.end()};
    const ExactRun run = exact_period(period, drive, ends);
    EXPECT_NEAR(run.samples[0].motor, run.samples[1].motor, 1e-11 * 90);
    EXPECT_NEAR(run.samples[0].load, run.samples[1].load, 1e-11 * 90);
    EXPECT_NEAR(run.samples[0].velocity, run.samples[1].velocity, 1e-9);
  }
}

TEST(ExactPeriod, IsNotTheRunFromRest) {
  const Trajectory period = to_and_fro();
  const std::vector<double> times = instants(period, 3);
  EXPECT_GT(std::abs(exact_period(period, strong(), times).samples[0].following_error -
                     exact_run(period, strong(), times).samples[0].following_error),
            1e-3);
}

TEST(PeriodicDrive, IntegratesBackToWhereItBegan) {
  for (const Trajectory& period : {to_and_fro(), advancing()})
    for (const Drive& drive : {strong(), with_everything(), without_integral()}) {
      const DriveOptions options{.samples = 101, .tolerance = 1e-10, .periodic = true};
      const DriveResult run = drive_through(period, drive, options);
      ASSERT_TRUE(run.integration.ok());
      bool told = false;
      for (const Finding& f : run.report.findings) {
        if (f.rule == "drive/periodic" || f.rule == "drive/exact") {
          EXPECT_LT(f.value, 1e-8) << f.rule;
        }
        told = told || f.rule == "drive/periodic";
      }
      EXPECT_TRUE(told);
      const DriveResult exact = exact_through(period, drive, options).value();
      EXPECT_NEAR(exact.rms_torque, run.rms_torque, 1e-7 * run.rms_torque);
      EXPECT_NEAR(exact.torque.value, run.torque.value, 1e-4 * std::abs(run.torque.value));
      EXPECT_EQ(exact.residual.value, 0);
      EXPECT_FALSE(exact.settling_time);
      EXPECT_EQ(exact.samples.size(), 101u);
      EXPECT_NEAR(exact.integration.reached, period.end(), 1e-12);
    }
}

TEST(PeriodicDrive, OfACamBehindASteadyMaster) {
  CamSpec spec{{0, 0, 0, 0}, {}, true};
  spec.segments = {{Law::modified_sine, {150, 40, {}, {}}, ""},
                   {Law::poly345, {360, 0, {}, {}}, ""}};
  const Followed slave(design(spec).cam, Trajectory({line(0.2, 0, 360)}, 0, Extrapolation::hold));
  const DriveResult run = drive_through(slave, strong(), {.periodic = true});
  EXPECT_TRUE(run.integration.ok());
  EXPECT_GT(run.rms_torque, 0);
}

TEST(PeriodicDrive, ReportsATorqueAtItsLimit) {
  Drive weak = servo_400w();
  weak.motor.torque_limit = 0.3;
  const DriveResult run = drive_through(to_and_fro(), weak, {.periodic = true});
  EXPECT_FALSE(run.saturation.empty());
  EXPECT_FALSE(run.report.ok());
  EXPECT_FALSE(exact_through(to_and_fro(), weak, {.periodic = true}));
}

/// The same finding as without `periodic`, and no run: there is no steady state.
TEST(PeriodicDrive, ReportsAnUnstableLoop) {
  Drive drive = strong();
  drive.motor.current_lag = 5e-3;
  drive.controller.position_gain = 1e4;
  const Finding expected = unstable_loop(drive).value();
  const DriveResult run = drive_through(to_and_fro(), drive, {.samples = 11, .periodic = true});
  const DriveResult exact = exact_through(to_and_fro(), drive, {.periodic = true}).value();
  for (const DriveResult& each : {run, exact}) {
    EXPECT_FALSE(each.integration.ok());
    EXPECT_NE(each.integration.reason.find("no periodic steady state"), std::string::npos);
    ASSERT_EQ(each.report.findings.size(), 1U);
    EXPECT_TRUE(each.report.findings[0].broken);
    EXPECT_EQ(each.report.findings[0].rule, "drive/stability");
    EXPECT_EQ(each.report.findings[0].where, expected.where);
    EXPECT_EQ(each.report.findings[0].value, expected.value);
  }
  const std::vector<double> start{2};  // the exact solution itself has nothing to return
  EXPECT_THROW(exact_period(to_and_fro(), drive, start), InputError);
}

template <class Change>
std::string refused(Change change) {
  Drive drive = strong();
  change(drive);
  return test::key_of([&] { drive_through(to_and_fro(), drive, {.periodic = true}); }, "nothing");
}

TEST(PeriodicDrive, RejectsWhatHasNoKnownSteadyState) {
  EXPECT_EQ(refused([](Drive& d) { d.motor.friction.coulomb = 0.1; }), "motor.friction.coulomb");
  EXPECT_EQ(refused([](Drive& d) { d.controller.cycle = 1e-3; }), "controller.cycle");
  EXPECT_EQ(refused([](Drive&) {}), "nothing");
  const std::vector<double> late{2, 99};
  EXPECT_THROW(exact_period(to_and_fro(), strong(), late), InputError);
}

}  // namespace
}  // namespace jounce::periodic_test
