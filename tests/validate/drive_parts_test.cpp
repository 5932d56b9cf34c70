// SPDX-License-Identifier: Apache-2.0
// Each part of the drive model against a closed form.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/validate/drive.hpp"

#include "support/errors.hpp"
#include "validate/references.hpp"

namespace jounce::drive_parts_test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double radians = pi / 180;  // rad per unit of these tests

/// A rigid axis without friction, its loop as tight as a feed-forward makes it.
Drive rigid() {
  Drive drive = servo_400w();
  drive.train.clear();
  drive.motor.inertia = 2.4e-4;
  drive.motor.friction = {};
  return drive;
}

/// The same without a loop: what the reference's acceleration asks for is all that drives it.
Drive open_loop() {
  Drive drive = rigid();
  drive.controller.position_gain = drive.controller.velocity_gain = 1e-12;
  drive.controller.integral_time = 0;
  return drive;
}

/// Accelerates for `time`, then goes on at that speed.
Trajectory push(double acceleration, double time, double until) {
  const double v = acceleration * time;
  const double p = v * time / 2;
  return Trajectory({quintic(time, 0, 0, acceleration, p, v, acceleration),
                     line(until - time, p, p + v * (until - time))},
                    0, Extrapolation::hold);
}

Trajectory standstill(double time, double position = 0) {
  return Trajectory({line(time, position, position)}, 0, Extrapolation::hold);
}

void expect_complete(const DriveResult& run) {
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
}

// ---- rigid axis ---------------------------------------------------------------------------------

TEST(RigidAxis, NeedsInertiaTimesAccelerationPlusFriction) {
  Drive drive = rigid();
  drive.motor.friction = {.viscous = 1e-3, .coulomb = 0.05};
  drive.controller.friction_feed_forward = 1;
  const Trajectory move = test::law_345(3600, 0.4);
  const DriveResult run = drive_through(move, drive, {.settle = 0, .samples = 401});
  expect_complete(run);
  for (const DriveSample& s : run.samples) {
    if (s.time < 0.02 || s.time > 0.38) continue;  // breaking away and standing: see Friction
    const Motion m = move.at(s.time);
    const double expected = radians * (2.4e-4 * m.acceleration + 1e-3 * m.velocity) + 0.05;
    ASSERT_NEAR(s.torque, expected, 1e-3 * std::abs(run.torque.value)) << "at " << s.time;
  }
}

TEST(RigidAxis, OfMassesJoinedRigidlyIsOneOfTheirSum) {
  Drive parts = rigid();
  parts.motor.inertia = 0.4e-4;
  parts.train = {Mass{.inertia = 1.5e-4, .friction = {.viscous = 3e-4}},
                 Mass{.inertia = 0.5e-4, .load_torque = 0.1}};
  Drive whole = rigid();
  whole.motor.friction.viscous = 3e-4;
  whole.train = {Mass{.inertia = 1e-4, .load_torque = 0.1}};
  whole.motor.inertia = 1.4e-4;
  const DriveResult a = drive_through(test::s_curve_move(), parts);
  const DriveResult b = drive_through(test::s_curve_move(), whole);
  EXPECT_NEAR(a.torque.value, b.torque.value, 1e-12);
  EXPECT_NEAR(a.following_error.value, b.following_error.value, 1e-9);
}

