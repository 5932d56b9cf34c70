// SPDX-License-Identifier: Apache-2.0
#include "jounce/gear/gear_in_pos.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/s_curve.hpp"

#include "support/errors.hpp"
#include "support/invariants.hpp"
#include "support/random.hpp"

namespace jounce::gear_in_pos_test {
namespace {

/// PMC600 manual 6.1, example 6.2.
GearInPosSpec example_62() {
  return {.numerator = 1,
          .denominator = 2,
          .master_sync_position = 5000,
          .slave_sync_position = 2000,
          .master_start_distance = 4000};
}

TEST(GearInPos, OfTheManualsExampleIsInSyncAt5000And2000) {
  const GearInPos gear = gear_in_pos(example_62());
  ASSERT_TRUE(gear);
  const SyncCam made = sync_cam(gear, 0, 10000);
  EXPECT_EQ(made.segments, (std::vector<std::string>{"hold", "engage", "gear"}));
  const Cam& cam = made.cam;
  EXPECT_EQ(cam.jet(1000)[0], 0);
  EXPECT_EQ(cam.jet(1000)[1], 0);
  EXPECT_NEAR(cam.jet(5000)[0], 2000, 1e-12);
  EXPECT_NEAR(cam.jet(5000)[1], 0.5, 1e-15);
  EXPECT_NEAR(cam.jet(5000, Side::left)[1], 0.5, 1e-15);
  EXPECT_NEAR(cam.jet(5000, Side::left)[2], 0, 1e-17);
  EXPECT_NEAR(cam.jet(10000, Side::left)[0], 4500, 1e-12);
  EXPECT_NEAR(extrema(cam, 1).max.value, 0.756, 1e-12);
  test::expect_invariants(cam, 2);
}

TEST(GearInPos, StaysInSyncThroughReversalsOfItsMaster) {
  const GearInPos gear = gear_in_pos(example_62());
  const Trajectory there =
      trapezoid({.to = 10000, .velocity = 10000, .acceleration = 100000}).curve();
  const Trajectory back =
      trapezoid({.from = 10000, .to = 0, .velocity = 10000, .acceleration = 100000}).curve();
  const Trajectory master = concatenated(concatenated(there, back), there);
  const GearedInPos slave(gear, master);
  ASSERT_TRUE(slave.in_sync());
  EXPECT_NEAR(master.at(*slave.in_sync()).position, 5000, 1e-9);
  EXPECT_NEAR(slave.at(there.end()).position, 4500, 1e-9);
  EXPECT_NEAR(slave.at(2 * there.end()).position, -500, 1e-9) << "not 0: it does not disengage";
  EXPECT_NEAR(slave.at(master.end()).position, 4500, 1e-9);
  EXPECT_NEAR(slave.at(1.0).velocity, 5000, 1e-9);

  // The step of each cycle agrees with the exact signal, up to the acceleration.
  GearInPosState state;
  double peak_jump = 0;
  for (int n = 0; n <= 3300; ++n) {
    const double t = n * 1e-3;
    const GearInPosStep now = step(gear, state, master.jet(t));
    const Jet exact = slave.jet(t);
    for (std::size_t k = 0; k < 3; ++k)  // the jerk steps where a cycle meets a break
      peak_jump = std::max(peak_jump, std::abs(now.slave[k] - exact[k]) / std::pow(1e3, k));
    EXPECT_EQ(now.in_sync, t >= *slave.in_sync() - 1e-12) << t;
    EXPECT_EQ(now.start_sync, now.in_sync || master.at(t).position >= 1000) << t;
    EXPECT_EQ(now.status, GearInPosStatus::ok) << t;
    state = now.state;
  }
  EXPECT_LT(peak_jump, 1e-6);
}

TEST(GearInPos, StaysStillWhileTheMasterTrembles) {
  const GearInPos gear = gear_in_pos(example_62());
  GearInPosState state;
  double slave = 0;
  int reported = 0;
  const auto x = [](int n) {  // to 3000, back to 500, and through
    const double s = n / 1000.0;
    return s < 1 ? 3000 * s : s < 2 ? 3000 - 2500 * (s - 1) : 500 + 6000 * (s - 2);
  };
  for (int n = 0; n <= 3000; ++n) {
    const double v = 1000 * (x(n + 1) - x(n));
    const GearInPosStep now = step(gear, state, {x(n), v, 0, 0});
    EXPECT_LE(std::abs(now.slave[0] - slave), 0.76 * 6) << n;
    slave = now.slave[0];
    if (now.status == GearInPosStatus::master_reversed) ++reported;
    state = now.state;
  }
  EXPECT_GT(reported, 700);
  EXPECT_LT(reported, 900) << "not once the slave stands again";
  EXPECT_EQ(state.phase, GearInPosState::Phase::in_sync);
  EXPECT_NEAR(slave, 2000 + 0.5 * (6500 - 5000), 1e-9);
}

TEST(GearInPos, WaitsForAMasterThatIsPastTheStart) {
  const GearInPos gear = gear_in_pos(example_62());
  GearInPosState state;
  const auto at = [&](double x, double v) {
    const GearInPosStep now = step(gear, state, {x, v, 0, 0});
    state = now.state;
    return now;
  };
  EXPECT_EQ(at(2000, 10).status, GearInPosStatus::start_passed);
  EXPECT_EQ(at(6000, 10).status, GearInPosStatus::start_passed);
  EXPECT_EQ(at(6000, 10).slave[0], 0) << "it does not jump on";
  EXPECT_EQ(at(900, -10).status, GearInPosStatus::ok);
  EXPECT_FALSE(at(950, 10).start_sync);
  EXPECT_TRUE(at(1100, 10).start_sync);
  EXPECT_TRUE(at(5000, 10).in_sync);
}

TEST(GearInPos, PredictsThatALinearMasterIsPastTheStart) {
  GearInPosSpec spec = example_62();
  spec.master_position = 1000;
  EXPECT_TRUE(gear_in_pos(spec));
  spec.master_position = 1500;
  EXPECT_EQ(gear_in_pos(spec).status, GearInPosStatus::start_passed);
  spec.master_period = 6000;
  const GearInPos next = gear_in_pos(spec);
  ASSERT_TRUE(next);
  EXPECT_EQ(next.master_start, 7000) << "a turn later";
  EXPECT_EQ(next.master_sync, 11000);
}

TEST(GearInPos, EngagesBackwards) {
  GearInPosSpec spec = example_62();
  spec.master_start_distance = -4000;
  spec.slave_start = 4000;
  const GearInPos gear = gear_in_pos(spec);
  ASSERT_TRUE(gear);
  const SyncCam made = sync_cam(gear, 0, 10000);
  EXPECT_EQ(made.segments, (std::vector<std::string>{"gear", "engage", "hold"}));
  EXPECT_NEAR(made.cam.jet(9000)[0], 4000, 1e-12);
  EXPECT_NEAR(made.cam.jet(5000)[0], 2000, 1e-12);
  EXPECT_NEAR(made.cam.jet(0)[0], -500, 1e-12);
  test::expect_invariants(made.cam, 2);
  GearInPosState state;
  bool in_sync = false;
  for (double x = 9500; x >= 4000; x -= 7) {
    const GearInPosStep now = step(gear, state, {x, -7000, 0, 0});
    EXPECT_NEAR(now.slave[0], made.cam.jet(x)[0], 1e-9) << x;
    in_sync = now.in_sync;
    state = now.state;
  }
  EXPECT_TRUE(in_sync);
}

// ---- the window, and AvoidReversal -------------------------------------------------------------

TEST(EngageWindow, IsBoundedByTheExtrema) {
  test::Random random(3);
  for (int n = 0; n < 500; ++n) {
    GearInPosSpec spec;
    spec.numerator = (n % 2 == 0 ? 1 : -1) * (1 + random.below(1000));
    spec.denominator = 1 + random.below(1000);
    spec.master_sync_position = random.uniform(-1e4, 1e4);
    spec.slave_start = random.uniform(-1e4, 1e4);
    const double k = static_cast<double>(spec.numerator) / static_cast<double>(spec.denominator);
    const double rho = random.uniform(0.2, 4);
    spec.master_start_distance = (n % 3 == 0 ? -1 : 1) * random.log_uniform(1, 1e5);
    spec.slave_sync_position = spec.slave_start + k * spec.master_start_distance / rho;
    const EngageWindow window = engage_window(spec);
    EXPECT_NEAR(window.rho, rho, 1e-9);
    const GearInPos gear = gear_in_pos(spec);
    const Range slope = extrema(*gear.curve, 1);
    const double most = k > 0 ? slope.max.value : -slope.min.value;
    const double back = k > 0 ? slope.min.value : -slope.max.value;
    const bool turns_back = back < -1e-9 * std::abs(k);
    const bool too_fast = most > std::abs(k) * (1 + 1e-9);
    EXPECT_EQ(turns_back, rho > 2.5) << rho;
    EXPECT_EQ(too_fast, rho < 5.0 / 3) << rho;
    EXPECT_EQ(window.advice.empty(), !turns_back && !too_fast) << rho;
    spec.avoid_reversal = true;
    EXPECT_EQ(gear_in_pos(spec).status,
              turns_back ? GearInPosStatus::reversal_on_linear_axis : GearInPosStatus::ok);
  }
}

TEST(EngageWindow, ReportsPossibleDistances) {
  const EngageWindow window = engage_window(example_62());
  EXPECT_EQ(window.rho, 1);
  EXPECT_NEAR(window.least, 20000 / 3.0, 1e-9);
  EXPECT_NEAR(window.greatest, 10000, 1e-9);
  EXPECT_NE(
      window.advice.find("to 10000 instead of 4000: the slave exceeds the velocity of the gear"),
      std::string::npos)
      << window.advice;
  GearInPosSpec against = example_62();
  against.slave_start = 3000;
  EXPECT_FALSE(engage_window(against).exists);
  EXPECT_EQ(engage_window(against).advice, "the slave moves against the gear: it must reverse");
}

TEST(AvoidReversal, TakesAModuloSlaveTurnsFurther) {
  GearInPosSpec spec = example_62();  // k D = 2000
  spec.slave_sync_position = 100;     // rho 20
  spec.avoid_reversal = true;
  EXPECT_EQ(gear_in_pos(spec).status, GearInPosStatus::reversal_on_linear_axis);
  spec.slave_period = 360;  // h >= 800: 100 + 2 * 360 = 820
  const GearInPos gear = gear_in_pos(spec);
  ASSERT_TRUE(gear);
  EXPECT_EQ(gear.turns, 2);
  EXPECT_EQ(gear.slave_sync, 820);
  EXPECT_GE(extrema(*gear.curve, 1).min.value, -1e-12);
  spec.slave_period = 140;  // exactly: 100 + 5 * 140 = 800, rho 5/2
  EXPECT_EQ(gear_in_pos(spec).turns, 5);
  spec.slave_period = 139;
  EXPECT_EQ(gear_in_pos(spec).status, GearInPosStatus::reversal_unavoidable);
  EXPECT_EQ(static_cast<int>(gear_in_pos(spec).status), 776);
  spec.slave_period = 360;
  spec.numerator = -1;  // k D = -2000, h = 100 - 3 * 360 = -980
  EXPECT_EQ(gear_in_pos(spec).turns, -3);
}

TEST(GearInPos, TakesOtherLaws) {
  for (const Law law : {Law::septic, Law::nonic, Law::modified_sine, Law::poly345}) {
    GearInPosSpec spec = example_62();
    spec.law = law;
    spec.slave_sync_position = 1000;  // rho 2
    const GearInPos gear = gear_in_pos(spec);
    ASSERT_TRUE(gear) << name(law);
    EXPECT_NEAR(gear.curve->jet(5000, Side::left)[1], 0.5, 1e-12) << name(law);
    EXPECT_NEAR(gear.curve->jet(5000, Side::left)[0], 1000, 1e-9) << name(law);
  }
  GearInPosSpec spec = example_62();
  spec.law = Law::double_harmonic;
  EXPECT_THROW(gear_in_pos(spec), InputError);
}

TEST(GearInPos, RejectsValuesOutOfRange) {
  const auto key_of = [](auto change) -> std::string {
    GearInPosSpec spec = example_62();
    change(spec);
    return test::key_of([&] { gear_in_pos(spec); });
  };
  EXPECT_EQ(key_of([](auto& s) { s.denominator = 0; }), "denominator");
  EXPECT_EQ(key_of([](auto& s) { s.numerator = 0; }), "numerator");
  EXPECT_EQ(key_of([](auto& s) { s.master_start_distance = 0; }), "master_start_distance");
  EXPECT_EQ(key_of([](auto& s) { s.slave_period = 0; }), "slave_period");
  EXPECT_EQ(key_of([](auto& s) { s.slave_start = NAN; }), "slave_start");
  const GearInPos gear = gear_in_pos(example_62());
  EXPECT_THROW(sync_cam(gear, 1001, 10000), InputError);
  EXPECT_THROW(sync_cam(gear, 0, 4999), InputError);
  EXPECT_EQ(sync_cam(gear, 1000, 5000).segments, std::vector<std::string>{"engage"});
}

}  // namespace
}  // namespace jounce::gear_in_pos_test
