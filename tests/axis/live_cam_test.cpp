#include "jounce/axis/live_cam.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/gear/line_follow.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/live.hpp"
#include "axis/tables.hpp"
#include "support/random.hpp"

namespace jounce {
namespace {

using namespace test;

CouplingSpec ramp(StartMode start = StartMode::ramp_in) {
  return {.start = start, .velocity_diff = 100, .acceleration = 2000, .jerk = 50000};
}

// PMC600 manual 6.2, example 4.3: three periods of Fig. 6.14 behind a master at 200 pulse/s.
TEST(LiveCam, PlaysExample43) {
  LiveCam cam(1, pmc600_cam());
  Follower slave{cam, steady(200)};
  ASSERT_EQ(slave.begin({}), Cause::none);
  for (int k = 1; k <= 5400; ++k) {
    const Setpoint now = slave.step();
    const double master = 200 * (k * 1e-3);
    ASSERT_EQ(now.slave[0], pmc600_cam()->jet(master)[0]) << "bit for bit the table, at " << master;
    const double at = std::fmod(master, 360);
    if (at > 75 && at < 200) {
      ASSERT_NEAR(now.slave[1], 200, 1e-9) << "notes: sync from 75 to 200";
      ASSERT_NEAR(now.slave[0], at + 25, 1e-9);
    }
  }
  EXPECT_EQ(cam.periods(), 3);
  EXPECT_EQ(cam.progress(), Progress::running);
}

TEST(LiveCam, RampsInFromWhereTheAxisStandsWithoutAStep) {
  for (const StartMode mode : {StartMode::ramp_in, StartMode::ramp_in_pos}) {
    LiveCam cam(1, pmc600_cam(), ramp(mode));
    Follower slave{cam, steady(200)};
    ASSERT_EQ(slave.begin({-17, 0, 0}), Cause::none);
    EXPECT_EQ(cam.progress(), Progress::engaging);
    Jet last{-17, 0, 0, 0};
    for (int k = 1; k <= 3600; ++k) {
      const Jet now = slave.step().slave;
      ASSERT_LE(std::abs(now[0] - last[0]), 0.8) << "678.5 of the cam, 100 of the ramp, per s";
      ASSERT_LE(std::abs(now[1] - last[1]), 9) << k;
      last = now;
    }
    EXPECT_EQ(cam.progress(), Progress::running);
    EXPECT_NEAR(last[0], pmc600_cam()->jet(720)[0], 1e-9);
  }
}

TEST(LiveCam, FollowsReversalsBackAlongTheCam) {
  LiveCam cam(1, pmc600_cam());
  const auto master = [](double t) {
    return Jet{500 * std::sin(t), 500 * std::cos(t), -500 * std::sin(t), -500 * std::cos(t)};
  };
  Follower slave{cam, master};
  ASSERT_EQ(slave.begin({}), Cause::none);
  for (int k = 1; k <= 6283; ++k) {
    const Setpoint now = slave.step();
    ASSERT_NEAR(now.slave[0], pmc600_cam()->jet(now.master)[0], 1e-9) << k;
  }
  EXPECT_EQ(cam.periods(), -1) << "as often back over an end as forth; it rests just before 0";
}

// Example 4.4: (0,0) (5000,5000) (10000,7000) at 10000 pulse/s; then the coupling ends, at speed.
TEST(LiveCam, Example44EndsAtItsVelocityAndKeepsIt) {
  const TablePtr table = test::table(Axis::master, Rule::linear, Outside::refuse,
                                     {{0, 5000, 10000}, {0, 5000, 7000}, {}, {}});
  LiveCam cam(1, table);
  Follower slave{cam, steady(10000)};
  ASSERT_EQ(slave.begin({}), Cause::none);
  EXPECT_NEAR(slave.run(250).slave[1], 10000, 1e-9);
  EXPECT_NEAR(slave.run(251).slave[1], 4000, 1e-9) << "past 5000";
  EXPECT_NEAR(slave.run(498).slave[0], 5000 + 0.4 * 4990, 1e-9);
  EXPECT_EQ(cam.progress(), Progress::running);
  const Setpoint end = slave.step();
  EXPECT_EQ(cam.progress(), Progress::done);
  EXPECT_EQ(cam.periods(), 1);
  EXPECT_NEAR(end.slave[0], 7000, 1e-9);
  EXPECT_NEAR(end.slave[1], 4000, 1e-9);
  EXPECT_NEAR(slave.run(100).slave[0], 7400, 1e-9) << "for the axis to take over at that velocity";
}

// The same through the axis, onto its last line by a quintic: it keeps its velocity in
// continuous_motion, as after CamOut.
TEST(LiveCam, ThatEndsAtSpeedLeavesTheAxisInContinuousMotion) {
  const TablePtr table = test::table(Axis::master, Rule::quintic_hermite, Outside::refuse,
                                     {{0, 5000, 10000}, {0, 1000, 3000}, {0, 0.4, 0.4}, {0, 0, 0}});
  LiveCam cam(1, table, {.start = StartMode::relative});
  Bench bench({.limits = limits(2e4, 1e5)});
  const auto step = [&](const Command& command = {}) {
    Inputs inputs;
    inputs.master = steady(10000)(static_cast<double>(++bench.tick) * 1e-3);
    return bench.axis.step(bench.tick, command, inputs);
  };
  step({.kind = Kind::enable});
  EXPECT_FALSE(step({.kind = Kind::arm, .movement = &cam}).refused);
  Tick now = step({.kind = Kind::start});
  for (int k = 0; k < 990; ++k) {
    now = step();
    ASSERT_EQ(now.state, State::synchronized_motion) << k << " " << name(now.fault);
  }
  const double at = now.position;
  for (int k = 0; k < 100; ++k) now = step();
  EXPECT_EQ(now.state, State::continuous_motion);
  EXPECT_EQ(now.fault, Cause::none);
  EXPECT_NEAR(now.velocity, 4000, 1e-9);
  EXPECT_NEAR(now.position, at + 400, 1e-6);
}

// PMC600 manual 6.3, example 6.7: LS_LineFollowAbs to (4000, 2000) at 2000, 4000, 4000.
TEST(LiveCam, PlaysExample67OfLineFollow) {
  const auto both = pmc600::line_follow({.end_master = 4000,
                                         .end_slave = 2000,
                                         .velocity = 2000,
                                         .acceleration = 4000,
                                         .deceleration = 4000});
  const TablePtr line =
      test::table(Axis::master, Rule::linear, Outside::hold, {{0, 4000}, {0, 2000}, {}, {}});
  LiveCam cam(1, line);
  const Trajectory master = with(both.master, Outside::hold);
  Follower slave{cam, [&](double t) { return master.jet(t); }};
  ASSERT_EQ(slave.begin({}), Cause::none);
  double peak = 0;
  while (cam.progress() != Progress::done && slave.tick < 4000) {
    const Setpoint now = slave.step();
    const double t = std::min(static_cast<double>(slave.tick) * 1e-3, both.slave.end());
    ASSERT_NEAR(now.slave[0], both.slave.jet(t)[0], 1e-9) << t;
    peak = std::max(peak, now.slave[1]);
  }
  EXPECT_NEAR(peak, 1000, 1e-9) << "notes: slave peak 1000";
  EXPECT_NEAR(static_cast<double>(slave.tick) * 1e-3, 2.5, 0.0015) << "notes: 2.5 s";
  EXPECT_NEAR(slave.run(10).slave[1], 0, 1e-9) << "both stop together";
}

TEST(LiveCam, RefusesWithTheReasonsOfTheCoupling) {
  const auto begun = [](const CouplingSpec& spec, double position, const Jet& master,
                        const TablePtr& table = pmc600_cam()) {
    LiveCam cam(1, table, spec);
    return cam.begin({position, 0, 0}, {0, 0, master});
  };
  const Jet at_start{0, 200, 0, 0};
  EXPECT_EQ(begun({}, 0, at_start), Cause::none);
  EXPECT_EQ(begun({}, 1, at_start), Cause::start_position) << "absolute: it would jump";
  EXPECT_EQ(begun({.start = StartMode::relative}, 1, at_start), Cause::none);
  EXPECT_EQ(begun({}, 0, {NAN, 0, 0, 0}), Cause::no_master_input);
  EXPECT_EQ(begun(ramp(StartMode::ramp_in_neg), -17, at_start), Cause::would_reverse);
  EXPECT_EQ(begun(ramp(), 1e60, at_start), Cause::no_ramp);
  const TablePtr once =
      test::table(Axis::master, Rule::linear, Outside::refuse, {{0, 100}, {0, 1}, {}, {}});
  EXPECT_EQ(begun({}, 0, {-5, 200, 0, 0}, once), Cause::master_outside_cam);
  EXPECT_THROW(LiveCam(1, constant_master(1, 1)), InputError);
  EXPECT_THROW(LiveCam(1, pmc600_cam(), {.slave_scaling = -1}), InputError);
}

TEST(LiveCam, ALostMasterBreaksItWhereItIs) {
  LiveCam cam(1, pmc600_cam());
  bool lost = false;
  Follower slave{cam, [&](double t) { return Jet{lost ? NAN : 200 * t, 200, 0, 0}; }};
  ASSERT_EQ(slave.begin({}), Cause::none);
  const Setpoint before = slave.run(500);
  lost = true;
  const Setpoint after = slave.step();
  EXPECT_EQ(cam.progress(), Progress::broken);
  EXPECT_EQ(cam.cause(), Cause::master_lost);
  EXPECT_EQ(after.slave, before.slave);
  lost = false;
  EXPECT_EQ(slave.step().slave, before.slave) << "and stays so, until it is begun again";
}

}  // namespace
}  // namespace jounce
