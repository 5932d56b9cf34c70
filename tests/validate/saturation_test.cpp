// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/moves/profile.hpp"
#include "jounce/validate/drive.hpp"

#include "validate/references.hpp"

namespace jounce::saturation_test {
namespace {

/// The default drive with a torque limit that the moves of these tests meet.
Drive weak(double torque_limit) {
  Drive drive = servo_400w();
  drive.motor.torque_limit = torque_limit;
  return drive;
}

/// The same drive by Runge-Kutta with a fixed step, in absolute angles, the limit as a plain clamp:
/// independent of modes, events, error control and deviations. Its error is of order h^2 where the
/// clamp bends, h^4 elsewhere.
class FixedStep {
 public:
  using State = std::array<double, 5>;  // th_m, w_m, th_l, w_l, z

  FixedStep(const Drive& drive, const Trajectory& reference)
      : d_(drive), f_(reference), radians_(2 * std::numbers::pi / drive.position_per_rev) {
    x_[0] = x_[2] = radians_ * f_.jet(f_.start())[0];
  }

  /// To `end` in about `steps` steps a segment; calls watch(t, *this) after each.
  template <class Watch>
  void run(double end, int steps, Watch watch) {
    std::vector<double> stops(f_.breaks().begin(), f_.breaks().end());
    stops.push_back(end);
    for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
      const double h = (stops[i + 1] - stops[i]) / steps;
      held_ = i + 2 == stops.size();
      for (int k = 0; k < steps; ++k) {
        const double t = stops[i] + k * h;
        step(t, h, stops[i], stops[i + 1]);
        watch(t + h, *this);
      }
    }
  }

  [[nodiscard]] double motor() const { return x_[0] / radians_; }
  [[nodiscard]] double load() const { return x_[2] / radians_; }
  [[nodiscard]] double asked() const { return asked_; }

 private:
  State slope(double t, const State& x) {
    const double end = f_.end();
    const Jet r = held_ ? Jet{f_.jet(end, Side::left)[0], 0, 0, 0} : f_.jet(t, side_);
    const double e = d_.controller.position_gain * (radians_ * r[0] - x[0]) +
                     d_.controller.velocity_feed_forward * radians_ * r[1] - x[1];
    const double asked = d_.controller.velocity_gain * e + x[4] +
                         d_.controller.torque_feed_forward *
                             (d_.motor.inertia + d_.train[0].inertia) * radians_ * r[2];
    const double given = std::clamp(asked, -d_.motor.torque_limit, d_.motor.torque_limit);
    const double shaft =
        d_.train[0].stiffness * (x[0] - x[2]) + d_.train[0].damping * (x[1] - x[3]);
    asked_ = asked;
    return {x[1], (given - shaft - d_.motor.friction.viscous * x[1]) / d_.motor.inertia, x[3],
            (shaft - d_.train[0].friction.viscous * x[3]) / d_.train[0].inertia,
            (d_.controller.velocity_gain * e + given - asked) / d_.controller.integral_time};
  }

  void step(double t, double h, double begin, double end) {
    const auto at = [&](double share, const State& k) {
      State y = x_;
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += share * h * k[i];
      return y;
    };
    const auto inside = [&](double u) {  // the limit from inside the segment
      side_ = u - begin < end - u ? Side::right : Side::left;
      return std::clamp(u, begin, end);
    };
    const State k1 = slope(inside(t), x_);
    const State k2 = slope(inside(t + h / 2), at(0.5, k1));
    const State k3 = slope(inside(t + h / 2), at(0.5, k2));
    const State k4 = slope(inside(t + h), at(1, k3));
    for (std::size_t i = 0; i < x_.size(); ++i)
      x_[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    static_cast<void>(slope(inside(t + h), x_));  // asked_ at the step's end
  }

  const Drive& d_;
  const Trajectory& f_;
  double radians_;
  State x_{};
  Side side_ = Side::right;
  bool held_ = false;
  double asked_ = 0;
};

/// Instants of entering and leaving saturation, and the end state, against the fixed step.
void expect_same(const Trajectory& move, const Drive& drive, double settle) {
  const DriveResult run = drive_through(move, drive, {.settle = settle, .samples = 2});
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;

  FixedStep independent(drive, move);
  std::vector<Saturation> expected;
  int mode = 0;
  double h = 0;
  double before = move.start();
  independent.run(move.end() + settle, 40'000, [&](double t, const FixedStep& now) {
    h = std::max(h, t - before);
    before = t;
    const int sign = now.asked() > drive.motor.torque_limit    ? 1
                     : now.asked() < -drive.motor.torque_limit ? -1
                                                               : 0;
    if (sign == mode) return;
    if (mode != 0) expected.back().to = t;
    if (sign != 0) expected.push_back({t, t, sign});
    mode = sign;
  });

