// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/drive.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include <Eigen/Eigenvalues>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/pvt/sample.hpp"

#include "support/errors.hpp"
#include "validate/exact_drive.hpp"
#include "validate/references.hpp"

namespace jounce::drive_test {
namespace {

using test::ExactDrive;
using test::MadeUp;

/// The default drive with a velocity loop so stiff that the load swings against a held motor.
Drive stiff_loop() {
  Drive drive = servo_400w();
  drive.controller.velocity_gain = 2;
  drive.controller.position_gain = 200;
  return drive;
}

double stroke_of(const Trajectory& f) {
  const Range range = extrema(f, 0);
  return range.max.value - range.min.value;
}

/// So strong that no torque limit is met, where a test is about something else.
Drive unlimited(Drive drive) {
  drive.motor.torque_limit = 1e6;
  return drive;
}

const Finding* find(const Report& report, const std::string& rule) {
  for (const Finding& f : report.findings)
    if (f.rule == rule) return &f;
  return nullptr;
}

/// Motor and load at every sample against matrix exponentials, within `share` of the stroke.
void expect_exact(const SignalView& reference, const Trajectory& same, const Drive& drive,
                  double share = 1e-9) {
  const DriveResult run = drive_through(reference, drive, {.samples = 201});
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
  ASSERT_EQ(run.samples.size(), 201u);
  const ExactDrive exact(drive);
  const double limit = share * stroke_of(same);
  for (const DriveSample& s : run.samples) {
    const auto x = exact.at(same, s.time);
    ASSERT_NEAR(s.motor, exact.motor(x), limit) << "at " << s.time;
    ASSERT_NEAR(s.load, exact.load(x), limit) << "at " << s.time;
    ASSERT_NEAR(s.following_error, s.reference - exact.motor(x), limit) << "at " << s.time;
  }
}

// ---- against the exact solution -----------------------------------------------------------------

TEST(Drive, AgreesWithMatrixExponentials) {
  const std::vector<Trajectory> moves{test::trapezoid_move(), test::s_curve_move(),
                                      test::law_345(3600, 0.4), test::law_345(-1, 0.1)};
  for (const Trajectory& move : moves)
    for (const Drive& drive : {servo_400w(), stiff_loop()}) expect_exact(move, move, drive);
}

TEST(Drive, AgreesWithMatrixExponentialsOnTables) {
  for (const Interpolation rule :
       {Interpolation::linear, Interpolation::cubic_hermite, Interpolation::quintic_hermite})
    for (const std::size_t intervals : {20u, 100u}) {
      const Table table = sample(test::law_345(3600, 0.4), rule, intervals).table;
      expect_exact(table, table.curve<OverTime>(), servo_400w());
    }
}

TEST(Drive, AgreesWithMatrixExponentialsWithoutIntegralPartAndFeedForward) {
  Drive drive = servo_400w();
  drive.controller.integral_time = 0;
  drive.controller.velocity_feed_forward = 0.7;
  drive.controller.torque_feed_forward = 0;
  expect_exact(test::trapezoid_move(), test::trapezoid_move(), drive);
}

TEST(Drive, TorqueAgreesWithMatrixExponentials) {
  const Trajectory move = test::law_345(3600, 0.4);
  const DriveResult run = drive_through(move, servo_400w(), {.samples = 501});
  const ExactDrive exact(servo_400w());
  for (const DriveSample& s : run.samples)
    ASSERT_NEAR(s.torque, exact.torque(exact.at(move, s.time)), 1e-7 * std::abs(run.torque.value));
}

/// The exact run on a fine grid over reference and standstill.
struct Grid {
  Peak torque, following_error, residual;
  double rms_torque = 0;

  Grid(const Trajectory& move, const Drive& drive, double settle) {
    const ExactDrive exact(drive);
    constexpr int steps = 40'000;  // even: Simpson's rule
    const double h = move.length() / steps;
    auto x = exact.rest(move.jet(0)[0]);
    exact.enter(x, move.segments()[0]);
    const ExactDrive::Matrix step = exact.transition(h);
    double sum = 0;
    for (int i = 0; i <= steps + static_cast<int>(settle / h); ++i) {
      if (i == steps) exact.hold(x, move.jet(move.end(), Side::left)[0]);
      const double now = exact.torque(x);
      raise(torque, now, i * h);
      raise(following_error, exact.reference(x) - exact.motor(x), i * h);
      if (i >= steps) raise(residual, exact.load(x) - exact.reference(x), i * h);
      if (i <= steps) sum += now * now * (i == 0 || i == steps ? 1 : (i % 2 == 1 ? 4 : 2));
      x = step * x;
    }
    rms_torque = std::sqrt(sum / (3 * steps));
  }