TEST(RigidAxis, TurnsWorkIntoMotionAndBack) {
  // Frictionless, exactly fed forward: J w^2 / 2 out, and the same back.
  const Trajectory move =
      trapezoid({.from = 0, .to = 3600, .velocity = 9000, .acceleration = 60'000}).curve();
  const DriveResult run = drive_through(move, rigid());
  const double w = 9000 * radians;
  const double kinetic = 2.4e-4 * w * w / 2;
  EXPECT_NEAR(run.energy.driving, kinetic, 1e-5 * kinetic);
  EXPECT_NEAR(run.energy.regenerated, kinetic, 1e-5 * kinetic);
  EXPECT_NEAR(run.velocity.value, w, 1e-6 * w);
}

// ---- friction -----------------------------------------------------------------------------------

TEST(Friction, BringsABlockToRestAsCoulombPredicts) {
  Drive drive = open_loop();
  drive.motor.friction.coulomb = 0.05;
  const double a = 30'000 * radians;
  const double d = 0.05 / drive.motor.inertia;
  const double pushed = 0.1;
  const double w = (a - d) * pushed;
  const double stop = pushed + w / d;
  const double way = w * pushed / 2 + w * w / (2 * d);
  const DriveResult run =
      drive_through(push(30'000, pushed, stop + 1), drive, {.settle = 0, .samples = 1001});
  expect_complete(run);
  for (const DriveSample& s : run.samples) {
    if (s.time > stop + 1e-6) {
      ASSERT_NEAR(s.motor * radians, way, 2e-8 * way) << "at " << s.time;
      ASSERT_NEAR(s.velocity, 0, 1e-8 * w) << "at " << s.time;
    }
  }
}

TEST(Friction, OfAStandingAxisHoldsItWithoutCreep) {
  // 0.04 N m push against 0.05 N m of breakaway: nothing moves, for as long as one likes.
  Drive drive = open_loop();
  drive.motor.friction = {.coulomb = 0.03, .breakaway = 0.05, .stribeck_velocity = 1};
  drive.train = {Mass{.inertia = 1e-9, .load_torque = 0.04}};
  const DriveResult run = drive_through(standstill(100), drive, {.settle = 0, .samples = 3});
  expect_complete(run);
  EXPECT_EQ(run.samples.back().motor, run.samples.front().motor);
  EXPECT_EQ(run.velocity.value, 0);
}

TEST(Friction, HoldsUntilBreakaway) {
  // The integral part winds up at 1 / T_i until the axis breaks away at T_s: the first it moves.
  Drive drive = rigid();
  drive.controller.torque_feed_forward = 0;
  drive.controller.velocity_feed_forward = 0;
  drive.motor.friction = {.coulomb = 0.2, .breakaway = 0.4, .stribeck_velocity = 0.1};
  const double step = 9;  // seen as a step of position after 0.1 s; T = K_v K_p e (1 + t / T_i)
  const double asked = 0.05 * 40 * step * radians;
  ASSERT_LT(asked, 0.4);
  const Trajectory far({line(0.1, 0, 0), line(1, step, step)}, 0, Extrapolation::hold);
  const DriveResult run = drive_through(far, drive, {.settle = 0, .samples = 110'001});
  expect_complete(run);
  const double breakaway = 0.1 + 0.02 * (0.4 / asked - 1);
  const auto first = std::find_if(run.samples.begin(), run.samples.end(),
                                  [](const DriveSample& s) { return s.velocity > 0; });
  ASSERT_NE(first, run.samples.end());
  EXPECT_NEAR(first->time, breakaway, 2e-5);
}

TEST(Friction, OfAllSortsEndsInReasonableTime) {
  // A plain sign(w) stalls at the first standstill: half a million steps and no end.
  Drive drive = servo_400w();
  drive.motor.friction = {1e-4, 0.05, 0.05, 0};
  drive.train[0].friction = {1e-4, 0.1, 0.15, 0.5};
  drive.controller.friction_feed_forward = 1;
  for (const Trajectory& move : {test::s_curve_move(), test::trapezoid_move(),
                                 test::law_345(-1, 0.1), test::law_345(0.01, 1)}) {
    const DriveResult run = drive_through(move, drive, {.settle = 1, .max_steps = 50'000});
    EXPECT_TRUE(run.integration.ok()) << run.integration.reason;
  }
}

// ---- loads --------------------------------------------------------------------------------------

TEST(Load, ThatHangsIsHeldFromTheStart) {
  for (const double integral_time : {0.0, 0.02}) {
    Drive drive = servo_400w();
    drive.controller.integral_time = integral_time;
    drive.train[0].load_torque = 0.5;
    const DriveResult run = drive_through(standstill(1), drive, {.samples = 11});
    expect_complete(run);
    EXPECT_NEAR(run.torque.value, 0.5, 1e-9);
    EXPECT_NEAR(run.rms_torque, 0.5, 1e-6);
    for (const DriveSample& s : run.samples)
      EXPECT_NEAR((s.motor - s.load) * radians, 0.5 / 50, 1e-10);
    EXPECT_NEAR(run.end_following_error * radians, integral_time > 0 ? 0 : 0.5 / (40 * 0.05), 1e-9);
  }
}

TEST(Load, OfAnArmIsTheSineOfItsAngle) {
  Drive drive = rigid();
  drive.train = {
      Mass{.inertia = 1e-5, .gravity_torque = 0.5, .gravity_angle = 0.3, .gravity_ratio = 0.1}};
  for (const double position : {0.0, 90.0, 900.0, -2700.0}) {
    const DriveResult run = drive_through(standstill(1, position), drive);
    EXPECT_NEAR(run.torque.value, 0.5 * std::sin(0.3 + 0.1 * position * radians), 1e-9);
  }
}

TEST(Gear, LosesInTheDirectionThatPowerFlows) {
  // A load of 0.5 N m lifted and lowered at constant speed behind a gear of 80 %.
  Drive drive = servo_400w();
  drive.motor.friction = drive.train[0].friction = {};
  drive.train[0].efficiency = 0.8;
  drive.train[0].load_torque = 0.5;
  const auto torque = [&](double velocity) {
    const Trajectory move({line(2, 0, 2 * velocity)}, 0, Extrapolation::hold);
    return drive_through(move, drive, {.settle = 0, .samples = 101}).samples[99].torque;
  };
  EXPECT_NEAR(torque(360), 0.5 / 0.8, 1e-6);
  EXPECT_NEAR(torque(-360), 0.5 * 0.8, 1e-6);
}

TEST(Pendulum, SwingsAsDuhamelsIntegral) {
  // A pendulum so light that the axis does not feel it: u'' + w^2 u = -a(t).
  Drive drive = rigid();
  drive.train = {Mass{.inertia = 1e-4}};
  drive.pendulum = Pendulum{.frequency = 3, .damping = 0, .share = 1e-6};
  const Trajectory move = test::law_345(360, 0.4);
  const DriveResult run = drive_through(move, drive, {.settle = 1});
  expect_complete(run);
  const double w = 2 * pi * 3;
  double c = 0;
  double s = 0;
  constexpr int n = 20'000;
  for (int i = 0; i < n; ++i) {
    const double t = 0.4 * (i + 0.5) / n;
    c += move.at(t).acceleration * std::cos(w * t) * 0.4 / n;
    s += move.at(t).acceleration * std::sin(w * t) * 0.4 / n;
  }
  const double amplitude = std::hypot(c, s) / w;  // after the end
  EXPECT_GE(std::abs(run.swing.value), amplitude * (1 - 1e-4));
  const DriveResult later = drive_through(move, drive, {.settle = 10});
  EXPECT_NEAR(std::abs(later.swing.value), std::abs(run.swing.value), 1e-5 * amplitude);
}

// ---- motor --------------------------------------------------------------------------------------

TEST(Motor, CurrentLoopLagsByItsTimeConstant) {
  Drive drive = open_loop();
  drive.motor.current_lag = 2e-3;
  const DriveResult run =
      drive_through(push(30'000, 0.1, 0.11), drive, {.settle = 0, .samples = 111});
  const double full = drive.motor.inertia * 30'000 * radians;
  for (const DriveSample& s : run.samples)
    if (s.time < 0.0999) {
      ASSERT_NEAR(s.torque, full * (1 - std::exp(-s.time / 2e-3)), 1e-7 * full) << s.time;
    }
}

TEST(Motor, HasLessTorqueAtSpeed) {
  Drive drive = rigid();
  drive.motor.torque_limit = 1;
  drive.motor.rated_velocity = 100;
  drive.motor.max_velocity = 300;
  const Trajectory move =
      trapezoid({.from = 0, .to = 36'000, .velocity = 15'000, .acceleration = 200'000}).curve();
  const DriveResult run = drive_through(move, drive, {.settle = 0.2, .samples = 4001});
  expect_complete(run);
  const auto limit = [](double driving) { return std::clamp((300 - driving) / 200, 0.0, 1.0); };
  int at_limit = 0;
  for (const DriveSample& s : run.samples) {
    const double allowed = limit(std::copysign(s.velocity, s.torque * s.velocity));
    ASSERT_LE(std::abs(s.torque), allowed + 1e-7) << s.time;
    at_limit += std::abs(s.torque) > allowed - 1e-7 && s.velocity > 110 && s.torque > 0;
  }
  EXPECT_GT(at_limit, 20);
  EXPECT_TRUE(std::any_of(run.saturation.begin(), run.saturation.end(),
                          [](const Saturation& s) { return s.sign > 0; }));
  EXPECT_FALSE(run.report.ok());
}

TEST(Motor, HeatsAsAFirstOrderLag) {
  Drive drive = rigid();
  drive.train = {Mass{.inertia = 1e-5, .load_torque = 0.5}};
  drive.motor.rated_torque = 0.4;
  drive.motor.thermal_time = 20;
  drive.motor.torque_constant = 0.5;
  drive.motor.resistance = 3;
  const DriveResult run = drive_through(standstill(30), drive, {.settle = 0});
  const double full = 0.5 * 0.5 / 0.16;
  EXPECT_NEAR(run.i2t.value, full * (1 - std::exp(-1.5)), 1e-6);
  EXPECT_NEAR(run.i2t.where, 30, 1e-9);
  EXPECT_NEAR(run.current.value, 1, 1e-9);
  EXPECT_NEAR(run.rms_current, 1, 1e-6);
  EXPECT_NEAR(run.energy.copper, 3 * 30, 1e-4);
  EXPECT_FALSE(run.report.ok());
  EXPECT_EQ(run.report.broken(), 2u);  // I2t, and rms above the rated torque
}

TEST(Motor, OfADataSheetHoldsTogether) {
  const Drive drive = wittenstein_premo_2d();
  EXPECT_NO_THROW(require_valid(drive));
  const Motor& m = drive.motor;
  EXPECT_NEAR(m.torque_limit * m.rated_velocity, 2490, 1e-9);
  EXPECT_TRUE(drive_through(test::law_345(3600, 0.4), drive).report.ok());
}

// ---- controller ---------------------------------------------------------------------------------

TEST(Controller, DelaysBySecondOrderPade) {
  // A smooth command comes later by the delay; Pade's poles are 3 / tau away, its error (w tau)^5.
  Drive drive = open_loop();
  drive.controller.delay = 2e-3;
  const Trajectory move = test::law_345(3600, 0.4);
  const DriveResult run = drive_through(move, drive, {.settle = 0, .samples = 401});
  const double peak = std::abs(run.torque.value);
  for (const DriveSample& s : run.samples)
    if (s.time > 0.03 && s.time < 0.4) {
      ASSERT_NEAR(s.torque, 2.4e-4 * radians * move.at(s.time - 2e-3).acceleration, 1e-7 * peak)
          << s.time;
    }
}

/// A rigid axis under a sampled controller, written out: between samples it is a constant torque.
struct SampledAxis {
  double angle = 0, speed = 0, z = 0, last = 0;

  void run(double inertia, double torque, double time) {
    angle += speed * time + torque / inertia * time * time / 2;
    speed += torque / inertia * time;
  }
};

void expect_sampled(Drive drive, double limit) {
  const Controller& c = drive.controller;
  const Trajectory move = test::law_345(360, 0.1);
  const int n = 250;
  const DriveResult run = drive_through(
      move, drive, {.settle = n * c.cycle - 0.1, .samples = static_cast<std::size_t>(n) + 1});
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
  SampledAxis axis;
  double held = 0;
  const double inertia = drive.motor.inertia;
  for (int k = 0; k <= n; ++k) {
    const auto& sample = run.samples[static_cast<std::size_t>(k)];
    ASSERT_NEAR(sample.motor * radians, axis.angle, limit) << "sample " << k;
    const double t = k * c.cycle;
    const Motion r = t < 0.1 - 1e-9 ? move.at(t) : Motion{360, 0, 0, 0};
    const double count = c.encoder_counts > 0 ? 2 * pi / c.encoder_counts : 0;
    const double read = count > 0 ? std::round(axis.angle / count) * count : axis.angle;
    const double speed = k > 0 ? (read - axis.last) / c.cycle : 0;
    axis.last = read;
    const double e = c.position_gain * (r.position * radians - read) + r.velocity * radians - speed;
    const double asked = c.velocity_gain * e + axis.z + inertia * r.acceleration * radians;
    const double given = std::clamp(asked, -drive.motor.torque_limit, drive.motor.torque_limit);
    axis.z += c.cycle * (c.velocity_gain * e + given - asked) / c.integral_time;
    axis.run(inertia, held, c.delay);
    held = given;
    axis.run(inertia, held, c.cycle - c.delay);
  }
}

TEST(Controller, SampledAgreesWithItsDifferenceEquations) {
  Drive drive = rigid();
  drive.controller.cycle = 1e-3;
  const double limit = 1e-8 * 2 * pi;  // share of the stroke
  expect_sampled(drive, limit);
  drive.controller.delay = 4e-4;
  expect_sampled(drive, limit);
  drive.controller.encoder_counts = 4096;
  expect_sampled(drive, limit);
}

TEST(Controller, SampledFastIsNearlyContinuous) {
  Drive drive = servo_400w();
  const DriveResult continuous = drive_through(test::law_345(360, 0.1), drive);
  drive.controller.cycle = 62.5e-6;
  const DriveResult sampled = drive_through(test::law_345(360, 0.1), drive);
  expect_complete(sampled);
  EXPECT_NEAR(sampled.torque.value, continuous.torque.value,
              0.01 * std::abs(continuous.torque.value));
}

// ---- findings -----------------------------------------------------------------------------------

TEST(Settling, IsTheLastEntryIntoTheBand) {
  const Trajectory move = test::law_345(3600, 0.2);
  const double band = 0.02;
  const DriveResult run = drive_through(
      move, servo_400w(),
      {.settle = 0.5, .samples = 70'001, .limits = {.settling_band = band, .settling_time = 0.01}});
  ASSERT_TRUE(run.settling_time);
  double last = 0;
  for (const DriveSample& s : run.samples)
    if (s.time >= 0.2 && std::abs(s.load - 3600) > band) last = s.time - 0.2;
  EXPECT_GT(last, 0.01);
  EXPECT_NEAR(*run.settling_time, last, 1.1e-5);
  EXPECT_EQ(run.report.findings.front().rule, "drive/settling_time");
  const DriveResult never = drive_through(
      move, servo_400w(), {.settle = 0.01, .limits = {.settling_band = 1e-6, .settling_time = 1}});
  EXPECT_FALSE(never.settling_time);
  EXPECT_FALSE(never.report.ok());
}

TEST(Sync, LooksAtItsIntervalsOnly) {
  const DriveResult run =
      drive_through(test::s_curve_move(), servo_400w(), {.sync = {{0.2, 0.25}, {0.3, 0.31}}});
  EXPECT_GE(run.sync_following_error.where, 0.19);
  EXPECT_LE(run.sync_following_error.where, 0.32);
  EXPECT_LT(std::abs(run.sync_following_error.value), std::abs(run.following_error.value));
}

TEST(Sync, MustLieWithinTheMotion) {
  EXPECT_THROW(
      static_cast<void>(drive_through(test::s_curve_move(), servo_400w(), {.sync = {{0.2, 5}}})),
      InputError);
}

TEST(Numbers, AreEachThereOnceAndCanBeWritten) {
  Drive drive = servo_400w();
  drive.pendulum = Pendulum{1, 0, 0.5};
  std::set<std::string> keys;
  for (const DriveNumber& number : numbers(drive)) {
    EXPECT_TRUE(keys.insert(number.key).second) << number.key;
    if (number.key == "mass[1].stiffness") *number.value = 77;
  }
  EXPECT_EQ(drive.train[0].stiffness, 77);
  for (const char* key : {"motor.inertia", "motor.friction.coulomb", "controller.cycle",
                          "pendulum.share", "position_per_rev"})
    EXPECT_TRUE(keys.contains(key)) << key;
}

TEST(DriveRules, NameTheNumber) {
  const auto refused = [](auto change) -> std::string {
    Drive drive = servo_400w();
    change(drive);
    return test::key_of([&] { require_valid(drive); }, "nothing");
  };
  EXPECT_EQ(refused([](Drive& d) { d.motor.friction = {0, 2, 1, 0}; }), "motor.friction.breakaway");
  EXPECT_EQ(refused([](Drive& d) { d.train[0].efficiency = 1.1; }), "mass[1].efficiency");
  EXPECT_EQ(refused([](Drive& d) { d.train.push_back({.backlash = 1, .inertia = 1}); }),
            "mass[2].backlash");
  EXPECT_EQ(refused([](Drive& d) { d.controller.encoder_counts = 1000; }),
            "controller.encoder_counts");
  EXPECT_EQ(refused([](Drive& d) { d.motor.thermal_time = 1; }), "motor.thermal_time");
  EXPECT_EQ(refused([](Drive& d) { d.motor.max_velocity = 1, d.motor.rated_velocity = 2; }),
            "motor.max_velocity");
  EXPECT_EQ(refused([](Drive& d) {
              d.train.clear(), d.pendulum = Pendulum{1, 0, 0.5};
            }),
            "pendulum.share");
}

TEST(Drive, MayRunInManyThreads) {
  Drive drive = servo_400w();
  drive.train[0].backlash = 1e-3;
  const Trajectory move = test::s_curve_move();
  const DriveResult alone = drive_through(move, drive);
  std::vector<double> torque(4);
  std::vector<std::thread> threads;
  for (double& t : torque)
    threads.emplace_back([&] { t = drive_through(move, drive).torque.value; });
  for (std::thread& thread : threads) thread.join();
  for (const double t : torque) EXPECT_EQ(t, alone.torque.value);
}

}  // namespace
}  // namespace jounce::drive_parts_test
