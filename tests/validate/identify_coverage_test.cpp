// SPDX-License-Identifier: Apache-2.0
// Intervals of fits in many random cases: a drive, a start of the fit and a noise each. The recordings
// come from the integration (drive_through), the fits from matrix exponentials (DriveStepper).
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/validate/identify.hpp"

#include "support/random.hpp"
#include "validate/references.hpp"
#include "validate/src/identify/setpoint_curve.hpp"
#include "validate/src/identify/stepped_response.hpp"

namespace jounce::identify_coverage_test {
namespace {

using test::Random;
using ::testing::HasSubstr;
using Status = Identification::Status;

const std::vector<std::string> fitted_keys{"motor.inertia", "mass[1].inertia", "mass[1].stiffness"};

double normal_of(Random& random) {
  return std::sqrt(-2 * std::log(random.uniform(1e-300, 1))) *
         std::cos(2 * std::numbers::pi * random.uniform(0, 1));
}

/// Noise of the standard deviation 1; each value has this share of the one before.
class Noise {
 public:
  explicit Noise(double share) : share_(share) {}

  double operator()(Random& random) {
    const double fresh = normal_of(random);
    last_ = started_ ? share_ * last_ + std::sqrt(1 - share_ * share_) * fresh : fresh;
    started_ = true;
    return last_;
  }