  static void raise(Peak& peak, double value, double where) {
    if (std::abs(value) > std::abs(peak.value)) peak = {value, where};
  }
};

TEST(Drive, PeaksAndRmsAreThoseOfTheExactSolution) {
  const Trajectory move = test::law_345(3600, 0.3);
  for (const Drive& drive : {servo_400w(), stiff_loop()}) {
    const DriveResult run = drive_through(move, drive, {.settle = 0.2});
    const Grid exact(move, drive, 0.2);
    EXPECT_NEAR(run.rms_torque, exact.rms_torque, 1e-6 * exact.rms_torque);
    EXPECT_NEAR(run.torque.value, exact.torque.value, 1e-5 * std::abs(exact.torque.value));
    EXPECT_NEAR(run.torque.where, exact.torque.where, 1e-3);
    EXPECT_NEAR(run.following_error.value, exact.following_error.value,
                1e-4 * std::abs(exact.following_error.value));
    EXPECT_NEAR(run.residual.value, exact.residual.value, 1e-4 * std::abs(exact.residual.value));
    const ExactDrive solution(drive);
    const auto end = solution.at(move, move.end());
    EXPECT_NEAR(run.end_following_error, 3600 - solution.motor(end), 1e-9 * 3600);
  }
}

// ---- closed forms -------------------------------------------------------------------------------

TEST(Drive, SteadyTorqueIsInertiaTimesAccelerationPlusFriction) {
  // Under constant acceleration the loop settles to a constant following error, so that
  // T = (J_m + J_l) a + (b_m + b_l) v, and cruising T = (b_m + b_l) v, once its slowest motion
  // (31.8 1/s) has died away: exp(-31.8) = 2e-14 after one second.
  Drive drive = servo_400w();
  drive.train[0].stiffness = 1e5;
  drive.train[0].damping = 1;
  const double a = 5000;
  const Trajectory move =
      trapezoid({.from = 0, .to = 20'000, .velocity = 10'000, .acceleration = a}).curve();
  ASSERT_EQ(move.breaks()[1], 2.0);
  const double radians = 2 * std::numbers::pi / 360;
  const double inertia = drive.motor.inertia + drive.train[0].inertia;
  const double friction = drive.motor.friction.viscous + drive.train[0].friction.viscous;
  const DriveResult run = drive_through(move, drive, {.settle = 0, .samples = 401});
  int seen = 0;
  for (const DriveSample& s : run.samples)
    if (s.time > 1 && s.time < 1.999) {
      const double expected = inertia * a * radians + friction * a * s.time * radians;
      ASSERT_NEAR(s.torque, expected, 1e-6 * expected) << "at " << s.time;
      ++seen;
    }
  EXPECT_GT(seen, 50);
}

TEST(Drive, AStiffAxisWithoutFrictionNeedsTheFeedForwardAlone) {
  // For a rigid shaft and no friction the feed-forward is the exact inverse: the following error
  // vanishes and T = (J_m + J_l) a at every instant. The rest is proportional to the twist J_l a /
  // c.
  Drive drive = servo_400w();
  drive.train[0].stiffness = 1e7;
  drive.train[0].damping = 10;
  drive.motor.friction.viscous = drive.train[0].friction.viscous = 0;
  const Trajectory move = test::law_345(3600, 0.4);
  const DriveResult run = drive_through(move, drive, {.samples = 301});
  const double radians = 2 * std::numbers::pi / 360;
  const double peak = 3600 * radians * 10 / std::sqrt(3.0) / (0.4 * 0.4) * 2.4e-4;
  EXPECT_NEAR(std::abs(run.torque.value), peak, 1e-5 * peak);
  for (const DriveSample& s : run.samples) {
    const double a = s.time < move.end() ? move.jet(s.time)[2] : 0;
    ASSERT_NEAR(s.torque, 2.4e-4 * radians * a, 1e-5 * peak) << "at " << s.time;
  }
  EXPECT_LT(std::abs(run.following_error.value), 1e-6 * 3600);
}

TEST(Drive, ResidualFrequencyIsThatOfTheLeastDampedMotion) {
  const Drive drive = stiff_loop();
  const Eigen::VectorXcd values = ExactDrive(drive).loop().eigenvalues();
  std::complex<double> swing;  // the oscillating motion that decays slowest
  double slowest = -std::numeric_limits<double>::infinity();
  for (const auto& value : values)
    if (value.imag() > 0 && value.real() > slowest) {
      slowest = value.real();
      swing = value;
    }
  const double frequency = swing.imag() / (2 * std::numbers::pi);
  const double held =
      std::sqrt(drive.train[0].stiffness / drive.train[0].inertia) / (2 * std::numbers::pi);
  EXPECT_NEAR(frequency, held, 0.05 * held);  // the load against a held motor: 79.6 Hz

  for (const double settle : {0.3, 5.0}) {  // at the end of the long one all swings have died away
    const DriveResult run = drive_through(test::trapezoid_move(), drive, {.settle = settle});
    EXPECT_NEAR(run.residual_frequency, frequency, 0.01 * frequency);
  }
}

TEST(Drive, APureDwellStaysAtRest) {
  const DriveResult run = drive_through(Trajectory({line(1, 5, 5)}), servo_400w(), {.samples = 3});
  EXPECT_TRUE(run.integration.ok());
  EXPECT_EQ(run.torque.value, 0);
  EXPECT_EQ(run.following_error.value, 0);
  EXPECT_EQ(run.residual_frequency, 0);
  EXPECT_EQ(run.samples[1].load, 5);
}

// ---- no move is missed --------------------------------------------------------------------------

/// Stand still, then out and back within `time`.
Trajectory dwell_out_and_back(double dwell, double time) {
  const Trajectory out = test::law_345(36, time / 2);
  return concatenated(concatenated(Trajectory({line(dwell, 0, 0)}, 0, Extrapolation::hold), out),
                      shifted(reversed(out), 0));
}

TEST(Drive, AMoveAfterADwellIsNotMissed) {
  for (const double time : {0.008, 0.03, 0.1, 0.4})
    for (const double dwell : {0.1, 0.6, 10.0}) {
      const Trajectory move = dwell_out_and_back(dwell, time);
      const DriveResult run = drive_through(move, unlimited(servo_400w()), {.settle = 0.05});
      ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
      const ExactDrive exact(servo_400w());
      double peak = 0;
      for (int i = 0; i <= 500; ++i)
        peak = std::max(peak, std::abs(exact.torque(exact.at(move, dwell + time * i / 500))));
      EXPECT_NEAR(std::abs(run.torque.value), peak, 1e-3 * peak) << dwell << ", " << time;
    }
}

TEST(Drive, AMoveWhoseAccelerationVanishesAtEveryKnotIsNotMissed) {
  // Rest to rest between any two knots of the table: at the knots the right-hand side is zero.
  const Table table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold,
                    {{0, 1, 1.01, 1.02}, {0, 0, 36, 0}, {0, 0, 0, 0}, {0, 0, 0, 0}});
  const Trajectory curve = table.curve<OverTime>();
  const Drive drive = unlimited(servo_400w());
  expect_exact(table, curve, drive, 1e-8);  // the loop cannot follow: all of it is error
  EXPECT_GT(std::abs(drive_through(table, drive).torque.value), 1);
}

TEST(Drive, OneSegmentOutAndBackIsNotMissed) {
  Segment f;  // s^3 (1 - s)^3: position, velocity and acceleration vanish at both ends
  f.length = 0.02;
  f.degree = 6;
  f.c = {0, 0, 0, 3600, -10'800, 10'800, -3600};
  const Trajectory move = concatenated(Trajectory({line(2, 0, 0)}), Trajectory({f}));
  const Drive drive = unlimited(servo_400w());
  expect_exact(move, move, drive, 1e-8);
  const DriveResult run = drive_through(move, drive);
  EXPECT_GT(std::abs(run.following_error.value), 0.1);
}

TEST(Drive, AMoveHiddenWithinOneLongIntervalIsNotMissed) {
  // p = 3600 exp(-((t - 5) / w)^2), out and back within about 1 s of an interval of 10 s.
  const auto hidden = [](double t, Side) {
    constexpr double w = 0.25;
    const double u = (t - 5) / w;
    const double p = 3600 * std::exp(-u * u);
    return Jet{p, -2 * u / w * p, (4 * u * u - 2) / (w * w) * p,
               (12 * u - 8 * u * u * u) / (w * w * w) * p};
  };
  std::vector<double> fine;
  for (int i = 0; i <= 100; ++i) fine.push_back(0.1 * i);
  const DriveResult known = drive_through(MadeUp{hidden, fine}, servo_400w());
  const DriveResult run = drive_through(MadeUp{hidden, {0, 10}}, servo_400w());
  ASSERT_TRUE(run.integration.ok());
  EXPECT_GT(std::abs(known.torque.value), 0.1);
  EXPECT_NEAR(run.torque.value, known.torque.value, 1e-4 * std::abs(known.torque.value));
  EXPECT_NEAR(run.following_error.value, known.following_error.value,
              1e-4 * std::abs(known.following_error.value));
}

TEST(Drive, BeginsAnewAtJumpsOnly) {
  // The start and the three steps of acceleration; the start; the start and the standstill.
  EXPECT_EQ(drive_through(test::trapezoid_move(), servo_400w()).integration.restarts, 4);
  const Table table = sample(test::law_345(3600, 0.4), Interpolation::quintic_hermite, 400u).table;
  EXPECT_EQ(drive_through(table, servo_400w(), {.settle = 0.1}).integration.restarts, 1);
  const Trajectory ramp({line(0.5, 0, 360)});
  EXPECT_EQ(drive_through(ramp, servo_400w()).integration.restarts, 2);
}

// ---- invariants ---------------------------------------------------------------------------------

TEST(Drive, MirroredReferenceGivesMirroredRun) {
  const DriveResult a = drive_through(test::s_curve_move(), servo_400w());
  const DriveResult b = drive_through(scaled(test::s_curve_move(), -1), servo_400w());
  EXPECT_DOUBLE_EQ(a.torque.value, -b.torque.value);
  EXPECT_DOUBLE_EQ(a.following_error.value, -b.following_error.value);
  EXPECT_DOUBLE_EQ(a.rms_torque, b.rms_torque);
}

TEST(Drive, PlaceAndInstantOfTheStartDoNotMatter) {
  const DriveResult here = drive_through(test::s_curve_move(), servo_400w());
  const DriveResult far = drive_through(shifted(test::s_curve_move(), 1e4, 1e6), servo_400w());
  EXPECT_NEAR(far.torque.value, here.torque.value, 1e-7 * here.torque.value);
  EXPECT_NEAR(far.torque.where - 1e4, here.torque.where, 1e-6);
  EXPECT_NEAR(far.following_error.value, here.following_error.value,
              1e-6 * std::abs(here.following_error.value));
}

TEST(Drive, UnitsOfPositionScaleOut) {
  Drive millimeters = servo_400w();
  millimeters.position_per_rev = 10;
  const DriveResult degrees = drive_through(test::s_curve_move(), servo_400w());
  const DriveResult run = drive_through(scaled(test::s_curve_move(), 10.0 / 360), millimeters);
  EXPECT_NEAR(run.torque.value, degrees.torque.value, 1e-9);
  EXPECT_NEAR(run.following_error.value * 36, degrees.following_error.value, 1e-9);
}

TEST(Drive, AFollowedCamIsAReference) {
  CamSpec spec{{0, 0, 0, 0}, {}, true};
  spec.segments = {{Law::modified_sine, {180, 40, {}, {}}, ""},
                   {Law::poly345, {360, 0, {}, {}}, ""}};
  const Followed slave(
      design(spec).cam,
      trapezoid({.from = 0, .to = 720, .velocity = 720, .acceleration = 3600}).curve());
  const DriveResult run = drive_through(slave, servo_400w());
  EXPECT_TRUE(run.report.ok());
  // The same motion as a fine table of its own knots.
  Columns columns;
  for (int i = 0; i <= 2400; ++i) {
    const double t = i == 2400 ? slave.end() : slave.end() * i / 2400;
    const Motion m = slave.at(t, i == 2400 ? Side::left : Side::right);
    columns.x.push_back(t);
    columns.p.push_back(m.position);
    columns.v.push_back(m.velocity);
    columns.a.push_back(m.acceleration);
  }
  const Table table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold, columns);
  EXPECT_NEAR(drive_through(table, servo_400w()).rms_torque, run.rms_torque, 1e-3 * run.rms_torque);
}

