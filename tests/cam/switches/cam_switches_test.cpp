// SPDX-License-Identifier: Apache-2.0
#include "jounce/cam/switches/cam_switches.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "jounce/profiles/moves/s_curve.hpp"

#include "support/random.hpp"

namespace jounce::cam_switches_test {
namespace {

using test::Random;

constexpr double cycle = 1e-3;

CamSwitch range(double first, double last, AxisDirection direction = AxisDirection::both) {
  return {.first_on_position = first, .last_on_position = last, .axis_direction = direction};
}

/// All edges of a motion that is handed over once a cycle, with times since its start.
std::vector<SwitchEdge> stepped(const CamSwitchSpec& spec, const Trajectory& motion) {
  CamSwitches bits(spec);
  std::vector<SwitchEdge> edges;
  const auto count = static_cast<int>(std::floor(motion.length() / cycle + 1e-6));
  for (int k = 0; k <= count; ++k) {
    const Jet now = motion.jet(motion.start() + k * cycle);
    const SwitchStep& step = bits.step(now[0], now[1], cycle);
    EXPECT_EQ(step.lost, 0U);
    for (SwitchEdge edge : step.edges()) {
      EXPECT_GE(edge.time, 0);
      EXPECT_LT(edge.time, cycle);
      edge.time += (k - 1) * cycle;
      edges.push_back(edge);
    }
  }
  return edges;
}

/// The largest difference of the edge times of both faces, s.
double difference(const CamSwitchSpec& spec, const Trajectory& motion) {
  const auto ticked = stepped(spec, motion);
  const auto exact = switch_times(spec, motion).edges;
  EXPECT_EQ(ticked.size(), exact.size());
  double worst = 0;
  for (std::size_t i = 0; i < std::min(ticked.size(), exact.size()); ++i) {
    EXPECT_EQ(ticked[i].track, exact[i].track);
    EXPECT_EQ(ticked[i].on, exact[i].on);
    worst = std::max(worst, std::abs(ticked[i].time - exact[i].time));
  }
  return worst;
}

const CamSwitchSpec rotary{.switches = {range(30, 80), range(350, 10), range(100, 101)},
                           .tracks = {{.on_compensation = -0.004, .off_compensation = 0.002}},
                           .period = 360};

TEST(CamSwitches, IsOnTheAnalyticCrossingOnAConstantAcceleration) {
  // x = a t^2 / 2: the cubic of a cycle is the motion itself.
  Segment f;
  f.degree = 2;
  f.c[2] = 2500;
  const Trajectory motion({f});
  EXPECT_LT(
      difference({.switches = {range(0.001, 0.02), range(10, 20), range(500.3, 2400.7)}}, motion),
      1e-12);
  EXPECT_LT(difference(rotary, motion), 1e-12);
}

TEST(CamSwitches, IsWithinAMicrosecondOnAcceleratingMasters) {
  const Trajectory trapezoidal =
      trapezoid({.to = 3600, .velocity = 3000, .acceleration = 12345.678}).curve();
  const Trajectory smooth =
      s_curve({.to = 3600, .velocity = 3000, .acceleration = 2e4, .jerk = 4.321e5}).curve();
  Segment swing;  // 3 Hz
  swing.sines = 1;
  swing.sine[0] = {500, 6 * std::numbers::pi, 0.1};
  EXPECT_LT(difference(rotary, trapezoidal), 1e-6);
  EXPECT_LT(difference(rotary, smooth), 1e-6);
  EXPECT_LT(difference(rotary, Trajectory({swing})), 1e-6);
}

TEST(CamSwitches, AStepOfTheAccelerationWithinACycleCostsAtMostThis) {
  // Documented bound for a step by a in the middle of a cycle: a dt^2 / (64 v)... measured here on
  // boundaries all over the cycle, at 10 ms after the start from rest.
  const double a = 10000;
  double worst = 0;
  for (int i = 1; i < 50; ++i) {
    const double ramp = 0.0105;
    const double v = a * ramp;
    const double x = v * ramp / 2;
    const Trajectory motion({cubic(ramp, 0, 0, x, v), line(0.01, x, x + 0.01 * v)});
    const double first = x + v * (i - 25) / 50 * cycle;
    const auto ticked = stepped({.switches = {range(first, first + 1000)}}, motion);
    const auto exact = switch_times({.switches = {range(first, first + 1000)}}, motion).edges;
    ASSERT_EQ(ticked.size(), 1U);
    worst = std::max(worst, std::abs(ticked[0].time - exact[0].time));
  }
  EXPECT_LT(worst, cycle * cycle / (32 * 0.0105));
  EXPECT_GT(worst, 0.1 * cycle * cycle / (32 * 0.0105));  // and it is that large
}

TEST(CamSwitches, AJumpPassesEveryEdgeOnTheWayInOrder) {
  CamSwitches bits(
      {.switches = {range(20, 30), {.track = 2, .first_on_position = 40, .last_on_position = 50}}});
  bits.step(0, 0, cycle);
  const SwitchStep& jump = bits.step(100, 0, cycle);
  ASSERT_EQ(jump.count, 4U);
  const std::array<SwitchEdge, 4> expected{
      {{0.2, 1, true}, {0.3, 1, false}, {0.4, 2, true}, {0.5, 2, false}}};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(jump.edge[i].track, expected[i].track);
    EXPECT_EQ(jump.edge[i].on, expected[i].on);
    EXPECT_TRUE(i == 0 || jump.edge[i].time > jump.edge[i - 1].time);
  }
  EXPECT_EQ(jump.outputs, 0U);
}

TEST(CamSwitches, MoreEdgesThanFitAreCountedAndTheOutputsAreRight) {
  CamSwitchSpec spec;
  for (int i = 0; i < 40; ++i) spec.switches.push_back(range(10 * i + 1, 10 * i + 6));
  CamSwitches bits(spec);
  bits.step(0, 0, cycle);
  const SwitchStep& step = bits.step(393, 0, cycle);
  EXPECT_EQ(step.count, SwitchStep::most_edges);
  EXPECT_EQ(step.lost, 79 - SwitchStep::most_edges);
  EXPECT_EQ(step.outputs, 1U);
  EXPECT_EQ(bits.step(399, 0, cycle).outputs, 0U);
}

TEST(CamSwitches, PositionsMayWrapOrCountOn) {
  const Trajectory motion =
      s_curve({.from = 100, .to = -2000, .velocity = 3000, .acceleration = 2e4, .jerk = 4e5})
          .curve();
  CamSwitches on(rotary);
  CamSwitches wrapping(rotary);
  for (int k = 0; k * cycle < motion.length(); ++k) {
    const Motion now = motion.at(k * cycle);
    const SwitchStep a = on.step(now.position, now.velocity, cycle);
    const SwitchStep b = wrapping.step(wrapped(now.position, 0, 360), now.velocity, cycle);
    ASSERT_EQ(a.outputs, b.outputs) << k;
    ASSERT_EQ(a.count, b.count) << k;
    for (std::size_t i = 0; i < a.count; ++i) EXPECT_NEAR(a.edge[i].time, b.edge[i].time, 1e-12);
  }
}

TEST(CamSwitches, MillionsOfTurnsLoseNoDigits) {
  // Power-of-two steps, so that the positions handed over are exact.
  const CamSwitchSpec spec{.switches = {range(30, 80)}, .period = 256};
  CamSwitches fresh(spec);
  CamSwitches old(spec);
  const double far = 256.0 * (1LL << 32);
  for (int k = 0; k < 4000; ++k) {
    const double x = k * 0.25;
    const SwitchStep a = fresh.step(x, 250, cycle);
    const SwitchStep b = old.step(far + x, 250, cycle);
    ASSERT_EQ(a.count, b.count);
    for (std::size_t i = 0; i < a.count; ++i) EXPECT_EQ(a.edge[i].time, b.edge[i].time);
  }
}

TEST(CamSwitches, NoiseWithinTheHysteresisMakesOneEdgeOfEachCrossing) {
  // Velocities as a differentiator has them. A cubic between two noisy points swings out by up to
  // 4/27 of the difference of the two before: 0.7 h and that is less than h from end to end.
  Random random(7);
  for (int run = 0; run < 200; ++run) {
    const double h = random.log_uniform(0.01, 1);
    const double speed = random.log_uniform(0.2, 200);
    const CamSwitchSpec spec{
        .switches = {range(20, 25, static_cast<AxisDirection>(random.below(2)))},
        .tracks = {{.hysteresis = h}}};
    CamSwitches bits(spec);
    const auto steps = static_cast<int>(15 / speed / cycle) + 2;
    int edges = 0;
    double before = 15;
    for (int k = 0; k < steps; ++k) {
      const double x = 15 + speed * k * cycle + random.uniform(-0.35 * h, 0.35 * h);
      for (const SwitchEdge& edge : bits.step(x, (x - before) / cycle, cycle).edges()) {
        EXPECT_EQ(edge.on, edges % 2 == 0);
        ++edges;
      }
      before = x;
    }
    EXPECT_EQ(edges, 2) << "run " << run << ": hysteresis " << h << ", speed " << speed;
  }
}

TEST(CamSwitches, AVelocityThatContradictsThePositionsCannotInventEdges) {
  // The cubic through these would swing far outside 10 to 10.1.
  for (const double sign : {1.0, -1.0}) {
    CamSwitches bits({.switches = {range(10.2, 30), range(-30, 9.9)}});
    bits.step(10, 0, cycle);
    for (const double v : {1e5, 1e3, 1e5, 1e9, 1e300}) {
      EXPECT_EQ(bits.step(10.1, sign * v, cycle).count, 0U);
      EXPECT_EQ(bits.step(10, sign * v, cycle).count, 0U);
    }
  }
}

TEST(CamSwitches, AReversalWithinACycleIsFound) {
  // x = 10 - 10000 (t - 0.0015)^2 has its top between two ticks; 9.999 is passed twice there.
  CamSwitches bits({.switches = {range(9.999, 20)}});
  const auto x = [](double t) { return 10 - 10000 * (t - 0.0015) * (t - 0.0015); };
  const auto v = [](double t) { return -20000 * (t - 0.0015); };
  bits.step(x(0), v(0), cycle);
  EXPECT_EQ(bits.step(x(0.001), v(0.001), cycle).count, 0U);
  const SwitchStep& step = bits.step(x(0.002), v(0.002), cycle);
  ASSERT_EQ(step.count, 2U);
  const double half = std::sqrt(1e-3 / 10000);
  EXPECT_NEAR(step.edge[0].time, 0.0005 - half, 1e-10);
  EXPECT_NEAR(step.edge[1].time, 0.0005 + half, 1e-10);
}

TEST(CamSwitches, DurationsCountTimeNotCycles) {
  CamSwitches bits(
      {.switches = {{.first_on_position = 20, .mode = CamSwitchMode::time, .duration = 0.01234}}});
  double on = -1;
  double off = -1;
  for (int k = 0; k < 100; ++k)
    for (const SwitchEdge& edge : bits.step(k * 1.7, 1700, cycle).edges())
      (edge.on ? on : off) = (k - 1) * cycle + edge.time;
  EXPECT_NEAR(on, 20 / 1700.0, 1e-12);
  EXPECT_NEAR(off - on, 0.01234, 1e-12);
}

TEST(CamSwitches, ANewPlaceIsNoMotion) {
  CamSwitches bits(
      {.switches = {
           range(20, 30),
           {.track = 2, .first_on_position = 50, .mode = CamSwitchMode::time, .duration = 1}}});
  EXPECT_EQ(bits.step(0, 0, cycle).outputs, 0U);
  bits.place();
  const SwitchStep& there = bits.step(25, 100, cycle);
  ASSERT_EQ(there.count, 1U);
  EXPECT_EQ(there.edge[0].time, 0);
  EXPECT_TRUE(there.edge[0].on);
  bits.place();
  EXPECT_EQ(bits.step(100, 0, cycle).outputs, 0U);  // 50 was not passed
}

TEST(CamSwitches, TheMaskActsFromTheNextStep) {
  CamSwitches bits({.switches = {range(20, 30)}, .tracks = {{.enabled = false}}});
  EXPECT_EQ(bits.step(25, 0, cycle).outputs, 0U);
  bits.enable(1);
  const SwitchStep& on = bits.step(25, 0, cycle);
  ASSERT_EQ(on.count, 1U);
  EXPECT_EQ(on.outputs, 1U);
  bits.enable(0);
  EXPECT_EQ(bits.step(25, 0, cycle).outputs, 0U);
}

TEST(CamSwitches, WhatIsNoNumberChangesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CamSwitches bits({.switches = {range(20, 30)}});
  bits.step(19, 1000, cycle);
  EXPECT_EQ(bits.step(nan, 1000, cycle).count, 0U);
  EXPECT_EQ(bits.step(20, HUGE_VAL, cycle).count, 0U);
  const SwitchStep& after = bits.step(22, 1000, cycle);  // 3 ms after the last good one
  ASSERT_EQ(after.count, 1U);
  EXPECT_EQ(after.edge[0].time, 0);  // it was two cycles ago
  EXPECT_EQ(after.outputs, 1U);
}

TEST(CamSwitches, BeforeTheFirstStepThereIsTheInitialValue) {
  const CamSwitchSpec spec{.switches = {range(20, 30)}, .tracks = {{.initial = true}}};
  CamSwitches bits(spec);
  EXPECT_EQ(bits.outputs(), 1U);
  const SwitchStep& first = bits.step(0, 0, cycle);
  EXPECT_EQ(first.outputs, 0U);
  EXPECT_EQ(first.count, 0U);
}

}  // namespace
}  // namespace jounce::cam_switches_test
