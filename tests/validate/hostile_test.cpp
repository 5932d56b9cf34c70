// SPDX-License-Identifier: Apache-2.0
// Attempts of a hostile reader: every balance that physics keeps, and meaningless input.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/validate/drive.hpp"
#include "jounce/validate/follower.hpp"
#include "jounce/validate/identify.hpp"
#include "jounce/validate/linear_drive.hpp"
#include "jounce/validate/tolerances.hpp"

#include "validate/references.hpp"

namespace jounce::hostile_test {
namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// ---- energy -------------------------------------------------------------------------------------

/// Destinations of the motor's work, from samples alone: losses, heights and kinetic energy. For a
/// drive with one mass behind the motor, whose speed is the difference quotient of its samples.
double accounted(const Drive& drive, const DriveResult& run) {
  const Mass& mass = drive.train[0];
  const Friction& a = drive.motor.friction;
  const Friction& b = mass.friction;
  const auto& s = run.samples;
  const double h = s[1].time - s[0].time;
  const auto load_speed = [&](std::size_t i) {
    return (s[i + 1].load - s[i - 1].load) * radians / (2 * h);
  };
  const auto twist = [&](std::size_t i) {
    const double all = (s[i].motor - s[i].load) * radians;
    const double gap = mass.backlash / 2;
    return std::abs(all) > gap ? all - std::copysign(gap, all) : 0.0;
  };
  double lost = 0;
  for (std::size_t i = 1; i + 1 < s.size(); ++i) {
    const double v = s[i].velocity;
    const double w = load_speed(i);
    const double rubbing =
        a.viscous * v * v + a.coulomb * std::abs(v) + b.viscous * w * w + b.coulomb * std::abs(w);
    const double shaft = twist(i) != 0 ? mass.damping * (v - w) * (v - w) : 0;
    lost += (rubbing + shaft) * h;
  }
  const std::size_t end = s.size() - 2;
  const auto height = [&](std::size_t i) {
    const double angle = s[i].load * radians;
    return mass.load_torque * angle - mass.gravity_torque / mass.gravity_ratio *
                                          std::cos(mass.gravity_angle + mass.gravity_ratio * angle);
  };
  const auto spring = [&](std::size_t i) { return mass.stiffness * twist(i) * twist(i) / 2; };
  const double moving = drive.motor.inertia * s[end].velocity * s[end].velocity / 2 +
                        mass.inertia * load_speed(end) * load_speed(end) / 2;
  return lost + height(end) - height(0) + spring(end) - spring(0) + moving;
}

Drive plain() {
  return servo_400w();
}

Drive rubbing() {
  Drive drive = plain();
  drive.motor.friction = {1e-4, 0.02, 0.03, 2};
  drive.train[0].friction = {1e-4, 0.05, 0.05, 2};
  return drive;
}

Drive hanging() {
  Drive drive = plain();
  drive.train[0].load_torque = 0.3;
  drive.train[0].gravity_torque = 0.2;
  drive.train[0].gravity_angle = 0.4;
  return drive;
}

Drive hanging_load() {
  Drive drive = plain();
  drive.train[0].load_torque = 0.3;
  return drive;
}

Drive with_gap() {
  Drive drive = plain();
  drive.train[0].backlash = 5e-3;
  return drive;
}

Drive everything() {
  Drive drive = rubbing();
  drive.train[0].backlash = 5e-3;
  drive.train[0].gravity_torque = 0.2;
  drive.train[0].gravity_angle = 0.4;
  drive.train[0].load_torque = 0.1;
  drive.motor.current_lag = 1e-4;
  drive.motor.torque_limit = 0.9;
  drive.controller.friction_feed_forward = 0.8;
  return drive;
}

/// The balance within what sampling costs: of order h^2, and of h at every impact and stop.
void expect_balance(const char* what, const Drive& drive, double share) {
  SCOPED_TRACE(what);
  const DriveResult run =
      drive_through(test::s_curve_move(), drive, {.settle = 0.1, .samples = 40'001});
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
  const double work = run.energy.driving - run.energy.regenerated;
  EXPECT_NEAR(work, accounted(drive, run), share * run.energy.driving);
  EXPECT_GT(run.energy.driving, 0);
}

TEST(Energy, OfAPlainAxisEqualsItsLosses) {
  expect_balance("plain", plain(), 1e-6);
}

TEST(Energy, OfDryFrictionEqualsItsLosses) {
  Drive drive = rubbing();
  drive.motor.friction.breakaway = drive.motor.friction.coulomb;
  expect_balance("rubbing", drive, 1e-5);
}

TEST(Energy, OfALoadThatIsLiftedIsItsHeight) {
  expect_balance("hanging", hanging(), 1e-6);
}

TEST(Energy, OfAGapIsKeptInTheAirAndLostInTheDamperAlone) {
  expect_balance("with a gap", with_gap(), 1e-4);
}

TEST(Energy, OfBacklashFrictionGravityAndALimitTogether) {
  Drive drive = everything();
  drive.motor.friction.breakaway = drive.motor.friction.coulomb;
  expect_balance("everything", drive, 1e-4);
}

// ---- rest ---------------------------------------------------------------------------------------

Trajectory standstill(double time) {
  return Trajectory({line(time, 0, 0)}, 0, Extrapolation::hold);
}

TEST(Rest, UnderGravityLastsWhileTheMotorHoldsItWithinItsLimit) {
  Drive drive = plain();
  drive.train[0].load_torque = drive.motor.torque_limit * (1 - 1e-6);
  const DriveResult run = drive_through(standstill(1), drive);
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
  EXPECT_TRUE(run.saturation.empty());
  EXPECT_NEAR(run.following_error.value, 0, 1e-6);
  EXPECT_NEAR(run.torque.value, drive.train[0].load_torque, 1e-6);
}

/// More load than the motor can hold: it falls, and the result reports it.
TEST(Rest, BeyondTheLimitIsLostWithTheAccelerationThatIsMissing) {
  Drive drive = plain();
  drive.motor.friction = drive.train[0].friction = {};
  const double over = 0.01;
  drive.train[0].load_torque = drive.motor.torque_limit + over;
  constexpr double time = 0.4;
  const DriveResult run = drive_through(standstill(time), drive, {.settle = 0, .samples = 1001});
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
  ASSERT_EQ(run.saturation.size(), 1U);
  EXPECT_EQ(run.saturation[0].from, 0);
  EXPECT_EQ(run.saturation[0].sign, 1);
  const double inertia = drive.motor.inertia + drive.train[0].inertia;
  const double fallen = -over / inertia * time * time / 2 / radians;
  const DriveSample& last = run.samples.back();
  const double center = (drive.motor.inertia * last.motor +
                         drive.train[0].inertia * (last.load - run.samples[0].load)) /
                        inertia;
  EXPECT_NEAR(center, fallen, 1e-5 * std::abs(fallen));
}

TEST(Rest, OfABodyThatSticksWithLessThanItsBreakawayLasts) {
  Drive drive = plain();
  drive.motor.friction = {};
  drive.train[0].friction = {0, 0.1, 0.2, 1};
  drive.train[0].load_torque = 0.2 * (1 - 1e-6);
  const DriveResult run = drive_through(standstill(1), drive, {.samples = 101});
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
  for (const DriveSample& s : run.samples) EXPECT_EQ(s.load, run.samples[0].load);
}

// ---- meaningless references -----------------------------------------------------------------------

TEST(HostileReference, OfNoLengthInPlaceIsAStandstill) {
  const Trajectory stays({line(1e-9, 5, 5)}, 0, Extrapolation::hold);
  const DriveResult run = drive_through(stays, plain(), {.settle = 0.1});
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
  EXPECT_EQ(run.torque.value, 0);
  EXPECT_EQ(run.following_error.value, 0);
}

TEST(HostileReference, OfOneInstantIsRejected) {
  const test::MadeUp instant{[](double, Side) { return Jet{1, 0, 0, 0}; }, {0, 0}};
  EXPECT_THROW(drive_through(instant, plain()), InputError);
}

TEST(HostileReference, ThatMovesFromTheStartGivesMoreErrorButBalancesItsEnergy) {
  const Trajectory moving({line(0.3, 0, 300)}, 0, Extrapolation::hold);
  const DriveResult run = drive_through(moving, plain(), {.settle = 0.3, .samples = 40'001});
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
  EXPECT_NEAR(run.energy.driving - run.energy.regenerated, accounted(plain(), run),
              1e-3 * run.energy.driving);
  EXPECT_NEAR(run.samples.back().load, 300, 0.1);
}

/// The same machine in other units of position: torques are the same.
TEST(HostileScale, OfTheUnitScalesOut) {
  const DriveResult degrees = drive_through(test::s_curve_move(), plain());
  for (const double unit : {1e-6, 1e-3, 1e9, 1e15}) {
    SCOPED_TRACE(unit);
    Drive drive = plain();
    drive.position_per_rev = unit;
    const double k = unit / 360;
    const Trajectory move = s_curve({.from = 0,
                                     .to = 3600 * k,
                                     .velocity = 9000 * k,
                                     .acceleration = 60'000 * k,
                                     .jerk = 2e6 * k})
                                .curve();
    const DriveResult run = drive_through(move, drive);
    ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
    EXPECT_NEAR(run.torque.value, degrees.torque.value, 1e-5 * degrees.torque.value);
    EXPECT_NEAR(run.rms_torque, degrees.rms_torque, 1e-6 * degrees.rms_torque);
    EXPECT_NEAR(run.following_error.value, degrees.following_error.value * k,
                1e-5 * std::abs(degrees.following_error.value) * k);
    EXPECT_EQ(run.impacts, 0);
  }
}

/// A watch's motor and a ship's: inertia, torques, stiffness and gains together scale out.
TEST(HostileScale, OfTheMachineScalesOut) {
  const DriveResult usual = drive_through(test::s_curve_move(), rubbing());
  for (const double k : {1e-9, 1e6}) {
    SCOPED_TRACE(k);
    Drive drive = rubbing();
    for (const DriveNumber& n : numbers(drive))
      if (n.unit.starts_with("N m") || n.unit == "kg m^2") *n.value *= k;
    const DriveResult run = drive_through(test::s_curve_move(), drive);
    ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
    EXPECT_NEAR(run.torque.value, usual.torque.value * k, 1e-5 * std::abs(usual.torque.value) * k);
    EXPECT_NEAR(run.energy.driving, usual.energy.driving * k, 1e-5 * usual.energy.driving * k);
  }
}

TEST(HostileNumbers, ThatAreNotFiniteAreRejectedByName) {
  Drive drive = everything();
  drive.pendulum = Pendulum{2, 0.1, 0.3};
  const std::size_t count = numbers(drive).size();
  for (std::size_t i = 0; i < count; ++i)
    for (const double bad : {nan, infinity, -infinity}) {
      Drive broken = drive;
      const DriveNumber number = numbers(broken)[i];
      *number.value = bad;
      try {
        drive_through(test::s_curve_move(), broken);
        ADD_FAILURE() << number.key << " = " << bad << " was taken";
      } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(number.key), std::string::npos) << error.what();
      }
    }
}

// ---- failing midway ----------------------------------------------------------------------------

/// A run that ended early has no peaks: a limit that it did not exceed by then is no finding.
TEST(FailedRun, PassesNoLimit) {
  const DriveLimits limits{.torque = 100,
                           .rms_torque = 100,
                           .velocity = 1e6,
                           .following_error = 1e6,
                           .end_following_error = 1e6,
                           .residual = 1e6};
  const DriveResult run =
      drive_through(test::s_curve_move(), plain(), {.limits = limits, .max_steps = 100});
  ASSERT_FALSE(run.integration.ok());
  ASSERT_FALSE(run.report.ok());
  for (const Finding& f : run.report.findings) EXPECT_TRUE(f.broken) << f.rule;
}

TEST(FailedRun, StillReportsALimitThatWasExceededBefore) {
  const DriveResult run = drive_through(test::s_curve_move(), plain(),
                                        {.limits = {.velocity = 1e-3}, .max_steps = 400});
  ASSERT_FALSE(run.integration.ok());
  EXPECT_TRUE(std::any_of(run.report.findings.begin(), run.report.findings.end(),
                          [](const Finding& f) { return f.rule == "drive/velocity"; }));
}

TEST(FailedRun, IsInNoFigureOfTolerances) {
  const ToleranceSpec spec{.numbers = {{.key = "mass[1].inertia", .share = 0.2}}};
  Drive rubs = plain();  // a linear drive is not integrated
  rubs.motor.friction.coulomb = 0.01;
  const ToleranceResult all =
      over_tolerances(test::s_curve_move(), rubs,
                      {.limits = {.torque = 100, .residual = 100}, .max_steps = 100}, spec);
  EXPECT_EQ(all.failed, all.cases);
  EXPECT_TRUE(std::isnan(all.figures[0].nominal));
  ASSERT_EQ(all.report.findings.size(), 1U);
  EXPECT_EQ(all.report.findings[0].rule, "tolerance/integration");
  EXPECT_TRUE(all.report.findings[0].broken);
}

// ---- reports --------------------------------------------------------------------------------------

const Finding* found(const Report& report, const std::string& rule) {
  for (const Finding& f : report.findings)
    if (f.rule == rule) return &f;
  return nullptr;
}

/// Entered and left where the exact solution goes through the limit.
TEST(Beyond, TheFollowingErrorIsOnIntervalsOfTheExactSolution) {
  const Drive drive = plain();
  const Trajectory move = test::s_curve_move();
  const double peak = std::abs(drive_through(move, drive).following_error.value);
  for (const double share : {0.3, 0.6, 0.9, 0.999}) {
    SCOPED_TRACE(share);
    const double limit = share * peak;
    const DriveResult run = drive_through(move, drive, {.limits = {.following_error = limit}});
    const auto& beyond = run.beyond_following_error;
    ASSERT_FALSE(beyond.empty());
    std::vector<double> times;
    for (const Interval& i : beyond) {
      EXPECT_LT(i.from, i.to);
      times.push_back(i.from);
      times.push_back((i.from + i.to) / 2);
      times.push_back(i.to);
    }
    ASSERT_TRUE(std::is_sorted(times.begin(), times.end()));
    const ExactRun exact = exact_run(move, drive, times);
    for (std::size_t k = 0; k < times.size(); k += 3) {
      EXPECT_NEAR(std::abs(exact.samples[k].following_error), limit, 1e-6 * peak);
      EXPECT_GT(std::abs(exact.samples[k + 1].following_error), limit);
      EXPECT_NEAR(std::abs(exact.samples[k + 2].following_error), limit, 1e-6 * peak);
    }
  }
}

/// Nothing is missed between the intervals either.
TEST(Beyond, NothingIsLeftOut) {
  const Drive drive = plain();
  const Trajectory move = test::s_curve_move();
  const double limit = 0.4 * std::abs(drive_through(move, drive).following_error.value);
  const DriveResult run =
      drive_through(move, drive, {.samples = 5001, .limits = {.following_error = limit}});
  const double slack = 1e-6;  // s
  for (const DriveSample& s : run.samples) {
    const bool within = std::any_of(
        run.beyond_following_error.begin(), run.beyond_following_error.end(),
        [&](const Interval& i) { return s.time > i.from - slack && s.time < i.to + slack; });
    EXPECT_TRUE(within || std::abs(s.following_error) <= limit) << s.time;
  }
}

TEST(Beyond, IsEmptyWithinTheLimitAndWithoutOne) {
  EXPECT_TRUE(drive_through(test::s_curve_move(), plain()).beyond_following_error.empty());
  EXPECT_TRUE(drive_through(test::s_curve_move(), plain(), {.limits = {.following_error = 1e3}})
                  .beyond_following_error.empty());
}

TEST(SecondOpinion, IsInTheReportOfARunWithSamples) {
  const DriveResult run = drive_through(test::s_curve_move(), plain(), {.samples = 101});
  const Finding* exact = found(run.report, "drive/exact");
  ASSERT_NE(exact, nullptr);
  EXPECT_FALSE(exact->broken) << exact->value;
  EXPECT_EQ(found(drive_through(test::s_curve_move(), with_gap(), {.samples = 101}).report,
                  "drive/exact"),
            nullptr);
}

/// For every tolerance the two solutions agree within the limit of the finding.
TEST(SecondOpinion, HoldsAtEveryTolerance) {
  Drive late = plain();
  late.motor.current_lag = 1e-4;
  late.controller.delay = 5e-4;
  Drive swinging = plain();
  swinging.pendulum = Pendulum{4, 0.02, 0.4};
  Drive sampled = plain();
  sampled.controller.cycle = 1e-3;
  sampled.motor.torque_limit = 1e3;
  for (const double tolerance : {1e-3, 1e-4, 1e-6, 1e-8, 1e-10, 1e-11, 1e-12})
    for (const Drive& drive : {plain(), late, swinging, hanging_load(), sampled})
      for (const Trajectory& move : {test::trapezoid_move(), test::s_curve_move()}) {
        if (drive.controller.cycle > 0 && tolerance != 1e-6) continue;  // slow
        const DriveResult run =
            drive_through(move, drive, {.settle = 0.05, .samples = 101, .tolerance = tolerance});
        const Finding* exact = found(run.report, "drive/exact");
        ASSERT_NE(exact, nullptr);
        EXPECT_FALSE(exact->broken) << tolerance << ": " << exact->value;
      }
}

TEST(Tolerances, IncludeSettlingHeatAndEnergyOfTheDrive) {
  Drive drive = plain();
  drive.motor.rated_torque = 1.3;
  drive.motor.thermal_time = 600;
  const ToleranceSpec spec{.numbers = {{.key = "mass[1].inertia", .share = 0.1}}};
  const DriveOptions options{.limits = {.settling_band = 1e-9, .settling_time = 0.05}};
  const Trajectory move = test::s_curve_move();
  const ToleranceResult all = over_tolerances(move, drive, options, spec);
  ASSERT_EQ(all.figures.size(), 7U);
  EXPECT_EQ(all.figures[4].figure, "settling_time");
  EXPECT_EQ(all.figures[4].nominal, options.settle);  // never within such a band
  EXPECT_EQ(all.figures[4].beyond, all.cases);
  ASSERT_NE(found(all.report, "tolerance/settling_time"), nullptr);
  EXPECT_TRUE(found(all.report, "tolerance/settling_time")->broken);
  drive.train[0].inertia = all.figures[5].worst.numbers[0].second;
  const DriveResult worst = exact_through(move, drive, options).value();
  EXPECT_EQ(all.figures[5].worst.value, worst.i2t.value);
  EXPECT_EQ(all.figures[6].worst.value, worst.energy.driving);
}

// ---- a follower without preload ---------------------------------------------------------------

TEST(HostileFollower, WithoutPreloadAtTheFootOfItsSpringIsRejected) {
  SpringFollower follower{
      .mass = 0.1, .linkage_stiffness = 1e6, .spring_stiffness = 1e4, .meters_per_unit = 1e-3};
  const Trajectory lift = test::law_345(10, 0.1);
  try {
    follow(lift, follower);
    ADD_FAILURE() << "was taken";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("preload"), std::string::npos);
  }
}

TEST(HostileFollower, NumbersThatAreNotFiniteAreRejected) {
  const SpringFollower good{.mass = 0.1,
                            .linkage_stiffness = 1e6,
                            .spring_stiffness = 1e4,
                            .preload = 50,
                            .meters_per_unit = 1e-3};
  for (double SpringFollower::*number :
       {&SpringFollower::mass, &SpringFollower::linkage_stiffness, &SpringFollower::linkage_damping,
        &SpringFollower::spring_stiffness, &SpringFollower::spring_damping,
        &SpringFollower::preload, &SpringFollower::meters_per_unit})
    for (const double bad : {nan, infinity, -1.0}) {
      SpringFollower follower = good;
      follower.*number = bad;
      EXPECT_THROW(follow(test::law_345(10, 0.1), follower), InputError);
    }
}

// ---- recordings without information ---------------------------------------------------------------

Recording still(std::size_t samples, double at) {
  Recording run;
  for (std::size_t i = 0; i < samples; ++i) run.time.push_back(static_cast<double>(i) * 1e-3);
  run.command.assign(samples, at);
  run.position.assign(samples, at);
  run.torque.assign(samples, 0);
  return run;
}

TEST(HostileRecording, OfAnAxisAtRestHasNoInformation) {
  for (const double at : {0.0, 1234.5}) {
    SCOPED_TRACE(at);
    const Recording run = still(101, at);
    const Identification found =
        identify(run, {servo_400w(), {"motor.inertia", "mass[1].inertia"}});
    EXPECT_EQ(found.status, Identification::Status::not_identifiable) << found.reason;
    for (const FittedNumber& n : found.numbers) EXPECT_TRUE(std::isfinite(n.value)) << n.key;
  }
}

TEST(HostileRecording, OutOfShapeIsRejectedByName) {
  const auto refused = [](const Recording& run, const std::string& key) {
    try {
      identify(run, {servo_400w(), {"motor.inertia"}});
      ADD_FAILURE() << key << ": was taken";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(key), std::string::npos) << error.what();
    }
  };
  refused(still(0, 0), "time");
  refused(still(1, 0), "time");
  Recording run = still(10, 0);
  run.time[4] = run.time[3];
  refused(run, "time[5]");
  run = still(10, 0);
  std::reverse(run.time.begin(), run.time.end());
  refused(run, "time[2]");
  run = still(10, 0);
  run.command[2] = nan;
  refused(run, "command");
  run = still(10, 0);
  run.time[9] = infinity;
  refused(run, "time");
}

/// Recorded in radians where the drive counts degrees: no fit, and no crash.
TEST(HostileRecording, InAnotherUnitIsNotExplained) {
  const Trajectory move = test::law_345(360, 0.3);
  const DriveResult truth = drive_through(move, servo_400w(), {.settle = 0, .samples = 101});
  Recording run;
  for (const DriveSample& s : truth.samples) {
    run.time.push_back(s.time);
    run.command.push_back(s.reference);
    run.position.push_back(s.motor * radians);
    run.torque.push_back(s.torque);
  }
  const Identification found = identify(run, move, {servo_400w(), {"mass[1].inertia"}});
  ASSERT_FALSE(found.explained.empty());
  EXPECT_FALSE(found.notes.empty());
  EXPECT_GT(found.explained[0].after, 10);  // degrees of 360
}

}  // namespace
}  // namespace jounce::hostile_test
