// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/tables.hpp"
#include "support/loop_limit.hpp"

namespace jounce::coupling_test {
namespace {

using namespace test;

CouplingSpec ramp(StartMode start = StartMode::ramp_in) {
  return {.start = start, .velocity_diff = 100, .acceleration = 2000, .jerk = 50000};
}

AxisConfig axis_at(double position) {
  return {.limits = limits(900, 10000), .position = position};
}

Cause cause(const Job& job, double position) {
  const auto refusal = admit(job, axis_at(position), position);
  return refusal ? refusal->cause : Cause::none;
}

/// Three periods of Fig. 6.14 behind a master at 200 pulse/s.
Job example_43(const CouplingSpec& coupling, double position) {
  return Job(1, constant_master(1080, 200), pmc600_cam(), 1e-3, coupling, position);
}

/// Runs the job to its end and compares every step with the axis's limits.
Tick run(Job& job, double position, double& largest_step) {
  Bench bench(axis_at(position));
  bench.send(Kind::enable);
  EXPECT_FALSE(bench.arm(job).refused);
  Tick last = bench.send(Kind::start);
  EXPECT_DOUBLE_EQ(last.position, position) << "local time 0: it is where it stood";
  largest_step = 0;
  for (test::LoopLimit loop; last.job != 0 && loop.goes_on();) {
    const Tick now = bench.step();
    largest_step = std::max(largest_step, std::abs(now.position - last.position));
    last = now;
  }
  return last;
}

// PMC600 manual 6.2, example 4.3, by an axis that does not stand at the cam's first point.
TEST(CoupledJob, PlaysExample43FromWhereTheAxisStands) {
  const double p0 = -17;
  EXPECT_EQ(cause(example_43({}, p0), p0), Cause::start_position) << "absolute: it would jump";
  for (const StartMode mode : {StartMode::ramp_in, StartMode::ramp_in_pos}) {
    Job job = example_43(ramp(mode), p0);
    ASSERT_EQ(cause(job, p0), Cause::none);
    EXPECT_EQ(job.duration(), 5.4);
    // In step from master 75 on: the slave at master + 25 and 200 pulse/s, in each period.
    for (const double master : {150.0, 199.0, 360 + 75.5, 720 + 100.0}) {
      const Setpoint now = job.at(master / 200);
      EXPECT_NEAR(now.slave[0], 25 + std::fmod(master, 360), 1e-9) << master;
      EXPECT_NEAR(now.slave[1], 200, 1e-9) << master;
    }
    double step = 0;
    const Tick end = run(job, p0, step);
    EXPECT_NEAR(end.position, 0, 1e-9);
    EXPECT_LE(step, 0.9) << "no step beyond the velocity limit";
  }
}

// PMC600 manual 6.2, example 4.4: here with ramps of the master and a limit that takes the kink.
TEST(CoupledJob, PlaysExample44ByARelativeStart) {
  const TablePtr cam = table(Domain::master, Interpolation::linear, Extrapolation::refuse,
                             {{0, 5000, 10000}, {0, 5000, 7000}, {}, {}});
  const TablePtr master = trapezoid_table(10000, 10000, 1e5, 1e5);
  const CouplingSpec relative{.start = StartMode::relative};
  Job job(1, master, cam, 1e-3, relative, 1234);
  const AxisConfig config{.limits = limits(2e4, 6e6), .position = 1234};
  ASSERT_FALSE(admit(job, config, 1234));
  EXPECT_DOUBLE_EQ(job.at(0).slave[0], 1234);
  EXPECT_DOUBLE_EQ(job.at(0.5).slave[1], 10000);
  EXPECT_DOUBLE_EQ(job.at(0.6).slave[1], 4000);
  EXPECT_DOUBLE_EQ(job.last().slave[0], 1234 + 7000);
}

TEST(CoupledJob, ScalesAndMovesLikeTheLibrary) {
  CouplingSpec spec = ramp();
  spec.master_scaling = 2;
  spec.master_offset = 30;
  spec.slave_scaling = 0.5;
  spec.slave_offset = 4;
  const TablePtr cam = pmc600_cam();
  const TablePtr master = trapezoid_table(1080, 200, 1000, 1000);
  Job job(1, master, cam, 1e-3, spec, 55);
  ASSERT_FALSE(admit(job, {.limits = limits(1e4, 1e6), .position = 55}, 55));
  const Coupling coupling(cam->curve<OverMaster>(), spec);
  const Engagement in = engage(coupling, {.position = 55}, master->jet(0), 0);
  for (double t = 0; t < 5; t += 0.037) {
    const Jet expected = point(coupling, in.engaged, master->jet(t), t);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(job.at(t).slave[k], expected[k], 1e-8) << t;
  }
}

TEST(CoupledJob, ARampOutlastsItsMaster) {
  CouplingSpec slow = ramp();
  slow.velocity_diff = 1;
  Job job(1, trapezoid_table(100, 200, 1000, 1000), pmc600_cam(), 1e-3, slow, 99);
  EXPECT_GT(job.duration(), 98);
  ASSERT_EQ(cause(job, 99), Cause::none);
  double step = 0;
  EXPECT_NEAR(run(job, 99, step).position, pmc600_cam()->jet(100)[0], 1e-9);
}

TEST(CoupledJob, AStopInTheRampStaysOnItsPath) {
  Job job(1, trapezoid_table(1080, 200, 1000, 1000), pmc600_cam(), 1e-3, ramp(), -30);
  Bench bench(axis_at(-30));
  bench.play(job, 150);
  Tick last = bench.send(Kind::stop);
  for (test::LoopLimit loop; last.job != 0 && loop.goes_on();) {
    const Tick now = bench.step();
    EXPECT_LE(std::abs(now.velocity - last.velocity), 20000 * 1e-3 + 1e-9);
    last = now;
  }
  EXPECT_EQ(last.fault, Cause::none);
  EXPECT_EQ(last.stopped, 1U);
}

TEST(CoupledJob, RejectionsHaveTheirCauses) {
  EXPECT_EQ(cause(example_43(ramp(StartMode::ramp_in_neg), -17), -17), Cause::would_reverse);
  EXPECT_EQ(cause(example_43(ramp(), -17), -18), Cause::start_position) << "it was moved since";
  EXPECT_EQ(cause(example_43(ramp(), 1e60), 1e60), Cause::no_ramp);

  const CouplingSpec over_master{.start = StartMode::ramp_in_distance, .distance = 100};
  EXPECT_EQ(cause(example_43(over_master, 20), 20), Cause::none);
  CouplingSpec far = over_master;
  far.distance = 2000;
  EXPECT_EQ(cause(example_43(far, 20), 20), Cause::not_in_sync);

  const TablePtr there_and_back_again = there_and_back(0, 360, 10, Extrapolation::wrap);
  const auto repeating = [&](const CouplingSpec& spec, double position) {
    return cause(Job(1, there_and_back_again, pmc600_cam(), 1e-3, spec, position), position);
  };
  EXPECT_EQ(repeating(ramp(), 5), Cause::not_closed);
  EXPECT_EQ(repeating({.start = StartMode::relative}, 5), Cause::none);

  const TablePtr refusing = table(Domain::master, Interpolation::linear, Extrapolation::refuse,
                                  {{0, 100}, {0, 1}, {}, {}});
  Job doubled(1, trapezoid_table(51, 200, 1000, 1000), refusing, 1e-3, {.master_scaling = 2}, 0);
  const auto refusal = admit(doubled, axis_at(0), 0);
  ASSERT_TRUE(refusal);
  EXPECT_EQ(refusal->cause, Cause::master_outside_cam);
  EXPECT_NEAR(refusal->value, 2, 1e-9) << "in the cam's own unit";

  EXPECT_THROW(example_43({.slave_scaling = -1}, 0), InputError);
}

TEST(CoupledJob, ARampBreaksALimitOnlyTogetherWithItsCam) {
  // Alone, the cam reaches 678 pulse/s; a ramp of up to 300 on top of it goes beyond 900.
  CouplingSpec fast = ramp();
  fast.velocity_diff = 300;
  fast.acceleration = 8000;
  Job job = example_43(fast, 200);
  const auto refusal = admit(job, {.limits = limits(700, 1e5), .position = 200}, 200);
  EXPECT_FALSE(admit(example_43({}, 0), {.limits = limits(700, 1e5)}, 0));
  EXPECT_EQ(refusal.has_value(), job.ranges()[1].peak().value > 700);
  EXPECT_LT(job.ranges()[1].min.value, 0);
}

}  // namespace
}  // namespace jounce::coupling_test
