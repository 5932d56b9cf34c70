// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "jounce/axis/job.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/tables.hpp"
#include "support/short_interval.hpp"

namespace jounce::admit_test {
namespace {

using namespace test;

const AxisConfig generous{.limits = limits(1e6, 1e9)};

Cause cause_of(const std::optional<Refusal>& refusal) {
  return refusal ? refusal->cause : Cause::none;
}

// The 3-4-5 polynomial over a stroke h in time T: velocity 15/8 h/T at T/2, acceleration
// 10/sqrt(3) h/T^2 at T (1/2 - sqrt(3)/6), jerk 60 h/T^3 at the ends (VDI 2143).
struct Poly345 {
  double h = 50;
  double T = 0.5;
  double velocity = 15.0 / 8 * h / T;
  double acceleration = 10 / std::sqrt(3.0) * h / (T * T);
  double jerk = 60 * h / (T * T * T);

  [[nodiscard]] Job job() const {
    return Job(1, table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold,
                        {{0, T}, {0, h}, {0, 0}, {0, 0}}));
  }
};

// tests/design/input_check_test.cpp has the same borders for `jounce check`.
TEST(Admit, TheRoundingOfKnotsDoesNotExceedALimitByMoreThanAHundredth) {
  for (const ShortInterval& of : {of_a_cycle, of_a_part}) {
    const Job job(1, std::make_shared<const Table>(of.table()));
    const double jerk = std::abs(job.ranges()[3].peak().value);
    EXPECT_NEAR(jerk, 60 * of.bump / std::pow(of.length, 3), 0.2 * jerk);
    const auto admitted = [&](double excess) {
      return cause_of(admit(job, {.limits = limits(1e6, 1e9, jerk / (1 + excess))}, 0));
    };
    EXPECT_EQ(admitted(0.98 * of.permitted), Cause::none) << of.length;
    EXPECT_EQ(admitted(1.02 * of.permitted), Cause::jerk_limit) << of.length;
  }
}

// tests/design/input_check_test.cpp has the same borders. The acceleration of such an interval was a
// fault in the cycle, up to 1e10 of the limit.
TEST(Admit, TheRoundingOfNearPointsDoesNotExceedTheAccelerationByMoreThanAHundredth) {
  for (const double apart : {1e-8, 1e-9, 1e-11, 1e-12}) {
    const Job job(1, std::make_shared<const Table>(near_points(apart, 1)));
    const double peak = std::abs(job.ranges()[2].peak().value);
    ASSERT_GT(peak, 20) << apart;
    const auto admitted = [&](double excess) {
      return cause_of(admit(job, {.limits = limits(1e6, peak / (1 + excess))}, 0));
    };
    EXPECT_EQ(admitted(0.0098), Cause::none) << apart;
    EXPECT_EQ(admitted(0.0102), Cause::acceleration_limit) << apart;
  }
}

// A tick lies between the two points. The limits are the least that are admitted.
TEST(Admit, WhatIsAdmittedIsPlayed) {
  for (const double apart : {1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12})
    for (int units = 0; units < 4; ++units) {
      Job job(1, std::make_shared<const Table>(near_points(apart, units)));
      const double v = job.required()[0].limit;
      const double a = job.required()[1].limit;
      Bench bench({.limits = limits(v, a), .stop_acceleration = 1.1 * a});
      Tick tick = bench.play(job);
      EXPECT_EQ(tick.state, State::discrete_motion) << "not admitted";
      for (int k = 0; k < 2010; ++k) {
        tick = bench.step();
        ASSERT_EQ(tick.fault, Cause::none)
            << apart << " s, tick " << k << ", limits " << v << ", " << a;
      }
      EXPECT_EQ(tick.position, 10);
    }
}

TEST(Admit, AMasterThatLeavesACamWithASlopeStepsTheSlave) {
  const auto cam = table(Domain::master, Interpolation::linear, Extrapolation::hold,
                         {{0, 100}, {0, 1000}, {}, {}});
  const auto master = table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold,
                            {{0, 2}, {-50, 150}, {0, 0}, {0, 0}});
  Job job(1, master, cam);
  EXPECT_GT(std::abs(job.steps()[1].step), 1000) << "of the velocity, where the master comes in";
  EXPECT_EQ(cause_of(admit(job, {.limits = limits(1e6, 20000)}, 0)), Cause::velocity_step);
}

