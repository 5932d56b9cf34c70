// SPDX-License-Identifier: Apache-2.0
#include "jounce/validate/linear_drive.hpp"

#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/cam/coupling/followed.hpp"
#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/pvt/sample.hpp"

#include "support/errors.hpp"
#include "support/random.hpp"
#include "validate/references.hpp"

namespace jounce::linear_drive_test {
namespace {

using Json = nlohmann::json;

const Json& oracle() {
  static const Json all =
      Json::parse(std::ifstream(JOUNCE_SOURCE_DIR "/tests/oracle/linear_drive.json"));
  return all;
}

Drive two_mass() {
  return servo_400w();
}

Mass mass(double inertia, double viscous, double stiffness, double damping, double load = 0) {
  Mass m;
  m.inertia = inertia;
  m.friction.viscous = viscous;
  m.stiffness = stiffness;
  m.damping = damping;
  m.load_torque = load;
  return m;
}

Drive four_mass() {
  Drive drive = servo_400w();
  drive.train = {mass(5e-5, 0, 400, 1e-3), mass(1e-4, 1e-4, 120, 2e-3, 0.1),
                 mass(5e-5, 0, 200, 1e-3)};
  drive.controller.position_gain = 60;
  drive.controller.velocity_gain = 0.08;
  drive.controller.integral_time = 0.03;
  drive.controller.velocity_feed_forward = 0.9;
  drive.controller.torque_feed_forward = 0.8;
  drive.controller.friction_feed_forward = 0.5;
  drive.motor.current_lag = 1e-4;
  return drive;
}

Drive lagging() {
  Drive drive = four_mass();
  drive.train = {mass(2e-4, 1e-4, 50, 5e-3, 0.1)};
  drive.controller.position_gain = 40;
  drive.controller.velocity_gain = 0.05;
  drive.controller.integral_time = 0.02;
  drive.motor.current_lag = 2e-4;
  return drive;
}

Drive with_pendulum() {
  Drive drive = servo_400w();
  drive.pendulum = Pendulum{4, 0.01, 0.3};
  return drive;
}

Drive rigid() {
  Drive drive = servo_400w();
  drive.train = {mass(2e-4, 1e-4, 0, 0, 0.05)};
  drive.controller.position_gain = 100;
  drive.controller.velocity_gain = 0.1;
  drive.controller.integral_time = 0;
  drive.controller.torque_feed_forward = 0.5;
  return drive;
}

Drive named(const std::string& name) {
  if (name == "two_mass") return two_mass();
  if (name == "four_mass") return four_mass();
  if (name == "lagging") return lagging();
  if (name == "pendulum") return with_pendulum();
  return rigid();
}

Trajectory reference(const std::string& name) {
  std::vector<Segment> segments;
  for (const Json& piece : oracle().at("references").at(name)) {
    Segment f;
    f.length = piece.at(0);
    for (const double c : piece.at(1)) f.c[static_cast<std::size_t>(f.degree++)] = c;
    --f.degree;
    for (const Json& s : piece.at(2))
      f.sine[static_cast<std::size_t>(f.sines++)] = {s.at(0), s.at(1), s.at(2)};
    segments.push_back(f);
  }
  return Trajectory(segments, 0, Extrapolation::hold);
}

std::vector<double> milliseconds(double end) {
  std::vector<double> times;
  for (int i = 0; i * 1e-3 <= end; ++i) times.push_back(i * 1e-3);
  return times;
}

double torque_peak(const ExactRun& run) {
  double peak = 0;
  for (const DriveSample& s : run.samples) peak = std::max(peak, std::abs(s.torque));
  return peak;
}

/// Two runs in all outputs, shares of the stroke and of the peak torque.
void expect_same(const std::vector<DriveSample>& a, const std::vector<DriveSample>& b,
                 double stroke, double torque, double share) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    ASSERT_NEAR(a[i].motor, b[i].motor, share * stroke) << "at " << a[i].time;
    ASSERT_NEAR(a[i].load, b[i].load, share * stroke) << "at " << a[i].time;
    ASSERT_NEAR(a[i].following_error, b[i].following_error, share * stroke) << "at " << a[i].time;
    ASSERT_NEAR(a[i].torque, b[i].torque, share * torque) << "at " << a[i].time;
  }
}