TEST(Drive, AReferenceThatStartsMovingIsMetAtRest) {
  const Trajectory ramp({line(0.5, 0, 360)});
  expect_exact(ramp, ramp, servo_400w());
}

TEST(Drive, BreaksTooCloseToBeDistinguishedAreCrossed) {
  std::vector<Segment> segments;
  const Trajectory move = test::law_345(360, 0.5);
  for (const double s : {0.0, 0.3, 0.6}) {
    segments.push_back(part(move.segments()[0], s, s + 1e-13));
    segments.push_back(part(move.segments()[0], s + 1e-13, s + 4e-12));
    segments.push_back(part(move.segments()[0], s + 4e-12, s + 2e-10));
    segments.push_back(part(move.segments()[0], s + 2e-10, std::min(s + 0.3, 1.0)));
  }
  segments.push_back(part(move.segments()[0], 0.9, 1));
  expect_exact(Trajectory(segments), move, servo_400w());
}

// ---- report -------------------------------------------------------------------------------------

TEST(Drive, LimitsGivenAreChecked) {
  const Trajectory move = test::s_curve_move();
  const DriveResult free = drive_through(move, servo_400w());
  EXPECT_TRUE(free.report.ok());
  ASSERT_EQ(free.report.findings.size(), 1u);
  EXPECT_EQ(free.report.findings[0].rule, "drive/saturation");
  EXPECT_NEAR(free.report.findings[0].margin, 1 - std::abs(free.torque.value) / 3.8, 1e-12);

  const DriveLimits wide{.torque = 1, .rms_torque = 1, .following_error = 1, .residual = 1};
  const DriveResult within = drive_through(move, servo_400w(), {.limits = wide});
  EXPECT_TRUE(within.report.ok());
  EXPECT_EQ(within.report.findings.size(), 5u);

  const DriveLimits tight{
      .torque = 0.1, .rms_torque = 0.1, .following_error = 0.01, .residual = 0.01};
  const DriveResult beyond = drive_through(move, servo_400w(), {.limits = tight});
  EXPECT_EQ(beyond.report.broken(), 4u);
  const Finding* error = find(beyond.report, "drive/following_error");
  ASSERT_NE(error, nullptr);
  EXPECT_EQ(error->value, beyond.following_error.value);
  EXPECT_EQ(error->where, beyond.following_error.where);
  EXPECT_NEAR(error->margin, 1 - std::abs(error->value) / 0.01, 1e-9);
  EXPECT_EQ(std::signbit(error->limit), std::signbit(error->value));
}