// The cam has the third derivative 1 - 3.5 (x - 17/32)^2 over [0, 1], and the master moves at the
// velocity 1: the jerk has its peak, 1, between the samples at 8/16 and 9/16.
TEST(Admit, ThePeakOfTheJerkOfACamIsFoundBetweenItsSamples) {
  const double z = 17.0 / 32;
  const auto power = [&](double x, int n) { return std::pow(x - z, n); };
  const double a0 = 3.5 / 3 * power(0, 3);
  const double v0 = 3.5 / 12 * power(0, 4);
  const double a = 1 - 3.5 / 3 * power(1, 3) + a0;
  const double v = 0.5 - 3.5 / 12 * power(1, 4) + a0 + v0;
  const double p = 1.0 / 6 - 3.5 / 60 * (power(1, 5) - power(0, 5)) + a0 / 2 + v0;
  const auto cam = table(Domain::master, Interpolation::quintic_hermite, Extrapolation::hold,
                         {{0, 1}, {0, p}, {0, v}, {0, a}});
  const auto master = table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
                            {{0, 1}, {0, 1}, {1, 1}, {}});
  const Range jerk = Job(1, master, cam).ranges()[3];
  EXPECT_NEAR(jerk.max.value, 1, 1e-9);
  EXPECT_NEAR(jerk.max.where, z, 1e-4);
}

TEST(Admit, RejectsAnImpossibleMotion) {
  const auto cam = table(Domain::master, Interpolation::linear, Extrapolation::advance,
                         {{0, 1}, {0, 1}, {}, {}});
  const auto far =
      table(Domain::time, Interpolation::linear, Extrapolation::hold, {{0, 1}, {0, 1e9}, {}, {}});
  EXPECT_THROW(Job(1, far, cam), InputError) << "1e9 periods";
  const auto cycle =
      table(Domain::time, Interpolation::linear, Extrapolation::advance, {{0, 1}, {0, 1}, {}, {}});
  EXPECT_THROW(Job(1, cycle), InputError) << "a table over time does not advance";
}

TEST(Admit, EachLimitOfA345PolynomialIsMetAtItsExactPeakAndBrokenJustBelow) {
  const Poly345 p;
  Job job = p.job();
  AxisConfig config{.limits = limits(p.velocity, p.acceleration, p.jerk)};
  // At rest at both ends, but the acceleration starts with a finite jerk: no step of it.
  EXPECT_FALSE(admit(job, config, 0));

  config.limits.velocity = p.velocity * (1 - 1e-6);
  auto refusal = admit(job, config, 0);
  ASSERT_EQ(cause_of(refusal), Cause::velocity_limit);
  EXPECT_NEAR(refusal->value, p.velocity, 1e-9 * p.velocity);
  EXPECT_EQ(refusal->limit, *config.limits.velocity);
  EXPECT_NEAR(refusal->where, p.T / 2, 1e-9);

  config.limits.velocity = p.velocity;
  config.limits.acceleration = p.acceleration * (1 - 1e-6);
  refusal = admit(job, config, 0);
  ASSERT_EQ(cause_of(refusal), Cause::acceleration_limit);
  // Equal and opposite on both sides of the middle.
  EXPECT_NEAR(std::abs(refusal->value), p.acceleration, 1e-9 * p.acceleration);
  EXPECT_NEAR(std::abs(refusal->where - p.T / 2), p.T * std::sqrt(3.0) / 6, 1e-7);

  config.limits.acceleration = p.acceleration;
  config.limits.jerk = p.jerk * (1 - 1e-6);
  EXPECT_EQ(cause_of(admit(job, config, 0)), Cause::jerk_limit);
}

