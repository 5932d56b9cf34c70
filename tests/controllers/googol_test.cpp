// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/googol/googol.hpp"

#include <array>

#include "jounce/profiles/curve/roots.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/moves/move.hpp"
#include "jounce/profiles/moves/s_curve.hpp"
#include "jounce/profiles/sequences/splice.hpp"

#include "controllers/motion.hpp"
#include "support/errors.hpp"
#include "support/random.hpp"

namespace jounce::googol {
namespace {

using test::Random;

TEST(GoogolTrap, Example71TakesThirteenHundredMillisecondsAndSmoothedTwentyFiveMore) {
  Trap move{.pos = 50000, .vel = 50, .acc = 0.25, .dec = 0.125};
  EXPECT_DOUBLE_EQ(trap(move).duration(), 1300);
  move.smooth_time = 25;
  const Profile smooth = trap(move);
  EXPECT_DOUBLE_EQ(smooth.duration(), 1325);
  EXPECT_DOUBLE_EQ(smooth.at(225).position, 5625);
  EXPECT_DOUBLE_EQ(smooth.at(900).position, 50000 - 10625);
  EXPECT_EQ(smooth.end().position, 50000);
}

TEST(GoogolTrap, Example112TakesFifteenMillisecondsOfRamps) {
  EXPECT_DOUBLE_EQ(trap({.pos = 10000, .vel = 10, .acc = 1, .dec = 0.5}).duration(), 1015);
  EXPECT_DOUBLE_EQ(trap({.pos = 20000, .vel = 10, .acc = 1, .dec = 0.5}).duration(), 2015);
}

TEST(GoogolTrap, Example91CrossesTheSoftLimitAtSixHundredMilliseconds) {
  Trap move{.pos = 1000000, .vel = 50, .acc = 0.125, .dec = 0.125};
  EXPECT_NEAR(crossings(trap(move).curve(), 0, 20000).at(0), 600, 1e-9);
  move.smooth_time = 25;
  EXPECT_NEAR(crossings(trap(move).curve(), 0, 20000).at(0), 612.5, 1e-9);
}

TEST(GoogolTrap, AStartSpeedShortensTheFirstRamp) {
  // 10 -> 50 at 0.25 is 160 ms and 4800 pulses; braking is 400 ms and 10000.
  Trap move{.pos = 50000, .vel = 50, .acc = 0.25, .dec = 0.125, .vel_start = 10};
  const Profile p = trap(move);
  EXPECT_DOUBLE_EQ(p.duration(), 160 + (50000 - 4800 - 10000) / 50.0 + 400);
  EXPECT_EQ(p.at(0).velocity, 10);
  move.smooth_time = 25;  // 185 ms and 5550; 425 ms and 10625
  const Profile smooth = trap(move);
  EXPECT_DOUBLE_EQ(smooth.duration(), 185 + (50000 - 5550 - 10625) / 50.0 + 425);
  EXPECT_EQ(smooth.at(0).acceleration, 0);
  test::expect_arrives(smooth);
}

TEST(GoogolTrap, RejectsAsTheManual) {
  const Trap good{.pos = 1000, .vel = 50, .acc = 0.25};
  const auto refused = [&](auto change) {
    Trap bad = good;
    change(bad);
    EXPECT_THROW(trap(bad), InputError);
  };
  EXPECT_NO_THROW(trap(good));
  refused([](Trap& m) { m.pos = max_position + 1; });
  refused([](Trap& m) { m.pos = -max_position - 1; });
  refused([](Trap& m) { m.pos = 0; });
  refused([](Trap& m) { m.acc = 0; });
  refused([](Trap& m) { m.dec = -1; });
  refused([](Trap& m) { m.smooth_time = 51; });
  refused([](Trap& m) { m.smooth_time = -1; });
  refused([](Trap& m) { m.vel_start = -1; });
  refused([](Trap& m) { m.vel_start = 51; });
  Trap edge = good;
  edge.pos = -max_position;
  EXPECT_EQ(trap(edge).end().position, -1073741823.0);
}

TEST(GoogolPercent, IsTheShareOfRampsInAPhase) {
  // Example 7-10: percent 50, so that ta is half of te.
  const Profile p = move_absolute({.pos = 100000, .vel = 50, .acc = 1, .dec = 10, .percent = 50});
  ASSERT_EQ(p.phases(), 7U);
  for (const std::size_t first : {0U, 4U}) {
    EXPECT_DOUBLE_EQ(p.phase(first).duration, p.phase(first + 1).duration / 2);
    EXPECT_DOUBLE_EQ(p.phase(first + 2).duration, p.phase(first + 1).duration / 2);
  }
  // T = dv / (acc (1 - percent/200))
  EXPECT_DOUBLE_EQ(p.phase(0).duration + p.phase(1).duration + p.phase(2).duration, 50 / 0.75);
  EXPECT_DOUBLE_EQ(p.at(p.phase(0).duration).acceleration, 1);
  test::expect_within(p.curve(), 50, 10);
}

TEST(GoogolPercent, NoneIsATrapezoidAndAllLeavesNoConstantPart) {
  MoveAbsolute move{.pos = 50000, .vel = 50, .acc = 0.25, .dec = 0.125};
  EXPECT_DOUBLE_EQ(move_absolute(move).duration(), 1300);
  EXPECT_EQ(move_absolute(move).order(), 2);
  move.percent = 100;  // each ramp twice as long
  const Profile p = move_absolute(move);
  EXPECT_EQ(p.phases(), 5U);
  EXPECT_DOUBLE_EQ(p.duration(), 400 + (50000 - 10000 - 20000) / 50.0 + 800);
}

TEST(GoogolMoveAbsolute, HoldsItsPeaksAndArrivesWhateverTheShape) {
  Random random(31);
  for (int i = 0; i < 2000 && !::testing::Test::HasFailure(); ++i) {
    const MoveAbsoluteEx m{.from = random.uniform(-1e6, 1e6),
                           .pos = static_cast<std::int64_t>(random.uniform(-1e8, 1e8)),
                           .vel = random.log_uniform(1e-2, 1e3),
                           .acc = random.log_uniform(1e-3, 1e2),
                           .dec = random.log_uniform(1e-3, 1e2),
                           .percent = random.below(101),
                           .acc_start_percent = random.below(101),
                           .dec_end_percent = random.below(101)};
    SCOPED_TRACE(::testing::Message()
                 << i << ": " << number(m.from) << " to " << m.pos << " vel " << number(m.vel)
                 << " acc " << number(m.acc) << " dec " << number(m.dec) << " percent " << m.percent
                 << ", " << m.acc_start_percent << ", " << m.dec_end_percent);
    const Profile p = move_absolute_ex(m);
    test::expect_arrives(p);
    EXPECT_EQ(p.at(p.duration()).position, static_cast<double>(m.pos));
    const Trajectory f = p.curve();
    const double sign = f.at(f.end()).position > m.from ? 1 : -1;
    const Ranges r = extrema(f);
    EXPECT_LE(std::abs(r[1].peak().value), m.vel * (1 + 1e-12));
    EXPECT_LE((sign > 0 ? r[2].max : r[2].min).value * sign, m.acc * (1 + 1e-12));
    EXPECT_LE(-(sign > 0 ? r[2].min : r[2].max).value * sign, m.dec * (1 + 1e-12));
    test::expect_invariants(with(f, Extrapolation::refuse), p.order() == 3 ? 2 : 1);
  }
}

TEST(GoogolMoveAbsolute, LastsAsATrapezoidOfTheMeanAcceleration) {
  Random random(32);
  for (int i = 0; i < 1000; ++i) {
    const MoveAbsolute m{.pos = 1 + random.below(1'000'000),
                         .vel = random.log_uniform(1e-1, 1e3),
                         .acc = random.log_uniform(1e-3, 1e2),
                         .dec = random.log_uniform(1e-3, 1e2),
                         .percent = random.below(101)};
    const double mean = 1 - m.percent / 200.0;
    const double expected =
        trapezoid({0, static_cast<double>(m.pos), m.vel, m.acc * mean, m.dec * mean}).duration();
    EXPECT_NEAR(move_absolute(m).duration(), expected, 1e-14 * expected) << i;
  }
}

TEST(GoogolTrap, WithAStartSpeedIsAsFastAsTheSolver) {
  Random random(33);
  for (int i = 0; i < 1000; ++i) {
    Trap m{.pos = 1 + random.below(100'000), .vel = random.log_uniform(1, 100)};
    m.acc = random.log_uniform(1e-2, 10);
    m.smooth_time = 1 + random.below(50);
    m.vel_start = random.uniform(0, 0.9) * m.vel;
    const auto h = static_cast<double>(m.pos);
    // The distance of a stop.
    if (m.vel_start * (m.vel_start / m.acc + m.smooth_time) > h) continue;
    const MoveResult fastest =
        move_to({0, m.vel_start, 0}, {h, 0, 0}, within(m.vel, m.acc, m.acc / m.smooth_time));
    ASSERT_TRUE(fastest);
    EXPECT_NEAR(trap(m).duration(), fastest.profile.duration(), 1e-10 * fastest.profile.duration())
        << i;
  }
}

TEST(GoogolTrap, TakesANewTargetAndVelocityWhileMoving) {
  Trap m{.pos = 50000, .vel = 50, .acc = 0.25, .dec = 0.125, .smooth_time = 25};
  const Trajectory f = trap(m).curve();
  m.pos = 80000;
  m.vel = 60;
  const Trajectory longer = trap(f, 500, m);
  EXPECT_DOUBLE_EQ(longer.at(longer.end()).position, 80000);
  EXPECT_DOUBLE_EQ(extrema(longer, 1).max.value, 60);
  test::expect_invariants(longer, 2);
  m.pos = 10000;  // passed: at 500 ms the axis is at 19375
  const Trajectory back = trap(f, 500, m);
  EXPECT_NEAR(back.at(back.end()).position, 10000, 1e-10);
  EXPECT_GT(extrema(back, 0).max.value, 19375);
  test::expect_invariants(back, 2);
}

TEST(GoogolTrap, GivenAgainIsTheSameMove) {
  const Trap example{.pos = 50000, .vel = 50, .acc = 0.25, .dec = 0.125, .smooth_time = 25};
  const Trajectory f = trap(example).curve();
  for (const double t : {10.0, 100.0, 210.0, 500.0, 1000.0, 1310.0})
    EXPECT_NEAR(trap(f, t, example).end(), 1325, 1e-3) << t;
}

TEST(GoogolMoveAbsolute, ContinuesFromAnyMotion) {
  const MoveAbsolute m{.pos = 50000, .vel = 50, .acc = 0.25, .dec = 0.125, .percent = 60};
  const Trajectory f = move_absolute(m).curve();
  MoveAbsolute next = m;
  next.pos = -3000;
  for (const double t : {20.0, 150.0, 700.0, f.end() - 100, f.end() + 50}) {
    const Trajectory g = move_absolute(f, t, next);
    EXPECT_NEAR(g.at(g.end()).position, -3000, 1e-10) << t;
    test::expect_invariants(g, 2);
    test::expect_within(g, 50, 0.25);
  }
  const Trajectory jogged =
      move_velocity(f, 700, {.vel = 20, .acc = 1, .jerk_begin = 0.1, .jerk_end = 0.2});
  EXPECT_DOUBLE_EQ(state_at(jogged, 2000).velocity, 20);
  test::expect_invariants(with(jogged, Extrapolation::refuse), 2);
}

TEST(GoogolMoveAbsoluteEx, BeginsAndEndsAsAsked) {
  // From 10 to 50 with 50 % of ramps beginning at half of acc 1: dv = T (1 - 1/4 + 1/16).
  const Profile p = move_absolute_ex({.pos = 100000,
                                      .vel = 50,
                                      .acc = 1,
                                      .dec = 2,
                                      .percent = 50,
                                      .vel_start = 10,
                                      .vel_end = 20,
                                      .acc_start_percent = 50,
                                      .dec_end_percent = 25});
  const double up = p.phase(0).duration + p.phase(1).duration + p.phase(2).duration;
  const double down = p.phase(4).duration + p.phase(5).duration + p.phase(6).duration;
  EXPECT_DOUBLE_EQ(up, 40 / 0.8125);
  EXPECT_DOUBLE_EQ(down, 30 / (2 * (0.75 + 0.5 * 0.25 / 4)));
  EXPECT_DOUBLE_EQ(p.phase(0).duration, up / 4);
  EXPECT_EQ(p.at(0).velocity, 10);
  EXPECT_EQ(p.at(0).acceleration, 0.5);
  EXPECT_EQ(p.end(), (MotionState{100000, 20, -0.5}));
  test::expect_arrives(p);
}

TEST(GoogolMoveAbsoluteEx, RejectsADistanceTooShortForItsEndSpeed) {
  MoveAbsoluteEx m{.pos = 1250, .vel = 50, .acc = 1, .vel_end = 50};
  EXPECT_EQ(move_absolute_ex(m).duration(), 50);  // 50^2 / 2 is just enough
  m.pos = 1249;
  EXPECT_THROW(move_absolute_ex(m), InputError);
  m.pos = 1250;
  m.percent = 50;
  EXPECT_THROW(move_absolute_ex(m), InputError);
  m.vel_end = 51;
  EXPECT_THROW(move_absolute_ex(m), InputError);
  m = {.pos = 1000, .vel = 50, .acc = 1, .acc_start_percent = 101};
  EXPECT_THROW(move_absolute_ex(m), InputError);
}

TEST(GoogolJog, Example72SlowsDownAfterTheCrossing) {
  const Jog parameters{.acc = 0.0625, .dec = 0.0625};
  const std::array start{JogVelocity{0, 100}};
  const Trajectory up = jog(0, start, parameters);
  EXPECT_DOUBLE_EQ(up.end(), 1600);
  EXPECT_DOUBLE_EQ(state_at(up, 1600).position, 80000);
  const double t = crossings(until(up, 3000), 0, 100000).at(0);
  EXPECT_NEAR(t, 1800, 1e-9);
  const std::array both{JogVelocity{0, 100}, JogVelocity{1800, 50}};
  const Trajectory f = jog(0, both, parameters);
  EXPECT_DOUBLE_EQ(f.end(), 2600);
  EXPECT_DOUBLE_EQ(state_at(f, 2600).position, 160000);
  EXPECT_DOUBLE_EQ(state_at(f, 2600).velocity, 50);
}

/// Key and text of the error; empty if there is none.
template <class Call>
std::string refused_key(Call call) {
  return test::key_of([&] { call(); });
}

TEST(GoogolJog, RejectsTimesThatDoNotAscendAndAStandingStart) {
  const Jog parameters{.acc = 0.0625};
  const auto key = [&](std::initializer_list<JogVelocity> velocities) {
    return refused_key([&] { jog(0, std::span(velocities), parameters); });
  };
  EXPECT_EQ(key({{0, 100}, {500, 50}, {400, 80}}), "velocities[3].time");
  EXPECT_EQ(key({{0, 100}, {0, 50}}), "velocities[2].time");
  EXPECT_EQ(key({{std::nan(""), 100}}), "velocities[1].time");
  EXPECT_EQ(key({{0, 0}, {500, 50}}), "velocities[1].vel");
  EXPECT_EQ(key({{0, 100}, {400, 0}}), "");
}

TEST(GoogolTrap, RejectsEveryPositionOutOfRange) {
  constexpr auto least = std::numeric_limits<std::int64_t>::min();
  for (const std::int64_t pos : {least, -max_position - 1, max_position + 1}) {
    EXPECT_EQ(refused_key([&] { trap({.pos = pos, .vel = 50, .acc = 1}); }), "pos");
    EXPECT_EQ(refused_key([&] { move_absolute({.pos = pos, .vel = 50, .acc = 1}); }), "pos");
  }
}

TEST(GoogolJog, SmoothIsAShareOfEveryRamp) {
  const Jog parameters{.acc = 0.0625, .dec = 0.125, .smooth = 0.5};
  const Profile up = jog({}, 100, parameters);
  ASSERT_EQ(up.phases(), 3U);
  EXPECT_DOUBLE_EQ(up.duration(), 100 / (0.0625 * 0.75));
  EXPECT_DOUBLE_EQ(2 * up.phase(0).duration / up.duration(), 0.5);
  const Profile back = jog(up.end(), -50, parameters);  // through rest: both ramps have the share
  ASSERT_EQ(back.phases(), 6U);
  EXPECT_DOUBLE_EQ(back.duration(), 100 / (0.125 * 0.75) + 50 / (0.0625 * 0.75));
  EXPECT_DOUBLE_EQ(2 * back.phase(3).duration, 0.5 * 50 / (0.0625 * 0.75));
  EXPECT_EQ(back.end().velocity, -50);
  test::expect_arrives(back);
  EXPECT_THROW(jog({}, 100, {.acc = 1, .smooth = 1}), InputError);
  EXPECT_THROW(jog({}, 100, {.acc = 1, .smooth = -0.1}), InputError);
}

TEST(GoogolJog, ALittleChangeInMidRampIsNoJolt) {
  const Jog parameters{.acc = 0.25, .smooth = 0.5};
  const Profile up = jog({}, 100, parameters);
  const MotionState now = state_at(up.curve(), up.duration() / 2);
  ASSERT_DOUBLE_EQ(now.acceleration, 0.25);
  const double planned = std::abs(up.phase(0).value);
  const Profile p = jog(now, now.velocity * (1 + 1e-6), parameters);
  for (std::size_t i = 0; i < p.phases(); ++i)
    EXPECT_LE(std::abs(p.phase(i).value), 2.01 * planned);  // that of a ramp from rest to 50
}

TEST(GoogolJog, ChangedInMidRampKeepsTheAccelerationContinuous) {
  const std::array velocities{JogVelocity{5, 100}, JogVelocity{300, 60}, JogVelocity{500, -80},
                              JogVelocity{4000, 0}};
  const Trajectory f = jog(1000, velocities, {.acc = 0.25, .dec = 0.125, .smooth = 0.4});
  EXPECT_EQ(f.start(), 5);
  EXPECT_NEAR(state_at(f, f.end()).velocity, 0, 1e-12);
  test::expect_invariants(f, 2);
}

TEST(GoogolMoveVelocity, BuildsUpAndFallsWithItsOwnJerks) {
  const MoveVelocity m{.vel = 50, .acc = 1, .jerk_begin = 0.1, .jerk_end = 0.05};
  const Profile p = move_velocity({}, m);
  ASSERT_EQ(p.phases(), 3U);
  EXPECT_DOUBLE_EQ(p.phase(0).duration, 10);  // 5 pulse/ms
  EXPECT_DOUBLE_EQ(p.phase(2).duration, 20);  // 10
  EXPECT_DOUBLE_EQ(p.phase(1).duration, 35);
  EXPECT_DOUBLE_EQ(p.at(10).acceleration, 1);
  EXPECT_EQ(p.end().velocity, 50);
  test::expect_arrives(p);
}

TEST(GoogolMoveVelocity, ShortRampsPeakWhereBothJerksMeet) {
  const Profile p = move_velocity({}, {.vel = 6, .acc = 10, .jerk_begin = 1, .jerk_end = 0.5});
  ASSERT_EQ(p.phases(), 2U);  // A^2 (1/2 + 1) = 6
  EXPECT_DOUBLE_EQ(p.phase(0).duration, 2);
  EXPECT_DOUBLE_EQ(p.phase(1).duration, 4);
}

TEST(GoogolMoveVelocity, HasTwoDirections) {
  MoveVelocity m{.vel = 5, .acc = 1, .jerk_begin = 1, .jerk_end = 1};
  EXPECT_EQ(move_velocity({}, m).end().velocity, 5);
  m.direction = Direction::negative;
  EXPECT_EQ(move_velocity({}, m).end().velocity, -5);
  m.vel = -5;
  EXPECT_EQ(move_velocity({}, m).end().velocity, 5);
  m.vel = 5;
  m.direction = Direction::current;
  EXPECT_EQ(move_velocity({.velocity = -2}, m).end().velocity, -5);
  EXPECT_EQ(move_velocity({.velocity = 2}, m).end().velocity, 5);
  EXPECT_EQ(move_velocity({}, m).end().velocity, 5);
  m.jerk_end = 0;
  EXPECT_THROW(move_velocity({}, m), InputError);
}

}  // namespace
}  // namespace jounce::googol