TEST(Drive, SamplesSpanReferenceAndStandstill) {
  const Trajectory move = shifted(test::s_curve_move(), 3);
  const DriveResult run = drive_through(move, servo_400w(), {.settle = 0.1, .samples = 7});
  ASSERT_EQ(run.samples.size(), 7u);
  EXPECT_EQ(run.samples.front().time, 3);
  EXPECT_NEAR(run.samples.back().time, move.end() + 0.1, 1e-12);
  EXPECT_EQ(run.samples.front().reference, 0);
  EXPECT_EQ(run.samples.back().reference, 3600);
  EXPECT_EQ(drive_through(move, servo_400w(), {.settle = 0, .samples = 1}).samples.size(), 1u);
}

// ---- trouble ------------------------------------------------------------------------------------

TEST(Drive, RunningOutOfStepsIsAnOutcome) {
  const DriveResult run = drive_through(test::s_curve_move(), servo_400w(), {.max_steps = 100});
  EXPECT_EQ(run.integration.ended, Ended::too_many_steps);
  EXPECT_EQ(run.integration.steps, 100);
  EXPECT_LT(run.integration.reached, 0.58);
  EXPECT_FALSE(run.report.ok());
  EXPECT_NE(find(run.report, "drive/integration"), nullptr);
}

TEST(Drive, AReferenceThatIsNotFiniteIsAnOutcome) {
  const MadeUp signal{[](double t, Side) {
    return Jet{t, 1, t > 0.5 ? std::numeric_limits<double>::quiet_NaN() : 0, 0};
  }};
  const DriveResult run = drive_through(signal, servo_400w());
  EXPECT_EQ(run.integration.ended, Ended::not_finite);
  EXPECT_LT(run.integration.reached, 0.81);
  EXPECT_FALSE(run.report.ok());
}

