// SPDX-License-Identifier: Apache-2.0
#include "jounce/axis/live_cam.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "jounce/gear/line_follow.hpp"
#include "jounce/profiles/error.hpp"

#include "axis/follow/live.hpp"
#include "axis/tables.hpp"
#include "support/random.hpp"

namespace jounce::live_cam_test {
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
  const TablePtr table = test::table(Domain::master, Interpolation::linear, Extrapolation::refuse,
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

/// 0.4 of its master from 5000 to 10000, where it ends.
TablePtr open_ended() {
  return test::table(Domain::master, Interpolation::quintic_hermite, Extrapolation::refuse,
                     {{0, 5000, 10000}, {0, 1000, 3000}, {0, 0.4, 0.4}, {0, 0, 0}});
}

/// An axis with a live master.
struct Coupled : Bench {
  explicit Coupled(const AxisConfig& config, std::function<Jet(double)> of)
      : Bench(config), master(std::move(of)) {
    step({command::Enable{}});
  }
  Tick step(const Command& command = {}) {
    Inputs inputs;
    inputs.master = master(static_cast<double>(++tick) * 1e-3);
    return axis.step(tick, command, inputs);
  }
  Tick run(int ticks) {
    Tick last;
    for (int i = 0; i < ticks; ++i) last = step();
    return last;
  }
  /// Arms and starts the movement with the command.
  Tick begin(Movement& movement, const command::Start& start = {}) {
    EXPECT_FALSE(step({command::Arm{.movement = &movement}}).refused);
    return step({start});
  }

  std::function<Jet(double)> master;
};

// The share of the move came from the acceleration of one instant: the axis faulted at a later one.
TEST(LiveCam, LeavesASuperimposedMoveWhatItsWholePeriodDoesNotUse) {
  const TablePtr table = pmc600_cam();
  double k1 = 0;
  double k2 = 0;
  for (int i = 0; i <= 36'000; ++i) {
    const Jet f = table->jet(i * 0.01);
    k1 = std::max(k1, std::abs(f[1]));
    k2 = std::max(k2, std::abs(f[2]));
  }
  const AxisConfig config{.limits = limits(1.25 * 200 * k1, 1.05 * 200 * 200 * k2)};
  for (int wait = 0; wait < 1800; wait += 50) {
    LiveCam cam(1, table);
    Coupled bench(config, steady(200));
    bench.master = [](double t) { return steady(200)(t - 3e-3); };
    bench.begin(cam);
    bench.run(1800 + wait);
    const Tick begun = bench.step({command::MoveSuperimposed{.distance = 10}});
    EXPECT_EQ(refusal(begun), Cause::none) << wait;
    for (int i = 0; i < 3600; ++i) {
      const Tick now = bench.step();
      ASSERT_EQ(now.fault, Cause::none) << wait << ", " << i << " ticks later";
      ASSERT_LE(std::abs(now.velocity), *config.limits.velocity);
      ASSERT_LE(std::abs(now.acceleration), *config.limits.acceleration);
      if (i < 3599) continue;
      EXPECT_NEAR(now.position, table->jet(now.master)[0] + 10, 1e-8) << wait;
    }
  }
}

// The same through the axis, onto its last line by a quintic: where that was asked for it keeps its
// velocity in continuous_motion, as after CamOut.
TEST(LiveCam, ThatEndsAtSpeedLeavesTheAxisInContinuousMotion) {
  LiveCam cam(1, open_ended(), {.start = StartMode::relative}, CamEnd::keep_velocity);
  Coupled bench({.limits = limits(2e4, 1e5)}, steady(10000));
  const auto step = [&] { return bench.step(); };
  Tick now = bench.begin(cam);
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

// By default it brakes: never faster than its limits allow, to rest, without a fault.
TEST(LiveCam, ThatEndsAtSpeedBrakesWithinTheLimits) {
  LiveCam cam(1, open_ended(), {.start = StartMode::relative});
  Coupled bench({.limits = limits(2e4, 1e5)}, steady(10000));
  Tick before = bench.begin(cam);
  double end = 0;
  for (int k = 0; k < 1200; ++k) {
    const Tick now = bench.step();
    if (now.state == State::discrete_motion && end == 0) end = before.position;
    ASSERT_LE(std::abs(now.velocity - before.velocity), 100 * (1 + 1e-9)) << k;
    before = now;
  }
  EXPECT_EQ(before.state, State::standstill);
  EXPECT_EQ(before.fault, Cause::none);
  EXPECT_EQ(before.reason, Cause::end_velocity);
  EXPECT_NEAR(before.position, 3000 + 4000.0 * 4000 / 2 / 1e5, 5) << "v^2 / 2a beyond the end";
}

// An extended one stays coupled at its last ratio, stops with its master, and comes back into the cam.
TEST(LiveCam, ExtendedItStaysCoupledBeyondItsEnds) {
  const auto there_and_back = [](double t) {  // to 15915 and back through 0
    return Jet{15915 * std::sin(t), 15915 * std::cos(t), -15915 * std::sin(t),
               -15915 * std::cos(t)};
  };
  const TablePtr table = open_ended();
  LiveCam cam(1, table, {}, CamEnd::extend);
  Follower slave{cam, there_and_back};
  ASSERT_EQ(slave.begin({}), Cause::none);
  for (int k = 1; k <= 4000; ++k) {
    const Setpoint now = slave.step();
    const double m = now.master;
    const double exact = m > 10000 ? 3000 + 0.4 * (m - 10000) : m < 0 ? 0 : table->jet(m)[0];
    ASSERT_NEAR(now.slave[0], exact, 1e-7) << m;
    ASSERT_EQ(cam.progress(), Progress::running) << m;
    if (m > 10000) {
      ASSERT_NEAR(now.slave[1], 0.4 * now.master_velocity, 1e-9) << m;
    }
  }
}

// Judged where the master will be: a slave that stands on the cam there waits, and begins without a step.
TEST(LiveCam, AtAMasterPositionItIsJudgedThere) {
  const TablePtr cam_table = pmc600_cam();
  const double there = cam_table->jet(100)[0];
  LiveCam cam(1, cam_table);
  Coupled bench({.limits = limits(3000, 2e5), .position = there}, steady(200));
  Tick now = bench.begin(cam, {.when = StartAt::master_position, .position = 460});
  EXPECT_FALSE(now.refused) << now.refused->text();
  EXPECT_TRUE(now.waiting);
  while (now.master < 459 && bench.tick < 2298) now = bench.step();
  EXPECT_EQ(now.position, there);
  for (int k = 0; k < 1000; ++k) {
    now = bench.step();
    const double m = 200 * (static_cast<double>(bench.tick) * 1e-3);
    ASSERT_EQ(now.fault, Cause::none);
    if (m > 460) {
      ASSERT_NEAR(now.position, cam_table->jet(m)[0], 1e-9) << m;
      ASSERT_EQ(now.state, State::synchronized_motion);
    }
  }
}

TEST(LiveCam, AtAMasterPositionWhereItCannotBeginItIsDroppedThere) {
  LiveCam cam(1, pmc600_cam());
  LiveCam wrong_way(2, pmc600_cam(), ramp(StartMode::ramp_in_neg));
  for (LiveCam* each : {&cam, &wrong_way}) {
    Coupled bench({.limits = limits(3000, 2e5), .position = -17}, steady(200));
    Tick now = bench.begin(*each, {.when = StartAt::master_position, .position = 40});
    ASSERT_FALSE(now.refused);
    std::optional<Refusal> dropped;
    while (bench.tick < 250) {
      now = bench.step();
      if (now.dropped) dropped = now.dropped;
      ASSERT_EQ(now.position, -17);
    }
    ASSERT_TRUE(dropped);
    EXPECT_EQ(dropped->cause, each == &cam ? Cause::start_position : Cause::would_reverse);
    EXPECT_FALSE(now.waiting);
    if (each != &cam) continue;
    EXPECT_NEAR(dropped->value, pmc600_cam()->jet(40)[0], 1e-9) << "where the cam is";
    EXPECT_EQ(dropped->limit, -17) << "where the axis is";
  }
}

// A cam that has no ramp begins at the velocity that its master requires. An axis that cannot jump to
// it stays at rest, without a fault, wherever the start was due.
TEST(LiveCam, AStartThatWouldJumpIsNoFault) {
  const TablePtr table = pmc600_cam();  // the slave moves as fast as its master at 100
  for (const bool waits : {false, true}) {
    LiveCam cam(1, table);
    const auto master = [](double t) { return Jet{100 + 200 * (t - 2e-3), 200, 0, 0}; };
    Coupled bench({.limits = limits(3000, 2e4), .position = table->jet(waits ? 150 : 100)[0]},
                  master);
    std::optional<Refusal> no =
        waits ? bench.begin(cam, {.when = StartAt::master_position, .position = 150}).refused
              : bench.begin(cam).refused;
    const double from = bench.step().position;
    for (int k = 0; waits && k < 400; ++k) {
      const Tick now = bench.step();
      if (now.dropped) no = now.dropped;
      if (now.dropped) {
        EXPECT_EQ(now.reason, Cause::start_jump) << "the monitor shows it";
      }
    }
    ASSERT_TRUE(no);
    EXPECT_EQ(no->cause, Cause::start_jump) << no->text();
    EXPECT_NEAR(no->value, 200, 1);
    EXPECT_EQ(no->limit, 0);
    const Tick now = bench.step();
    EXPECT_EQ(now.fault, Cause::none);
    EXPECT_EQ(now.state, State::standstill);
    EXPECT_EQ(now.position, from);
  }
}

TEST(LiveCam, ANextCutNeedsACamInProgress) {
  LiveCam cam(1, pmc600_cam(), {.master_absolute = false});
  for (const double velocity : {0.0, 900.0}) {
    Coupled bench({.limits = limits(3000, 2e4)}, steady(velocity));
    const Tick now = bench.begin(cam, {.when = StartAt::end_of_table});
    EXPECT_EQ(test::refusal(now), Cause::no_movement) << velocity;
    EXPECT_EQ(bench.run(10).fault, Cause::none);
  }
}

// A cam that does not continue at the velocity of the one before it is dropped: the first goes on.
TEST(LiveCam, ATakeoverThatWouldJumpIsDropped) {
  const TablePtr even = test::table(Domain::master, Interpolation::linear, Extrapolation::advance,
                                    {{0, 100}, {0, 100}, {}, {}});
  LiveCam first(1, even, {.start = StartMode::relative});
  LiveCam second(2, pmc600_cam(), {.master_absolute = false, .start = StartMode::relative});
  Coupled bench({.limits = limits(3000, 2e4)}, [](double t) {
    return t < 0.1 ? Jet{500 * t * t * 10, 1e4 * t, 1e4, 0}
                   : Jet{50 + 1000 * (t - 0.1), 1000, 0, 0};
  });
  bench.begin(first);
  bench.run(150);
  ASSERT_FALSE(bench.begin(second, {.when = StartAt::end_of_table}).refused);
  std::optional<Refusal> dropped;
  Tick now;
  for (int k = 0; k < 300; ++k) {
    now = bench.step();
    if (now.dropped) dropped = now.dropped;
    ASSERT_EQ(now.fault, Cause::none) << name(now.fault) << k;
  }
  ASSERT_TRUE(dropped);
  EXPECT_EQ(dropped->cause, Cause::start_jump);
  EXPECT_EQ(now.job, 1U);
  EXPECT_NEAR(now.velocity, 1000, 1e-9);
}

// The witness is the same cam on an axis with wide limits: its greatest speed and acceleration in a period.
TEST(LiveCam, ACamThatRepeatsIsRejectedIfItCannotKeepUpWithItsMaster) {
  constexpr double v = 300;
  const auto begun = [](const Limits& within, const std::function<Jet(double)>& master) {
    LiveCam cam(1, pmc600_cam(), ramp());
    Coupled bench({.limits = within}, master);
    return test::refusal(bench.begin(cam));
  };
  LiveCam cam(1, pmc600_cam(), ramp());
  Coupled bench({.limits = limits(1e5, 1e7)}, steady(v));
  ASSERT_EQ(test::refusal(bench.begin(cam)), Cause::none);
  bench.run(2000);  // the ramp has ended
  double fastest = 0, strongest = 0;
  for (int k = 0; k < 1200; ++k) {
    const Tick now = bench.step();
    fastest = std::max(fastest, std::abs(now.velocity));
    strongest = std::max(strongest, std::abs(now.acceleration));
  }
  EXPECT_EQ(begun(limits(1.01 * fastest, 1e7), steady(v)), Cause::none);
  EXPECT_EQ(begun(limits(0.99 * fastest, 1e7), steady(v)), Cause::velocity_limit);
  EXPECT_EQ(begun(limits(1e5, 1.01 * strongest), steady(v)), Cause::none);
  EXPECT_EQ(begun(limits(1e5, 0.99 * strongest), steady(v)), Cause::acceleration_limit);
  const auto slows = [](double t) { return Jet{v * t - 20 * t * t, v - 40 * t, -40, 0}; };
  EXPECT_EQ(begun(limits(1e5, 0.99 * strongest), slows), Cause::none) << "it may be slow in time";
}

// At 4000 u/s^2, the axis must brake before its limit: the number is the velocity that it would reach.
TEST(LiveCam, AnOverspeedHasTheVelocityThatExceedsTheLimit) {
  const TablePtr even = test::table(Domain::master, Interpolation::linear, Extrapolation::advance,
                                    {{0, 100}, {0, 100}, {}, {}});
  LiveCam cam(1, even);
  Coupled bench({.limits = limits(400, 5000, 1e5)}, [](double time) {
    const double t = std::max(time - 0.01, 0.0);
    return Jet{2000 * t * t, 4000 * t, t > 0 ? 4000.0 : 0.0, 0};
  });
  ASSERT_EQ(test::refusal(bench.begin(cam)), Cause::none);
  Tick now = bench.step();
  for (int k = 0; k < 200 && now.fault == Cause::none; ++k) now = bench.step();
  ASSERT_EQ(now.fault, Cause::overspeed);
  EXPECT_GT(now.fault_value, 400);
  EXPECT_LT(now.fault_value, 400 + 4000 * 2e-3) << "within two ticks";
  EXPECT_LT(now.velocity, 400);
}

// The limit of a follower: `acceleration` while its speed rises. It may brake with its leader, up to
// stop_acceleration.
TEST(LiveCam, AFollowerKeepsItsAccelerationWhileItSpeedsUp) {
  const TablePtr even = test::table(Domain::master, Interpolation::linear, Extrapolation::advance,
                                    {{0, 100}, {0, 100}, {}, {}});
  for (const double a : {9990.0, 10800.0}) {
    LiveCam cam(1, even);
    Coupled bench({.limits = limits(3000, 1e4)}, [&](double time) {  // 0.1 s up, then down to rest
      const double v = a * 0.1;
      const double t = time - 0.01;
      if (t < 0) return Jet{};
      if (t < 0.1) return Jet{a * t * t / 2, a * t, a, 0};
      const double u = std::min(t - 0.1, 0.05);
      return Jet{a * 0.005 + u * (v - a * u), v - 2 * a * u, u < 0.05 ? -2 * a : 0, 0};
    });
    bench.begin(cam);
    const Tick now = bench.run(200);
    EXPECT_EQ(now.fault, a > 1e4 ? Cause::overacceleration : Cause::none) << name(now.fault);
    if (a > 1e4) {
      EXPECT_NEAR(now.fault_value, a, 1e-6);
    } else {
      EXPECT_NEAR(now.position, a * 0.0075, 1e-9) << "at rest with its leader";
    }
  }
}

/// A knife's cam: a turn for each cut of this length, its speed at the cut that of the web.
TablePtr knife(double cut) {
  const double surface = 360.0 / 314;  // deg/mm
  return test::table(Domain::master, Interpolation::quintic_hermite, Extrapolation::advance,
                     {{0, cut}, {0, 360}, {surface, surface}, {0, 0}});
}

// Another cut length from the next cut on, wherever that is: cuts at 250, 500, 750, then 1050, 1350.
TEST(LiveCam, TakesOverWhereAPassOfTheOneBeforeEnds) {
  LiveCam first(1, knife(250), {.slave_period = 360});
  const CouplingSpec at_cut{.master_absolute = false, .slave_period = 360};
  LiveCam second(2, knife(300), at_cut);
  Coupled bench({.limits = limits(1e4, 1e6)}, steady(1000));
  Tick now = bench.begin(first, {.when = StartAt::master_position, .position = 250});
  now = bench.run(600);  // master 0.6 m: between the cuts at 500 and 750
  now = bench.begin(second, {.when = StartAt::end_of_table});
  ASSERT_FALSE(now.refused) << now.refused->text();
  double v = now.velocity;
  for (int k = 0; k < 1500; ++k) {
    now = bench.step();
    const double m = static_cast<double>(bench.tick);
    const double exact = m < 750 ? knife(250)->jet(m - 250)[0] : 720 + knife(300)->jet(m - 750)[0];
    ASSERT_NEAR(now.position, exact, 1e-7) << m;
    ASSERT_LE(std::abs(now.velocity - v), 60) << m;
    ASSERT_EQ(now.fault, Cause::none) << m;
    ASSERT_EQ(now.job, m < 750 ? 1U : 2U) << m;
    v = now.velocity;
  }
}

// PMC600 manual 6.3, example 6.7: LS_LineFollowAbs to (4000, 2000) at 2000, 4000, 4000.
TEST(LiveCam, PlaysExample67OfLineFollow) {
  const auto both = pmc600::line_follow({.end_master = 4000,
                                         .end_slave = 2000,
                                         .velocity = 2000,
                                         .acceleration = 4000,
                                         .deceleration = 4000});
  const TablePtr line = test::table(Domain::master, Interpolation::linear, Extrapolation::hold,
                                    {{0, 4000}, {0, 2000}, {}, {}});
  LiveCam cam(1, line);
  const Trajectory master = with(both.master, Extrapolation::hold);
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

TEST(LiveCam, RejectsWithTheReasonsOfTheCoupling) {
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
  const TablePtr once = test::table(Domain::master, Interpolation::linear, Extrapolation::refuse,
                                    {{0, 100}, {0, 1}, {}, {}});
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
}  // namespace jounce::live_cam_test