  if (mode != 0) expected.back().to = before;  // still saturated at the end

  ASSERT_EQ(run.saturation.size(), expected.size());
  EXPECT_FALSE(expected.empty());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(run.saturation[i].sign, expected[i].sign);
    EXPECT_NEAR(run.saturation[i].from, expected[i].from, 1.1 * h);  // known to one fixed step
    EXPECT_NEAR(run.saturation[i].to, expected[i].to, 1.1 * h);
  }
  const double stroke = std::abs(move.jet(move.end(), Side::left)[0] - move.jet(move.start())[0]);
  EXPECT_NEAR(run.samples.back().motor, independent.motor(), 1e-8 * stroke);
  EXPECT_NEAR(run.samples.back().load, independent.load(), 1e-8 * stroke);
}

TEST(Saturation, AgreesWithAFixedStepIntegration) {
  expect_same(test::s_curve_move(), weak(0.2), 0.3);
  expect_same(test::trapezoid_move(), weak(0.26), 0.3);
  expect_same(test::law_345(3600, 0.3), weak(0.6), 0.3);
}

TEST(Saturation, OfAShortViolentMoveChangesSideManyTimes) {
  expect_same(test::law_345(360, 0.05), weak(0.5), 0.2);
}

TEST(Saturation, IsAFinding) {
  const DriveResult run = drive_through(test::s_curve_move(), weak(0.2));
  ASSERT_FALSE(run.saturation.empty());
  EXPECT_DOUBLE_EQ(std::abs(run.torque.value), 0.2);
  EXPECT_FALSE(run.report.ok());
  const Finding& finding = run.report.findings.front();
  EXPECT_EQ(finding.rule, "drive/saturation");
  EXPECT_TRUE(finding.broken);
  EXPECT_EQ(finding.where, run.saturation.front().from);
  for (const Saturation& s : run.saturation) EXPECT_LT(s.from, s.to);
}

TEST(Saturation, IsNoFindingBelowTheLimit) {
  const DriveResult run = drive_through(test::s_curve_move(), weak(0.29));
  EXPECT_TRUE(run.saturation.empty());
  EXPECT_TRUE(run.report.ok());
  EXPECT_LT(std::abs(run.torque.value), 0.29);
}

TEST(Saturation, AtTheVeryStartIsSeen) {
  // The reference jumps to full speed: the loop asks for far more than the limit from t = 0 on, so
  // that no change of sign announces it.
  const Trajectory ramp({line(0.5, 0, 3600)});
  const DriveResult run = drive_through(ramp, weak(0.5));
  ASSERT_FALSE(run.saturation.empty());
  EXPECT_EQ(run.saturation.front().from, 0);
  EXPECT_EQ(run.saturation.front().sign, 1);
  expect_same(ramp, weak(0.5), 0.3);
}

