// SPDX-License-Identifier: Apache-2.0
// Repetitive moves, and changes of the velocity of a move, against closed forms.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "axis/tables.hpp"

namespace jounce::axis_strokes_test {
namespace {

using namespace test;

/// A trapezoid of velocity from rest to rest over `distance`, at the time t since its start.
double trapezoid(double distance, double v, double a, double t) {
  v = std::min(v, std::sqrt(distance * a));
  const double T = distance / v + v / a;
  t = std::clamp(t, 0.0, T);
  if (t < v / a) return a * t * t / 2;
  if (t > T - v / a) return distance - a * (T - t) * (T - t) / 2;
  return v * (t - v / a / 2);
}

/// The position of strokes between 0 and `stroke`, `wait` s apart, t s after their start.
double of_strokes(double stroke, double v, double a, double wait, double t) {
  const double T =
      stroke / std::min(v, std::sqrt(stroke * a)) + std::min(v, std::sqrt(stroke * a)) / a;
  const double n = std::floor(t / (T + wait));
  const double way = trapezoid(stroke, v, a, t - n * (T + wait));
  return std::fmod(n, 2) == 0 ? way : stroke - way;
}

// Agito PCSuite manual 4.10: amplitude 200, 5 Hz.
TEST(AxisStrokes, PlayTheQuasiSineOfAgito) {
  Bench bench({.limits = limits(8000, 160000)});
  bench.send(Kind::enable);
  const command::MoveRepetitive sine{.position = 400, .strokes = 50};
  Tick now = bench.step({sine});
  ASSERT_EQ(refusal(now), Cause::none);
  for (int k = 1; k < 5000; ++k) {
    now = bench.step();
    ASSERT_NEAR(now.position, of_strokes(400, 8000, 160000, 0, k * 1e-3), 1e-7) << k;
    ASSERT_EQ(now.state, State::discrete_motion);
    ASSERT_LE(std::abs(now.velocity), 8000 * (1 + 1e-12));
    ASSERT_LE(std::abs(now.acceleration), 160000 * (1 + 1e-12));
  }
  now = bench.run(2);
  EXPECT_EQ(now.state, State::standstill);
  EXPECT_NEAR(now.position, 0, 1e-9) << "an even number of strokes";
  EXPECT_EQ(now.finished, 1U);
  EXPECT_EQ(now.reason, Cause::none);
}

// Strokes and rests are no multiples of the cycle, and do not drift.
TEST(AxisStrokes, KeepTheirTimesBetweenTheCycles) {
  Bench bench({.limits = limits(1000, 20000)});
  bench.send(Kind::enable);
  const double wait = 0.0123456;
  bench.step(
      {command::MoveRepetitive{.position = 33, .dynamics = {.velocity = 377}, .wait = wait}});
  for (int k = 1; k < 20000; ++k)
    ASSERT_NEAR(bench.step().position, of_strokes(33, 377, 20000, wait, k * 1e-3), 1e-9) << k;
}

TEST(AxisStrokes, FinishAtTheEndOfTheStroke) {
  Bench bench({.limits = limits(1000, 20000)});
  bench.send(Kind::enable);
  bench.step({command::MoveRepetitive{.position = 50, .wait = 0.5}});
  EXPECT_EQ(refusal(bench.step({command::MoveRepetitive{.position = 10}})), Cause::in_motion);
  bench.run(800);  // in the second stroke, back, or the rest after it
  EXPECT_EQ(refusal(bench.send(Kind::finish)), Cause::none);
  const Tick now = bench.run(2000);
  EXPECT_EQ(now.state, State::standstill);
  EXPECT_NEAR(now.position, 0, 1e-12);
  EXPECT_EQ(refusal(bench.send(Kind::finish)), Cause::no_movement);
}

TEST(AxisStrokes, FinishDuringARestEndsAtOnce) {
  Bench bench({.limits = limits(1000, 20000)});
  bench.send(Kind::enable);
  bench.step({command::MoveRepetitive{.position = 50, .wait = 10}});
  EXPECT_EQ(bench.run(1000).state, State::discrete_motion);
  EXPECT_EQ(bench.send(Kind::finish).state, State::standstill);
  EXPECT_EQ(bench.run(1).position, 50);
}

TEST(AxisStrokes, HoldHaltAndMovesInterruptThem) {
  Bench bench({.limits = limits(1000, 20000)});
  bench.send(Kind::enable);
  bench.step({command::MoveRepetitive{.position = 50}});
  bench.run(30);
  bench.send(Kind::hold);
  const double held = bench.run(500).position;
  EXPECT_EQ(bench.run(500).position, held);
  bench.send(Kind::resume);
  double highest = 0;
  double lowest = 50;
  for (int k = 0; k < 1000; ++k) {
    const double p = bench.step().position;
    highest = std::max(highest, p);
    if (k > 200) lowest = std::min(lowest, p);
  }
  EXPECT_NEAR(highest, 50, 0.05);
  EXPECT_NEAR(lowest, 0, 0.05);
  bench.step({command::MoveAbsolute{.position = 20}});
  EXPECT_EQ(bench.run(1000).position, 20) << "the strokes have ended";
  bench.step({command::MoveRepetitive{.position = 50}});
  bench.run(30);
  bench.send(Kind::halt);
  EXPECT_EQ(bench.run(1000).reason, Cause::halted);
}

TEST(AxisStrokes, RejectWhatIsNoMotion) {
  AxisConfig config{.limits = limits(1000, 20000)};
  config.limits.position_max = 100;
  Bench bench(config);
  bench.send(Kind::enable);
  const auto refused = [&](const command::MoveRepetitive& what) {
    return refusal(bench.step({what}));
  };
  EXPECT_EQ(refused({.position = 101}), Cause::position_limit);
  EXPECT_EQ(refused({.position = 0}), Cause::no_such_move) << "no stroke";
  EXPECT_EQ(refused({.position = 1e-9}), Cause::no_such_move) << "many strokes in a cycle";
  EXPECT_EQ(refused({.position = NAN}), Cause::no_value);
  EXPECT_EQ(refused({.position = 1e300}), Cause::position_limit);
  EXPECT_EQ(refused({.position = -1e300}), Cause::no_such_move);
  EXPECT_EQ(refused({.position = 10, .wait = HUGE_VAL}), Cause::no_value);
  EXPECT_EQ(refused({.position = 10, .dynamics = {.velocity = 1001}}), Cause::velocity_limit);
  EXPECT_EQ(bench.run(10).state, State::standstill);
  EXPECT_EQ(refused({.position = 1e-9, .wait = 0.01}), Cause::none);
}

// ---- another velocity ----------------------------------------------------------------------------

// Googol manual, example 7-2: jog at 100 pulse/ms with 0.0625 pulse/ms^2; 50 from 100000 pulses on.
TEST(ChangeVelocity, PlaysExample72) {
  Bench bench({.limits = limits(1e5, 62500)});
  bench.send(Kind::enable);
  bench.step({command::MoveVelocity{.velocity = 1e5}});
  const Tick set = bench.step({command::ChangeVelocity{.velocity = 5e4, .position = 1e5}});
  EXPECT_EQ(refusal(set), Cause::none);
  EXPECT_TRUE(set.waiting);
  for (int ms = 2; ms <= 4000; ++ms) {
    const double t = ms;
    const double expected = t <= 1600   ? 0.0625 * t * t / 2
                            : t <= 1800 ? 80000 + 100 * (t - 1600)
                            : t <= 2600
                                ? 1e5 + 100 * (t - 1800) - 0.0625 * (t - 1800) * (t - 1800) / 2
                                : 160000 + 50 * (t - 2600);
    ASSERT_NEAR(bench.step().position, expected, 1e-6) << ms;
  }
}

// The change begins where the axis passes the position, not in the next cycle.
TEST(ChangeVelocity, BeginsBetweenTheCycles) {
  const double v = 1000;
  const double a = 5000;
  const double u = 300;
  for (const double place : {123.4567, 200.0001, 399.9999}) {
    Bench bench({.limits = limits(v, a)});
    bench.send(Kind::enable);
    bench.step({command::MoveAbsolute{.position = 600}});
    bench.step({command::ChangeVelocity{.velocity = u, .position = place}});
    const double crossing = v / a + (place - v * v / a / 2) / v;
    const double slowed = crossing + (v - u) / a;
    const double there = place + (v * v - u * u) / (2 * a);
    const double brakes = slowed + (600 - u * u / (2 * a) - there) / u;
    for (int k = 2; k < 2000; ++k) {
      const double t = k * 1e-3;
      const double left = std::max(brakes + u / a - t, 0.0);
      const double expected =
          t < v / a      ? a * t * t / 2
          : t < crossing ? v * (t - v / a / 2)
          : t < slowed   ? place + v * (t - crossing) - a * (t - crossing) * (t - crossing) / 2
          : t < brakes   ? there + u * (t - slowed)
                         : 600 - a * left * left / 2;
      ASSERT_NEAR(bench.step().position, expected, 1e-9) << place << ' ' << k;
    }
  }
}

// Agito PCSuite manual 4.11: to 3800 at 20000, from 3400 on at 500.
TEST(ChangeVelocity, ReachesTheTargetOfAgitosForceProgram) {
  Bench bench({.limits = limits(20000, 2e6)});
  bench.send(Kind::enable);
  bench.step({command::MoveAbsolute{.position = 3800}});
  bench.step({command::ChangeVelocity{.velocity = 500, .position = 3400}});
  const double end = 0.175 + 19500 / 2e6 +
                     (400 - (2e4 * 2e4 - 500.0 * 500) / 4e6 - 500.0 * 500 / 4e6) / 500 + 500 / 2e6;
  const auto last = static_cast<int>(std::floor(end * 1000));
  EXPECT_EQ(bench.run(last - 3).state, State::discrete_motion);
  const Tick now = bench.run(4);
  EXPECT_EQ(now.state, State::standstill);
  EXPECT_EQ(now.position, 3800);
}

TEST(ChangeVelocity, AppliesAtOnceWithoutAPosition) {
  Bench bench({.limits = limits(1000, 5000)});
  bench.send(Kind::enable);
  bench.step({command::MoveVelocity{.velocity = -800}});
  bench.run(500);
  EXPECT_EQ(refusal(bench.step({command::ChangeVelocity{.velocity = 300}})), Cause::none);
  EXPECT_EQ(bench.run(500).velocity, -300) << "the direction stays";
}

TEST(ChangeVelocity, WaitsForTheDirection) {
  Bench bench({.limits = limits(1000, 20000)});
  bench.send(Kind::enable);
  bench.step({command::MoveRepetitive{.position = 100}});
  bench.step(
      {command::ChangeVelocity{.velocity = 100, .position = 50, .direction = Direction::negative}});
  double fastest = 0;
  for (int k = 0; k < 170; ++k) fastest = std::max(fastest, bench.step().velocity);
  EXPECT_NEAR(fastest, 1000, 1e-9) << "not on the way up";
  EXPECT_NEAR(bench.run(300).velocity, -100, 1e-9);
}

TEST(ChangeVelocity, TheNewestOneAppliesAndAnotherMotionDropsIt) {
  Bench bench({.limits = limits(1000, 5000)});
  bench.send(Kind::enable);
  bench.step({command::MoveVelocity{.velocity = 1000}});
  bench.step({command::ChangeVelocity{.velocity = 100, .position = 400}});
  bench.step({command::ChangeVelocity{.velocity = 500, .position = 400}});
  EXPECT_NEAR(bench.run(1500).velocity, 500, 1e-9);
  bench.step({command::ChangeVelocity{.velocity = 100, .position = 5000}});
  bench.step({command::MoveVelocity{.velocity = 1000}});
  EXPECT_NEAR(bench.run(9000).velocity, 1000, 1e-9);
}

TEST(ChangeVelocity, IsRejectedWithoutAMove) {
  Bench bench({.limits = limits(1000, 5000)});
  const auto change = [&](double velocity, double position = as_configured) {
    return refusal(bench.step({command::ChangeVelocity{velocity, position}}));
  };
  EXPECT_EQ(change(100), Cause::not_enabled);
  bench.send(Kind::enable);
  EXPECT_EQ(change(100), Cause::no_movement);
  bench.step({command::MoveVelocity{.velocity = 900}});
  EXPECT_EQ(change(NAN), Cause::no_value);
  EXPECT_EQ(change(0), Cause::not_positive);
  EXPECT_EQ(change(1001), Cause::velocity_limit);
  EXPECT_EQ(change(100, HUGE_VAL), Cause::no_value);
  EXPECT_EQ(change(100, 1e300), Cause::none) << "the axis never passes it";
  bench.run(100);
  bench.send(Kind::halt);
  EXPECT_EQ(change(100), Cause::halting);
  bench.run(1000);
  Job from_here(8, there_and_back(bench.run(1).position, 5, 4, Extrapolation::hold));
  bench.arm(from_here);
  bench.send(Kind::start);
  EXPECT_EQ(change(100), Cause::not_a_move);
}

}  // namespace
}  // namespace jounce::axis_strokes_test