TEST(Admit, PositionRangeAndStart) {
  const Poly345 p;
  Job job = p.job();
  AxisConfig config = generous;
  config.limits.position_min = 0;
  config.limits.position_max = 50;
  EXPECT_FALSE(admit(job, config, 0));
  EXPECT_FALSE(admit(job, config, 4e-8));  // 1e-9 of the stroke is 5e-8
  auto refusal = admit(job, config, 6e-8);
  ASSERT_EQ(cause_of(refusal), Cause::start_position);
  EXPECT_EQ(refusal->value, 0);
  EXPECT_EQ(refusal->limit, 6e-8);

  config.limits.position_max = 49;
  refusal = admit(job, config, 0);
  ASSERT_EQ(cause_of(refusal), Cause::position_limit);
  EXPECT_NEAR(refusal->value, 50, 1e-12);
  EXPECT_EQ(refusal->limit, 49);
  config.limits.position_max.reset();
  config.limits.position_min = 1;
  config.position = 1;
  EXPECT_EQ(cause_of(admit(job, config, 0)), Cause::position_limit);
}

TEST(Admit, StraightLinesPassExactlyIfNoTickExceedsTheAcceleration) {
  // PMC600 manual Fig. 5.13: 4.5 s through 10000, 50000, 40000, 35000; velocities 10000, 20000,
  // -10000, -10000. The largest step is from 20000 to -10000.
  Job job(1, table(Domain::time, Interpolation::linear, Extrapolation::hold,
                   {{0, 1, 3, 4, 4.5}, {0, 10000, 50000, 40000, 35000}, {}, {}}));
  AxisConfig config{.limits = limits(20000, 3e7)};
  EXPECT_FALSE(admit(job, config, 0));
  config.limits.acceleration = 2.9e7;
  auto refusal = admit(job, config, 0);
  ASSERT_EQ(cause_of(refusal), Cause::velocity_step);
  EXPECT_NEAR(refusal->value, -30000, 1e-9);
  EXPECT_NEAR(refusal->limit, 29000, 1e-9);
  EXPECT_EQ(refusal->where, 3);
  config.limits.acceleration = 0.9e7;
  EXPECT_EQ(cause_of(admit(job, config, 0)), Cause::start_velocity);
}

TEST(Admit, ATableThatDoesNotEndAtRest) {
  Job job(1, table(Domain::time, Interpolation::cubic_hermite, Extrapolation::hold,
                   {{10, 11}, {0, 1}, {0, 2}, {}}));
  const auto refusal = admit(job, {.limits = limits(10, 100)}, 0);
  ASSERT_EQ(cause_of(refusal), Cause::end_velocity);
  EXPECT_EQ(refusal->value, 2);
  EXPECT_DOUBLE_EQ(refusal->limit, 0.1);  // 100 u/s^2 for 1 ms
  EXPECT_EQ(refusal->where, 1);           // local time, though the table starts at 10 s
  EXPECT_EQ(refusal->text(), "end_velocity: The table does not end at rest: 2 at 1 s, limit 0.1.");
}

TEST(Refusal, HasNumbersOnlyWhereOneBrokeABound) {
  EXPECT_EQ(Refusal{.cause = Cause::not_enabled}.text(),
            "not_enabled: The axis or group is disabled.");
  const Refusal target{.cause = Cause::position_limit, .value = 400, .limit = 300};
  EXPECT_EQ(target.text(),
            "position_limit: A position is outside the position range: 400, limit 300.");
}

TEST(Admit, AnAccelerationStepCountsOnlyWhereJerkIsLimited) {
  Job job(1, trapezoid_table(10, 4, 8, 8));
  EXPECT_FALSE(admit(job, {.limits = limits(4, 8)}, 0));
  const auto refusal = admit(job, {.limits = limits(4, 8, 1000)}, 0);
  ASSERT_EQ(cause_of(refusal), Cause::acceleration_step);
  EXPECT_NEAR(std::abs(refusal->value), 8, 1e-9);
  EXPECT_DOUBLE_EQ(refusal->limit, 1);
}