 private:
  double share_;
  double last_ = 0;
  bool started_ = false;
};

double total_inertia_of(const Drive& drive) {
  return drive.motor.inertia + drive.train[0].inertia;
}

std::array<double, 3> truth_of(const Drive& drive) {
  return {drive.motor.inertia, drive.train[0].inertia, drive.train[0].stiffness};
}

Drive random_drive(Random& random) {
  Drive drive = servo_400w();
  drive.motor.inertia *= random.uniform(0.6, 1.6);
  drive.train[0].inertia *= random.uniform(0.6, 1.6);
  drive.train[0].stiffness *= random.uniform(0.6, 1.6);
  return drive;
}

/// A recording every ms, and its setpoints.
Recording recorded_in_cycles(const Trajectory& move, const Drive& drive, double settle) {
  constexpr double cycle = 1e-3;
  const auto samples = static_cast<std::size_t>(std::lround((move.length() + settle) / cycle)) + 1;
  const DriveResult run = drive_through(move, drive, {.settle = settle, .samples = samples});
  EXPECT_TRUE(run.integration.ok());
  Recording r;
  for (const DriveSample& s : run.samples) {
    r.time.push_back(s.time);
    r.command.push_back(s.reference);
    r.position.push_back(s.motor);
    r.torque.push_back(s.torque);
    const Jet at = s.time < move.end() - cycle / 2 ? move.jet(s.time) : Jet{s.reference, 0, 0, 0};
    r.setpoints.push_back({s.time, at[0], at[1], at[2]});
  }
  return r;
}

struct Held {
  std::array<int, 3> numbers{};
  int feed_forward = 0;
  int misfits = 0;
};

/// `share`: correlation of successive values of the noise.
Held held_in(int cases, double share) {
  const Trajectory move = test::law_345(360, 0.1);
  Held held;
  for (int seed = 1; seed <= cases; ++seed) {
    Random random(static_cast<std::uint64_t>(seed) * 7919);
    const Drive truth = random_drive(random);
    Recording run = recorded_in_cycles(move, truth, 0.1);
    Noise position(share), torque(share);
    for (std::size_t i = 0; i < run.time.size(); ++i) {
      run.position[i] += 2e-3 * position(random);
      run.torque[i] += 5e-3 * torque(random);
    }
    // The controller keeps the feed-forward of the true inertia, which the start does not have.
    const Identification found = identify(run, {random_drive(random), fitted_keys});
    EXPECT_TRUE(found.usable()) << "seed " << seed << ": " << found.reason;
    if (!found.usable() || !found.feed_forward) continue;
    held.misfits += found.status == Status::misfit ? 1 : 0;
    const auto values = truth_of(truth);
    for (std::size_t j = 0; j < values.size(); ++j)
      held.numbers[j] += found.numbers[j].low <= values[j] && values[j] <= found.numbers[j].high;
    const double used = total_inertia_of(truth);
    held.feed_forward += found.feed_forward->low <= used && used <= found.feed_forward->high;
  }
  return held;
}

// Binomial(200, 0.95): fewer than 180 and more than 198 have a probability of about 0.1 % each.
TEST(IdentifyCoverage, FittedIntervalsHoldTheTruthInWhiteNoise) {
  const Held held = held_in(200, 0);
  for (std::size_t j = 0; j < fitted_keys.size(); ++j) {
    EXPECT_GE(held.numbers[j], 180) << fitted_keys[j];
    EXPECT_LE(held.numbers[j], 198) << fitted_keys[j];
  }
  EXPECT_GE(held.feed_forward, 180);
  EXPECT_LE(held.misfits, 8);  // 1 % of 200, two quantities; more than 8 in 0.1 % of the cases
}

// The noise is taken for an error of the model, which the status states; the intervals hold all the same.
TEST(IdentifyCoverage, FittedIntervalsHoldTheTruthInCorrelatedNoise) {
  const Held held = held_in(200, 0.7);
  for (std::size_t j = 0; j < fitted_keys.size(); ++j)
    EXPECT_GE(held.numbers[j], 180) << fitted_keys[j];
  EXPECT_GE(held.feed_forward, 180);
  EXPECT_GE(held.misfits, 190);
}

// ---- setpoints ------------------------------------------------------------------------------------

TEST(SetpointCurve, GoesThroughItsSetpointsAndJoinsAStandstill) {
  // 5 + 100 (t - 0.2)^3 from 0.2 on
  const validate_detail::SetpointCurve curve(
      {{0, 5, 0, 0}, {0.1, 5, 0, 0}, {0.2, 5, 0, 0}, {0.3, 5.1, 3, 60}, {0.5, 7.7, 27, 180}});
  EXPECT_THAT(curve.breaks(), ::testing::ElementsAre(0, 0.2, 0.3, 0.5));
  EXPECT_NEAR(curve.cycle(), 0.1, 1e-15);
  EXPECT_EQ(curve.jet(0.13)[0], 5);
  for (const double t : {0.25, 0.3, 0.4, 0.5})
    for (const Side side : {Side::left, Side::right}) {
      const Jet at = curve.jet(t, side);
      const double s = t - 0.2;
      EXPECT_NEAR(at[0], 5 + 100 * s * s * s, 1e-12) << t;
      EXPECT_NEAR(at[1], 300 * s * s, 1e-10) << t;
      EXPECT_NEAR(at[2], 600 * s, 1e-9) << t;
    }
}

/// The response by matrix exponentials is that of the integration, with its derivatives.
TEST(SteppedResponse, AgreesWithTheIntegration) {
  const Trajectory move = test::law_345(360, 0.1);
  const Drive drive = servo_400w();
  const Recording run = recorded_in_cycles(move, drive, 0.05);
  const validate_detail::SetpointCurve curve(run.setpoints);
  const std::vector<double> values{4.4e-5, 1.8e-4, 55};
  const validate_detail::ResponseSpec spec{&drive, fitted_keys, values, run.time, 1e-10};
  const auto grid = validate_detail::grid_of({curve, &curve}, spec);
  ASSERT_TRUE(grid.has_value());
  const auto stepped = validate_detail::stepped_response({curve, &curve}, *grid, spec);
  const auto integrated = validate_detail::respond(curve, spec);
  for (std::size_t k = 0; k < validate_detail::outputs; ++k) {
    double value = 0, slope = 0;
    for (const double v : integrated.value[k]) value = std::max(value, std::abs(v));
    for (const double v : integrated.by[k]) slope = std::max(slope, std::abs(v));
    for (std::size_t i = 0; i < integrated.value[k].size(); ++i)
      EXPECT_NEAR(stepped.value[k][i], integrated.value[k][i], 1e-6 * value) << k << " " << i;
    for (std::size_t i = 0; i < integrated.by[k].size(); ++i)
      EXPECT_NEAR(stepped.by[k][i], integrated.by[k][i], 1e-5 * slope) << k << " " << i;
  }
}

TEST(Setpoints, OfARecordingThatBeginsInMotionAreRejected) {
  Recording run = recorded_in_cycles(test::law_345(360, 0.1), servo_400w(), 0.05);
  run.setpoints.front().velocity = 1;
  try {
    static_cast<void>(identify(run, {servo_400w(), fitted_keys}));
    ADD_FAILURE() << "not rejected";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("must begin at standstill"));
  }
}

}  // namespace
}  // namespace jounce::identify_coverage_test
