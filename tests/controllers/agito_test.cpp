// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/agito/agito.hpp"

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/sequences/splice.hpp"

#include "controllers/motion.hpp"

namespace jounce::agito {
namespace {

const Settings manual_4_1{.accel = 100000, .decel = 100000, .speed = 1000};

TEST(AgitoBegin, TakesTheManualsTimes) {
  EXPECT_DOUBLE_EQ(begin(0, {.abs_trgt = 2000}, manual_4_1).duration(), 2.01);
  EXPECT_DOUBLE_EQ(begin(2000, {.rel_trgt = 3000}, manual_4_1).duration(), 3.01);
  const Settings manual_4_8{.accel = 50000, .decel = 50000, .speed = 5000};
  EXPECT_DOUBLE_EQ(begin(0, {.abs_trgt = 1000}, manual_4_8).duration(), 0.3);
  EXPECT_DOUBLE_EQ(begin(0, {.abs_trgt = 2000}, manual_4_8).duration(), 0.5);
}

TEST(AgitoBegin, ARelativeTargetOverridesTheAbsoluteOne) {
  EXPECT_EQ(begin(1000, {.abs_trgt = 5000}, manual_4_1).end().position, 5000);
  EXPECT_EQ(begin(1000, {.abs_trgt = 5000, .rel_trgt = 7000}, manual_4_1).end().position, 8000);
  EXPECT_EQ(resolved({.abs_trgt = 5000, .rel_trgt = -1}, 1000), 999);
  EXPECT_THROW(begin(5000, {.abs_trgt = 5000}, manual_4_1), InputError);
}

TEST(AgitoBegin, SeventyTwoMovesReturnToWhereTheyBegan) {
  const Settings manual_4_6{.accel = 100000, .decel = 100000, .speed = 10000};
  double position = 0;
  double moving = 0;
  for (int i = 0; i < 72; ++i) {
    const Profile move =
        begin(position, {.rel_trgt = i / 12 % 2 == 0 ? 10000 : -10000}, manual_4_6);
    EXPECT_DOUBLE_EQ(move.duration(), 1.1);
    position = move.end().position;
    moving += move.duration();
  }
  EXPECT_EQ(position, 0);
  EXPECT_NEAR(moving, 79.2, 1e-9);
}

TEST(AgitoJerk, BuildsTheAccelerationUpInTwoToThePowerOfItSamples) {
  EXPECT_EQ(jerk_time(0), 0);
  EXPECT_EQ(jerk_time(1), 2.0 / 16384);
  EXPECT_EQ(jerk_time(9), 0.03125);
  Settings axis = manual_4_1;
  axis.decel = 50000;
  axis.jerk = 5;
  const Profile p = begin(0, {.abs_trgt = 2000}, axis);
  EXPECT_DOUBLE_EQ(p.phase(0).duration, 32.0 / 16384);
  EXPECT_DOUBLE_EQ(p.phase(0).value, 100000 * 16384.0 / 32);
  EXPECT_DOUBLE_EQ(p.phase(6).duration, 32.0 / 16384);
  EXPECT_DOUBLE_EQ(p.duration(), 2 + 0.005 + 0.01 + 32.0 / 16384);
}

TEST(AgitoSettings, KeepTheManualsRanges) {
  const auto refused = [](auto change) {
    Settings bad = manual_4_1;
    change(bad);
    EXPECT_THROW(dynamics(bad), InputError);
  };
  refused([](Settings& s) { s.accel = 99; });
  refused([](Settings& s) { s.accel = 2.1e9; });
  refused([](Settings& s) { s.decel = 0; });
  refused([](Settings& s) { s.speed = 60'000'001; });
  refused([](Settings& s) { s.speed = 0; });
  refused([](Settings& s) { s.jerk = 10; });
  refused([](Settings& s) { s.jerk = -1; });
  EXPECT_NO_THROW(dynamics({.accel = 2e9, .decel = 100, .speed = -6e7, .jerk = 9}));
}

TEST(AgitoRepetitive, MovesBetweenStartAndTargetWithWaits) {
  const Trajectory f = repetitive(1000, {.abs_trgt = 5000}, manual_4_1, 3, 250);
  const double stroke = 4.01;
  EXPECT_NEAR(f.end(), 3 * stroke + 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(f.at(stroke + 0.1).position, 5000);
  EXPECT_EQ(f.at(stroke + 0.1).velocity, 0);
  EXPECT_DOUBLE_EQ(f.at(2 * stroke + 0.3).position, 1000);
  EXPECT_DOUBLE_EQ(f.at(f.end(), Side::left).position, 5000);
  test::expect_invariants(f, 1);
  EXPECT_THROW(repetitive(0, {.abs_trgt = 1}, manual_4_1, 0), InputError);
  EXPECT_THROW(repetitive(0, {.abs_trgt = 1}, manual_4_1, 2, -1), InputError);
}

TEST(AgitoQuasiSine, FiveHertzJustTouchesItsSpeed) {
  const Settings s = quasi_sine(200, 5);
  EXPECT_EQ(s.accel, 160000);
  EXPECT_EQ(s.decel, 160000);
  EXPECT_EQ(s.speed, 8000);
  const Trajectory f = repetitive(0, {.rel_trgt = 400}, s, 4);
  EXPECT_NEAR(f.end(), 0.4, 1e-15);
  EXPECT_EQ(f.segments().size(), 8U);  // triangles: nothing at constant speed
  EXPECT_DOUBLE_EQ(extrema(f, 1).max.value, 8000);
}

TEST(AgitoBegin, ValuesWrittenWhileMovingActAtOnce) {
  const Trajectory f = begin(0, {.abs_trgt = 2000}, manual_4_1).curve();
  Settings faster = manual_4_1;
  faster.speed = 2000;
  // At 1 s at 995: 10 ms to 2000 over 15, braking 20 ms over 20, the rest at 2000.
  const Trajectory g = begin(f, 1, {.rel_trgt = 3000}, faster);
  EXPECT_NEAR(g.end(), 1 + 0.01 + 0.02 + (3000 - 15 - 20) / 2000.0, 1e-12);
  EXPECT_NEAR(g.at(g.end()).position, 3995, 1e-11);
}

TEST(AgitoSpeedChange, SlowsTheApproachDownAtItsPosition) {
  // 4.11: to 3800 at 20000, from 3400 on at 500. 175 ms to 3400, 9.75 ms over 99.9375, 600 ms,
  // 0.25 ms over the last 0.0625.
  Settings axis{.accel = 2e6, .decel = 2e6, .speed = 20000};
  const Trajectory f = begin(0, {.abs_trgt = 3800}, axis).curve();
  const Trajectory g = with_speed_change(f, 3800, axis, {.position = 3400, .new_speed = 500});
  EXPECT_NEAR(g.end(), 0.785, 1e-12);
  EXPECT_NEAR(g.at(g.end()).position, 3800, 1e-11);
  EXPECT_NEAR(g.at(0.5).velocity, 500, 1e-9);
  axis.jerk = 4;
  const Trajectory smooth = begin(0, {.abs_trgt = 3800}, axis).curve();
  test::expect_invariants(
      with_speed_change(smooth, 3800, axis, {.position = 3400, .new_speed = 500}), 2);
}

TEST(AgitoSpeedChange, ActsInItsDirectionOnly) {
  const Trajectory there = begin(0, {.abs_trgt = 2000}, manual_4_1).curve();
  SpeedChange change{.position = 1000, .new_speed = 100, .direction = -1};
  EXPECT_EQ(with_speed_change(there, 2000, manual_4_1, change).end(), there.end());
  change.direction = 1;
  EXPECT_GT(with_speed_change(there, 2000, manual_4_1, change).end(), there.end() + 8);
  change.position = 3000;  // never crossed
  EXPECT_EQ(with_speed_change(there, 2000, manual_4_1, change).end(), there.end());
  change.new_speed = 0;
  EXPECT_THROW(with_speed_change(there, 2000, manual_4_1, change), InputError);
}

TEST(AgitoJog, ReachesItsSignedSpeed) {
  Settings axis = manual_4_1;
  axis.speed = -1000;
  const Profile p = jog({}, axis);
  EXPECT_EQ(p.end().velocity, -1000);
  EXPECT_DOUBLE_EQ(p.duration(), 0.01);
  const Trajectory f = stop(p.curve(), 1, axis);
  EXPECT_DOUBLE_EQ(f.end(), 1.01);
}

TEST(AgitoStop, NeedsNothingButDecel) {
  const Trajectory running = begin(0, {.abs_trgt = 2000}, manual_4_1).curve();
  const Trajectory f = stop(running, 1, {.decel = 50000});
  EXPECT_DOUBLE_EQ(f.end(), 1.02);
  EXPECT_EQ(f.outside(), Extrapolation::hold);
  const Trajectory soft = stop(running, 1, {.decel = 50000, .jerk = 5});
  EXPECT_DOUBLE_EQ(soft.end(), 1.02 + 32.0 / 16384);
  EXPECT_THROW(stop(running, 1, {.decel = 99}), InputError);
  EXPECT_THROW(stop(running, 1, {.accel = 99, .decel = 50000}), InputError);
}

}  // namespace
}  // namespace jounce::agito