TEST(Drive, AnExceptionOfTheReferenceComesThroughTheSolver) {
  int calls = 0;
  const MadeUp signal{[&calls](double t, Side) -> Jet {
    if (++calls > 40) throw std::runtime_error("out of paper");
    return {std::sin(t), std::cos(t), -std::sin(t), -std::cos(t)};
  }};
  EXPECT_THROW(static_cast<void>(drive_through(signal, servo_400w())), std::runtime_error);
}

template <class Change>
std::string refused(Change change) {
  Drive drive = servo_400w();
  DriveOptions options;
  change(drive, options);
  return test::key_of([&] { drive_through(test::law_345(1, 1), drive, options); }, "nothing");
}

TEST(Drive, RejectsParametersOutOfRangeByName) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused([](Drive& d, auto&) { d = {}; }), "motor.inertia");
  EXPECT_EQ(refused([&](Drive& d, auto&) { d.motor.inertia = nan; }), "motor.inertia");
  EXPECT_EQ(refused([](Drive& d, auto&) { d.train[0].inertia = 0; }), "mass[1].inertia");
  EXPECT_EQ(refused([](Drive& d, auto&) { d.train[0].stiffness = -1; }), "mass[1].stiffness");
  EXPECT_EQ(refused([](Drive& d, auto&) { d.train[0].damping = -1; }), "mass[1].damping");
  EXPECT_EQ(refused([](Drive& d, auto&) { d.motor.friction.viscous = -1; }),
            "motor.friction.viscous");
  EXPECT_EQ(refused([](Drive& d, auto&) { d.train[0].friction.viscous = -1; }),
            "mass[1].friction.viscous");
  EXPECT_EQ(refused([](Drive& d, auto&) { d.controller.position_gain = 0; }),
            "controller.position_gain");
  EXPECT_EQ(refused([](Drive& d, auto&) { d.controller.velocity_gain = 0; }),
            "controller.velocity_gain");
  EXPECT_EQ(refused([](Drive& d, auto&) { d.controller.integral_time = -1; }),
            "controller.integral_time");
  EXPECT_EQ(refused([&](Drive& d, auto&) { d.controller.velocity_feed_forward = nan; }),
            "controller.velocity_feed_forward");
  EXPECT_EQ(refused([](Drive& d, auto&) { d.controller.torque_feed_forward = -1; }),
            "controller.torque_feed_forward");
  EXPECT_EQ(refused([](Drive& d, auto&) { d.motor.torque_limit = 0; }), "motor.torque_limit");
  EXPECT_EQ(refused([](Drive& d, auto&) { d.position_per_rev = 0; }), "position_per_rev");
  EXPECT_EQ(refused([](auto&, DriveOptions& o) { o.settle = -1; }), "settle");
  EXPECT_EQ(refused([](auto&, DriveOptions& o) { o.tolerance = 1; }), "tolerance");
  EXPECT_EQ(refused([](auto&, DriveOptions& o) { o.max_steps = 0; }), "max_steps");
  EXPECT_EQ(refused([](auto&, DriveOptions& o) { o.limits.torque = 0; }), "limits.torque");
  EXPECT_EQ(refused([](auto&, DriveOptions& o) { o.limits.rms_torque = -1; }), "limits.rms_torque");
  EXPECT_EQ(refused([](auto&, DriveOptions& o) { o.limits.following_error = 0; }),
            "limits.following_error");
  EXPECT_EQ(refused([](auto&, DriveOptions& o) { o.limits.residual = 0; }), "limits.residual");
  EXPECT_EQ(refused([](auto&, auto&) {}), "nothing");
}

template <class Reference>
concept Drivable = requires(const Reference& r, const Drive& d) {
  drive_through(r, d);
};
static_assert(Drivable<Trajectory> && Drivable<Table> && Drivable<Followed> && !Drivable<Cam>);

TEST(Drive, RejectsATableOverMasterPosition) {
  const Table table(Domain::master, Interpolation::linear, Extrapolation::hold,
                    {{0, 1}, {0, 1}, {}, {}});
  try {
    drive_through(table, servo_400w());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), "axis");
  }
}

}  // namespace
}  // namespace jounce::drive_test