TEST(Admit, AnAccelerationAtEitherEndIsAStepToo) {
  const AxisConfig config{.limits = limits(100, 100, 2000)};  // 2 u/s^2 in one tick
  const auto refusal_of = [&](double a0, double a1) {
    return admit(Job(1, table(Domain::time, Interpolation::quintic_hermite, Extrapolation::hold,
                              {{0, 1}, {0, 1}, {0, 0}, {a0, a1}})),
                 config, 0);
  };
  EXPECT_FALSE(refusal_of(2, -2));
  const auto at_start = refusal_of(3, 0);
  ASSERT_EQ(cause_of(at_start), Cause::acceleration_step);
  EXPECT_EQ(at_start->value, 3);
  EXPECT_EQ(at_start->where, 0);
  const auto at_end = refusal_of(0, -3);
  ASSERT_EQ(cause_of(at_end), Cause::acceleration_step);
  EXPECT_NEAR(at_end->value, -3, 1e-12);
  EXPECT_EQ(at_end->where, 1);
}

TEST(Admit, ARepeatingTableMustClose) {
  EXPECT_FALSE(admit(Job(1, there_and_back(3, 10, 1, Extrapolation::wrap)), generous, 3));
  Job open(1, table(Domain::time, Interpolation::quintic_hermite, Extrapolation::wrap,
                    {{0, 1}, {0, 5}, {0, 0}, {0, 0}}));
  const auto refusal = admit(open, generous, 0);
  ASSERT_EQ(cause_of(refusal), Cause::not_closed);
  EXPECT_EQ(refusal->value, 5);
  EXPECT_EQ(refusal->limit, 0);
}

TEST(Admit, Fig614CamAtConstantMasterHasThePrintedPeaks) {
  // Printed per degree of master: 3.392270802 and 0.1619234501, in the segment from 200 to 280.
  Job job(1, constant_master(1080, 200), pmc600_cam());
  // One unit of the last printed digit, which is cut off rather than rounded.
  EXPECT_NEAR(std::abs(job.ranges()[1].peak().value), 3.392270802 * 200, 1e-9 * 200);
  EXPECT_NEAR(std::abs(job.ranges()[2].peak().value), 0.1619234501 * 40000, 1e-10 * 40000);
  EXPECT_NEAR(job.ranges()[0].max.value, 232.361666, 1e-6);
  EXPECT_FALSE(admit(job, {.limits = limits(678.5, 6477)}, 0));
  EXPECT_EQ(cause_of(admit(job, {.limits = limits(678.4, 6477)}, 0)), Cause::velocity_limit);
  EXPECT_EQ(cause_of(admit(job, {.limits = limits(678.5, 6476)}, 0)), Cause::acceleration_limit);
}

TEST(Admit, MasterMustStayWithinACamThatRejects) {
  const TablePtr cam = table(Domain::master, Interpolation::quintic_hermite, Extrapolation::refuse,
                             {{0, 100}, {0, 10}, {0, 0}, {0, 0}});
  EXPECT_FALSE(admit(Job(1, trapezoid_table(100, 50, 100, 100), cam), generous, 0));
  const auto refusal = admit(Job(2, trapezoid_table(101, 50, 100, 100), cam), generous, 0);
  ASSERT_EQ(cause_of(refusal), Cause::master_outside_cam);
  EXPECT_NEAR(refusal->value, 1, 1e-12);
}

TEST(Admit, StepsWithinOneTickAddUp) {
  // From rest to 500 mm/s in fifty kinks of 10 mm/s, a microsecond apart: each alone is what
  // 1e4 mm/s^2 does in a tick, all of them in one tick are 5e5 mm/s^2.
  Columns c{{0}, {0}, {}, {}};
  const auto line = [&](double dt, double v) {
    c.x.push_back(c.x.back() + dt);
    c.p.push_back(c.p.back() + dt * v);
  };
  line(0.4, 0);
  for (int i = 1; i <= 50; ++i) line(1e-6, 10.0 * i);
  line(0.01, 500);
  for (int i = 49; i >= 1; --i) line(0.01, 10.0 * i);
  line(0.1, 0);
  Job job(1, std::make_shared<Table>(Domain::time, Interpolation::linear, Extrapolation::hold,
                                     std::move(c)));
  AxisConfig config;
  config.limits.velocity = 1000;
  config.limits.acceleration = 1e4;
  const auto refusal = admit(job, config, 0);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->cause, Cause::velocity_step);
  EXPECT_NEAR(refusal->value, 500, 1e-6);
  EXPECT_NEAR(refusal->where, 0.4, 1e-9);
}