// ---- against 30 digits --------------------------------------------------------------------------

TEST(LinearDrive, AgreesWithThirtyDigits) {
  for (const Json& c : oracle().at("cases")) {
    SCOPED_TRACE(c.at("drive").get<std::string>() + ", " + c.at("reference").get<std::string>() +
                 ", cycle " + c.at("cycle").dump());
    Drive drive = named(c.at("drive"));
    drive.controller.cycle = c.at("cycle");
    drive.controller.delay = c.at("delay");
    std::vector<double> times;
    std::vector<DriveSample> truth;
    for (const Json& s : c.at("samples")) {
      times.push_back(s.at(0));
      truth.push_back({s.at(0), s.at(4), s.at(2), s.at(3), s.at(1),
                       s.at(4).get<double>() - s.at(2).get<double>(), 0});
    }
    const Trajectory move = reference(c.at("reference"));
    const ExactRun run = exact_run(move, drive, times);
    const double stroke = move.jet(move.end(), Side::left)[0];
    const double torque = torque_peak(run);
    // A sampled controller differentiates the angle's last digit.
    const double share = drive.controller.cycle > 0 ? 1e-10 : 1e-11;
    ASSERT_LT(torque, 20) << "a drive that is stable";
    expect_same(run.samples, truth, stroke, torque, share);
    EXPECT_NEAR(run.rms_torque, c.at("rms_torque").get<double>(), share * run.rms_torque);
  }
}

// ---- against CVODES -----------------------------------------------------------------------------

/// Samples equally spaced as drive_through() makes them, at the same instants.
void expect_witnessed(const SignalView& signal, const Trajectory& same, const Drive& drive,
                      double tolerance = 1e-11) {
  DriveOptions options;
  options.settle = 0.1;
  options.samples = 201;
  options.tolerance = tolerance;
  const DriveResult run = drive_through(signal, drive, options);
  ASSERT_TRUE(run.integration.ok()) << run.integration.reason;
  std::vector<double> times;
  for (const DriveSample& s : run.samples) times.push_back(s.time);
  const ExactRun exact = exact_run(same, drive, times);
  const Range range = extrema(same, 0);
  const double stroke = range.max.value - range.min.value;
  expect_same(run.samples, exact.samples, stroke, torque_peak(exact), 1e-8);
  for (std::size_t i = 0; i < times.size(); ++i)
    ASSERT_NEAR(run.samples[i].velocity, exact.samples[i].velocity,
                1e-8 * std::abs(run.velocity.value));
  EXPECT_NEAR(run.rms_torque, exact.rms_torque, 1e-8 * exact.rms_torque);
  EXPECT_NEAR(run.end_following_error, exact.end_following_error, 1e-8 * stroke);
}

Drive unlimited(Drive drive) {
  drive.motor.torque_limit = 1e6;
  return drive;
}

TEST(LinearDrive, IsTheWitnessOfTheIntegration) {
  for (const char* name : {"trapezoid", "s_curve", "cycloid", "law_4567"}) {
    SCOPED_TRACE(name);
    const Trajectory move = reference(name);
    for (const Drive& drive : {two_mass(), four_mass(), with_pendulum(), lagging(), rigid()})
      expect_witnessed(move, move, unlimited(drive));
  }
}

TEST(LinearDrive, IsTheWitnessOfADelay) {
  Drive drive = two_mass();
  drive.controller.delay = 5e-4;
  const Trajectory move = reference("s_curve");
  expect_witnessed(move, move, unlimited(drive));
}

TEST(LinearDrive, IsTheWitnessOfASampledController) {
  const Trajectory move =
      test::law_345(360, 0.1);  // the end is no sample instant but for one cycle
  for (const double cycle : {0.00025, 0.00023})
    for (const double delay : {0.0, 0.00025, 0.0003}) {
      Drive drive = unlimited(lagging());
      drive.controller.cycle = cycle;
      drive.controller.delay = delay;
      expect_witnessed(move, move, drive, 1e-12);  // begins anew 1600 times
    }
}