TEST(Saturation, ThroughoutTheRunEndsWithIt) {
  const DriveResult run = drive_through(test::law_345(36'000, 0.1), weak(0.05), {.settle = 0});
  ASSERT_TRUE(run.integration.ok());
  ASSERT_FALSE(run.saturation.empty());
  EXPECT_EQ(run.saturation.back().to, 0.1);
  EXPECT_FALSE(run.report.ok());
}

TEST(Saturation, ATorqueExactlyAtTheLimitDoesNotSwitchToAndFro) {
  // Without friction and on a rigid shaft the feed-forward alone is asked for, and it is the limit.
  Drive drive = servo_400w();
  drive.train[0].stiffness = 1e6;
  drive.train[0].damping = 10;
  drive.motor.friction.viscous = drive.train[0].friction.viscous = 0;
  const Trajectory move = test::trapezoid_move();
  drive.motor.torque_limit =
      (drive.motor.inertia + drive.train[0].inertia) * 60'000 * 2 * std::numbers::pi / 360;
  const DriveResult run = drive_through(move, drive);
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
  EXPECT_LT(run.integration.restarts, 50);
  drive.motor.torque_limit *= 2;
  EXPECT_NEAR(run.end_following_error, drive_through(move, drive).end_following_error, 1e-6 * 3600);
}

TEST(Saturation, ATorqueThatTremblesAboutTheLimitDoesNotEither) {
  // Constant feed-forward at the limit, and a loop so weak that the swings of the shaft move the
  // torque by less than the tolerance about it.
  Drive drive = servo_400w();
  drive.controller.velocity_gain = 1e-12;
  drive.controller.integral_time = 0;
  drive.train[0].damping = 0;
  const double inertia = drive.motor.inertia + drive.train[0].inertia;
  drive.motor.torque_limit = inertia * 60'000 * 2 * std::numbers::pi / 360;
  const DriveResult run = drive_through(test::trapezoid_move(), drive);
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
  EXPECT_EQ(run.integration.restarts, 4);  // the start, and the steps of acceleration
  EXPECT_TRUE(run.saturation.empty());
}

TEST(Saturation, MayBeginExactlyAtABreak) {
  // Feed-forward alone rises to the limit at the break that ends the jerk.
  Drive drive = servo_400w();
  drive.controller.velocity_gain = 1e-12;
  drive.controller.integral_time = 0;
  const Trajectory move = test::s_curve_move();
  const double inertia = drive.motor.inertia + drive.train[0].inertia;
  const double peak = inertia * 60'000 * 2 * std::numbers::pi / 360;
  drive.motor.torque_limit = peak / (1 + 1e-8);
  for (int i = 0; i < 8; ++i)
    drive.motor.torque_limit = std::nextafter(drive.motor.torque_limit, peak);
  for (int i = 0; i < 16; ++i) {
    const DriveResult run = drive_through(move, drive, {.settle = 0});
    ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
    EXPECT_LT(run.integration.restarts, 20);
    drive.motor.torque_limit = std::nextafter(drive.motor.torque_limit, 0);
  }
}

TEST(Saturation, BackCalculationKeepsTheIntegralPartSmall) {
  // While saturated z follows (4) towards T - T_ff with the time constant T_i. A loop that kept
  // integrating its velocity error would overshoot by much more than the plain proportional one.
  const Trajectory move = test::trapezoid_move();
  Drive drive = weak(0.2);
  const double with_integral = std::abs(drive_through(move, drive, {.settle = 1}).residual.value);
  drive.controller.integral_time = 0;
  const double without = std::abs(drive_through(move, drive, {.settle = 1}).residual.value);
  EXPECT_LT(with_integral, 1.5 * without);
}

TEST(Saturation, MirroredReferenceSaturatesOnTheOtherSide) {
  const DriveResult a = drive_through(test::s_curve_move(), weak(0.2));
  const DriveResult b = drive_through(scaled(test::s_curve_move(), -1), weak(0.2));
  ASSERT_EQ(a.saturation.size(), b.saturation.size());
  for (std::size_t i = 0; i < a.saturation.size(); ++i) {
    EXPECT_EQ(a.saturation[i].sign, -b.saturation[i].sign);
    EXPECT_NEAR(a.saturation[i].from, b.saturation[i].from, 1e-9);
    EXPECT_NEAR(a.saturation[i].to, b.saturation[i].to, 1e-9);
  }
}

}  // namespace
}  // namespace jounce::saturation_test