TEST(Admit, ACamThatAdvancesAndWrapsJumps) {
  const TablePtr cam = table(Domain::master, Interpolation::quintic_hermite, Extrapolation::wrap,
                             {{0, 100}, {0, 10}, {0, 0}, {0, 0}});
  const auto refusal = admit(Job(1, trapezoid_table(200, 50, 100, 100), cam), generous, 0);
  ASSERT_EQ(cause_of(refusal), Cause::position_step);
  EXPECT_NEAR(refusal->value, -10, 1e-12);
}

// PMC600 manual 6.2, example 4.4: straight lines (0,0) (5000,5000) (10000,7000).
TEST(Admit, Example44NeedsAnAxisThatCanTakeItsKink) {
  const TablePtr cam = table(Domain::master, Interpolation::linear, Extrapolation::hold,
                             {{0, 5000, 10000}, {0, 5000, 7000}, {}, {}});
  // A master at constant velocity would throw the slave from rest to 10000 pulse/s and leave it at
  // 4000 pulse/s: refused unless one tick is enough for that.
  Job constant(1, constant_master(10000, 10000), cam);
  EXPECT_EQ(cause_of(admit(constant, {.limits = limits(1e4, 1e5)}, 0)), Cause::start_velocity);
  EXPECT_FALSE(admit(constant, {.limits = limits(1e4, 1e7)}, 0));

  // A master that starts and ends at rest leaves the kink at 5000: 10000 to 4000 pulse/s.
  Job smooth(2, trapezoid_table(10000, 10000, 1e5, 1e5), cam);
  const auto refusal = admit(smooth, {.limits = limits(1e4, 1e5)}, 0);
  ASSERT_EQ(cause_of(refusal), Cause::velocity_step);
  EXPECT_NEAR(refusal->value, -6000, 1e-6);
  EXPECT_NEAR(refusal->where, 0.55, 1e-9);  // 0.1 s and 500 pulses, then 4500 at 10000 pulse/s
  EXPECT_FALSE(admit(smooth, {.limits = limits(1e4, 6e6)}, 0));
}

TEST(Admit, TablesOfTheWrongAxisAreBadInput) {
  EXPECT_THROW(Job(1, pmc600_cam()), InputError);
  EXPECT_THROW(Job(1, pmc600_cam(), pmc600_cam()), InputError);
  EXPECT_THROW(Job(1, constant_master(1, 1), constant_master(1, 1)), InputError);
}

TEST(AxisConfigTest, NamesWhatIsMissingOrOutOfRange) {
  const auto key = [](const AxisConfig& config) {
    try {
      resolved(config);
    } catch (const InputError& error) {
      return error.key();
    }
    return std::string("none");
  };
  const Limits all = limits(1, 2, 3);
  Limits no_velocity = all;
  no_velocity.velocity.reset();
  Limits no_acceleration = all;
  no_acceleration.acceleration.reset();
  EXPECT_EQ(key({.limits = all}), "none");
  EXPECT_EQ(key({.limits = no_velocity}), "limits.velocity");
  EXPECT_EQ(key({.limits = no_acceleration}), "limits.acceleration");
  EXPECT_EQ(key({.period = 0, .limits = all}), "period");
  EXPECT_EQ(key({.limits = all, .stop_acceleration = 2}), "stop_acceleration");
  EXPECT_EQ(key({.limits = all, .stop_jerk = 1}), "stop_jerk");
  EXPECT_EQ(key({.limits = limits(1, 2, 1e5), .stop_jerk = 1.1e5}), "none");  // 1.1 * 1e5 > 1.1e5
  EXPECT_EQ(key({.limits = all, .position = NAN}), "position");
  EXPECT_EQ(key({.limits = all, .longest_gap = 0}), "longest_gap");
  EXPECT_EQ(resolved({.limits = all}).stop_acceleration, 4);
  EXPECT_EQ(resolved({.limits = all}).stop_jerk, 6);
}

}  // namespace
}  // namespace jounce::admit_test