TEST(LinearDrive, IsTheWitnessOfTheIntegrationOfTables) {
  const Table table = sample(reference("law_4567"), Interpolation::quintic_hermite, 50u).table;
  expect_witnessed(table, table.curve<OverTime>(), unlimited(two_mass()));
}

// ---- second opinion -----------------------------------------------------------------------------

TEST(LinearDrive, GivesASecondOpinionOnARun) {
  for (const char* name : {"trapezoid", "s_curve", "cycloid", "law_4567"})
    for (const Drive& drive : {two_mass(), with_pendulum(), rigid()}) {
      const Trajectory move = reference(name);
      DriveResult run = drive_through(move, unlimited(drive), {.samples = 101});
      const auto opinion = exact_opinion(move, unlimited(drive), run);
      ASSERT_TRUE(opinion);
      EXPECT_FALSE(opinion->broken) << name << ": " << opinion->value;
      run.samples[50].load += 1;  // a wrong run is reported
      EXPECT_TRUE(exact_opinion(move, unlimited(drive), run)->broken);
    }
}

TEST(LinearDrive, HasNoOpinionWhereThereIsNoExactSolution) {
  const Trajectory move = reference("s_curve");
  Drive drive = unlimited(two_mass());
  EXPECT_FALSE(exact_opinion(move, drive, drive_through(move, drive)));  // no samples
  drive.motor.friction.coulomb = 0.01;
  EXPECT_FALSE(exact_opinion(move, drive, drive_through(move, drive, {.samples = 11})));
  Drive weak = two_mass();
  weak.motor.torque_limit = 0.2;
  EXPECT_FALSE(exact_opinion(move, weak, drive_through(move, weak, {.samples = 11})));
}

TEST(LinearDrive, AFollowedCamBehindASteadyMasterHasSegments) {
  CamSpec spec{{0, 0, 0, 0}, {}, true};
  spec.segments = {{Law::modified_sine, {150, 40, {}, {}}, ""},
                   {Law::poly345, {360, 0, {}, {}}, ""}};
  const Cam cam = design(spec).cam;
  for (const double to : {900.0, -900.0}) {
    const Followed slave(cam, Trajectory({line(1.7, 100, 100 + to), line(0.4, 100 + to, 100 + to)},
                                         3, Extrapolation::hold));
    const auto same = SignalView(slave).trajectory();
    ASSERT_TRUE(same);
    for (int i = 0; i <= 1000; ++i) {
      const double t = i == 1000 ? slave.end() : 3 + 2.1 * i / 1000;
      const Side side = i == 1000 ? Side::left : Side::right;
      const Jet a = slave.jet(t, side), b = same->jet(t, side);
      for (std::size_t k = 0; k < 3; ++k)
        ASSERT_NEAR(a[k], b[k], 1e-9 * std::pow(20, k) * 40) << t << ", " << k;
    }
  }
  const Followed ramped(cam, Trajectory({quintic(1, 0, 0, 0, 360, 0, 0)}, 0, Extrapolation::hold));
  EXPECT_FALSE(SignalView(ramped).trajectory());
}

// ---- what does not need a solution --------------------------------------------------------------

TEST(LinearDrive, DoesNotDependOnTheTimesAskedFor) {
  test::Random random(7);
  for (const Drive& drive : {two_mass(), four_mass(), with_pendulum(), rigid()})
    for (const double cycle : {0.0, 0.00021}) {
      Drive d = drive;
      d.controller.cycle = cycle;
      const Trajectory move = reference("cycloid");
      std::vector<double> scattered;
      for (double t = 0; t < 0.5; t += random.log_uniform(1e-9, 0.05)) scattered.push_back(t);
      const ExactRun run = exact_run(move, d, scattered);
      for (std::size_t i = 0; i < scattered.size(); i += 7) {
        const double alone[] = {scattered[i]};
        const DriveSample s = exact_run(move, d, alone).samples[0];
        ASSERT_NEAR(s.load, run.samples[i].load, 1e-11 * 720) << "at " << scattered[i];
        ASSERT_NEAR(s.torque, run.samples[i].torque, 1e-11 * 10) << "at " << scattered[i];
      }
    }
}

TEST(LinearDrive, PlaceAndInstantOfTheStartDoNotMatter) {
  const Trajectory move = reference("s_curve");
  std::vector<double> times = milliseconds(0.7);
  const ExactRun here = exact_run(move, four_mass(), times);
  for (double& t : times) t += 64;
  const ExactRun far = exact_run(shifted(move, 64, 4096), four_mass(), times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    ASSERT_NEAR(far.samples[i].load - 4096, here.samples[i].load, 1e-9);
    ASSERT_NEAR(far.samples[i].torque, here.samples[i].torque, 1e-8);
  }
}

TEST(LinearDrive, ASampledControllerTendsToTheContinuousOne) {
  const Trajectory move = reference("s_curve");
  const std::vector<double> times = milliseconds(0.6);
  const ExactRun continuous = exact_run(move, two_mass(), times);
  double before = 0;
  for (const double cycle : {4e-4, 2e-4, 1e-4}) {
    Drive drive = two_mass();
    drive.controller.cycle = cycle;
    const ExactRun run = exact_run(move, drive, times);
    double worst = 0;
    for (std::size_t i = 0; i < times.size(); ++i)
      worst = std::max(worst, std::abs(run.samples[i].load - continuous.samples[i].load));
    if (before > 0) {
      EXPECT_NEAR(before / worst, 2, 0.3) << cycle;  // the error is of first order
    }
    before = worst;
  }
}

TEST(LinearDrive, RepeatedEigenvaluesNeedNoCase) {
  // Two decoupled equal loops would do; a rigid drive tuned so that both poles fall on one does too:
  // J s^2 + (b + K_v) s + K_v K_p = 0 with K_p = (b + K_v)^2 / (4 J K_v).
  Drive drive = rigid();
  const double inertia = 2.4e-4;
  const double damping = 2e-4 + drive.controller.velocity_gain;
  drive.controller.position_gain =
      damping * damping / (4 * inertia * drive.controller.velocity_gain);
  const double pole = damping / (2 * inertia);
  // A step of s turns decays as (1 + p t) exp(-p t), less the load torque's share.
  const Trajectory step({line(1e-3, 0, 0), line(1, 360, 360)});
  drive.train[0].load_torque = 0;
  const std::vector<double> times{0.001, 0.003, 0.011, 0.101};
  const ExactRun run = exact_run(step, drive, times);
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double t = times[i] - 1e-3;
    EXPECT_NEAR(run.samples[i].following_error, 360 * (1 + pole * t) * std::exp(-pole * t), 1e-9);
  }
}

TEST(LinearDrive, TakesThousandsOfTimeConstantsAtOnce) {
  Drive drive = four_mass();
  drive.motor.current_lag = 1e-7;  // a pole at 1e7 rad/s
  const Trajectory move = concatenated(Trajectory({line(500, 0, 0)}), reference("s_curve"));
  const std::vector<double> times{500.2, 501.5, 2000};
  const ExactRun run = exact_run(move, drive, times);
  const std::vector<double> early{0.2, 1.5};
  const ExactRun alone = exact_run(reference("s_curve"), drive, early);
  // After the dwell the load torque has been carried for long, without it it is met at the start.
  EXPECT_NEAR(run.samples[2].motor, 3600, 1e-6);
  EXPECT_NEAR(run.samples[1].motor, alone.samples[1].motor, 1e-6);
}

// ---- modes --------------------------------------------------------------------------------------

TEST(LinearDrive, ModesOfARigidAxisAreThoseOfItsPolynomial) {
  Drive drive = rigid();
  drive.train[0].load_torque = 0;
  const double inertia = 2.4e-4;
  const double damping = 2e-4 + drive.controller.velocity_gain;
  drive.controller.position_gain = 400;
  const double stiffness = drive.controller.velocity_gain * 400;
  const std::vector<DriveMode> found = modes(drive);
  ASSERT_EQ(found.size(), 1u);
  const double w = std::sqrt(stiffness / inertia);
  const double d = damping / (2 * inertia) / w;
  ASSERT_LT(d, 1);
  EXPECT_NEAR(found[0].damping, d, 1e-12);
  EXPECT_NEAR(found[0].frequency, w * std::sqrt(1 - d * d) / (2 * std::numbers::pi), 1e-9);
}

TEST(LinearDrive, WhatIsLeftAddsUpToTheResidual) {
  // After the end the load is the sum of the modes: their envelopes bound it, and a pendulum's mode
  // alone is left after the others have died away.
  const Trajectory move = reference("law_4567");
  const Drive drive = with_pendulum();
  const std::vector<DriveMode> left = free_vibration(move, drive);
  double sum = 0;
  for (const DriveMode& m : left) sum += m.residual;
  const std::vector<double> times = milliseconds(6);
  const ExactRun run = exact_run(move, drive, times);
  const DriveMode* slow = nullptr;
  for (const DriveMode& m : left)
    if (m.frequency > 0 && (slow == nullptr || m.rate < slow->rate)) slow = &m;
  ASSERT_NE(slow, nullptr);
  double late = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const double after = times[i] - move.end();
    if (after < 0) continue;
    const double error = std::abs(run.samples[i].load - 1800);
    ASSERT_LE(error, sum * (1 + 1e-9));
    const double envelope = slow->residual * std::exp(-slow->rate * after);
    if (after > 3) late = std::max(late, error / envelope);
  }
  EXPECT_NEAR(late, 1, 1e-3);
}

TEST(LinearDrive, SimilarModesAreNotDistinguished) {
  Drive drive = rigid();
  const double damping = 2e-4 + drive.controller.velocity_gain;
  drive.controller.position_gain =
      damping * damping / (4 * 2.4e-4 * drive.controller.velocity_gain);
  for (const DriveMode& m : free_vibration(reference("s_curve"), drive))
    EXPECT_TRUE(std::isnan(m.residual));
}

// ---- responses ----------------------------------------------------------------------------------

TEST(LinearDrive, ResponsesAreAffineInTheReference) {
  const Trajectory a = reference("law_4567");
  std::vector<Segment> other{a.segments()[0]};
  other[0].c = {0, 0, 0, 100, 50, -20, 7, 3};
  const Trajectory c(other, 0, Extrapolation::hold);
  for (const DriveOutput output : {DriveOutput::torque, DriveOutput::following_error,
                                   DriveOutput::load_error, DriveOutput::load}) {
    const auto f = response(four_mass(), output, milliseconds(0.5));
    const auto fa = f(a), fc = f(c), both = f(sum(a, c));
    const auto none = f(scaled(a, 0));
    for (std::size_t i = 0; i < fa.size(); ++i) ASSERT_NEAR(both[i], fa[i] + fc[i] - none[i], 1e-8);
  }
}

// ---- trouble ------------------------------------------------------------------------------------

template <class Change>
std::string refused(Change change) {
  Drive drive = servo_400w();
  std::vector<double> times{0, 0.1};
  change(drive, times);
  return test::key_of([&] { exact_run(reference("s_curve"), drive, times); }, "nothing");
}

TEST(LinearDrive, RejectsWhatIsNotLinearByName) {
  EXPECT_EQ(refused([](Drive& d, auto&) { d.motor.friction.coulomb = 0.1; }),
            "motor.friction.coulomb");
  EXPECT_EQ(refused([](Drive& d, auto&) { d.train[0].backlash = 0.1; }), "mass[1].backlash");
  EXPECT_EQ(refused([](Drive& d, auto&) { d.train[0].efficiency = 0.9; }), "mass[1].efficiency");
  EXPECT_EQ(refused([](Drive& d, auto&) { d.train[0].gravity_torque = 0.9; }),
            "mass[1].gravity_torque");
  EXPECT_EQ(refused([](Drive& d, auto&) {
              d.controller.cycle = 1e-3;
              d.controller.encoder_counts = 1000;
            }),
            "controller.encoder_counts");
  EXPECT_EQ(refused([](auto&, auto& t) { t = {0.2, 0.1}; }), "times[2]");
  EXPECT_EQ(refused([](auto&, auto& t) { t = {-0.2, 0.1}; }), "times[1]");
  EXPECT_EQ(refused([](auto&, auto& t) {
              t = {0.2, std::numeric_limits<double>::quiet_NaN()};
            }),
            "times[2]");
  EXPECT_EQ(refused([](auto&, auto&) {}), "nothing");
}

}  // namespace
}  // namespace jounce::linear_drive_test
