// SPDX-License-Identifier: Apache-2.0
// MC_TouchProbe and MC_AbortTrigger: an axis at a constant acceleration, whose positions are known at
// every instant.
#include "axis/src/probe/touch_probe.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "axis/bench.hpp"

namespace jounce::touch_probe_test {
namespace {

using test::limits;
using test::refusal;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double dt = 1e-3;

/// A drive with four trigger inputs, a home switch and an index, at 0.3 u behind the setpoint. The
/// master is at 2 + 5 t + 3 t^2.
struct Probed {
  explicit Probed(AxisConfig config = {.limits = limits(1000, 1000)}) : axis(config) {
    drive.triggers.wired = 0b1111;
    drive.sensors.home.wired = drive.sensors.index.wired = true;
    step({command::Enable{}});
  }

  Tick step(const Command& command = {}) {
    const double t = static_cast<double>(++tick) * dt;
    Inputs inputs;
    inputs.feedback = drive;
    inputs.feedback.position = (tick > 0 ? last.position - last.offset : 0) - 0.3;
    inputs.master = {2 + 5 * t + 3 * t * t, 5 + 6 * t, 6, 0};
    last = axis.step(tick, command, inputs);
    drive.triggers.count = 0;
    drive.sensors.home.edge = drive.sensors.index.edge = nan;
    for (const Capture& capture : last.probe.captures()) all.push_back(capture);
    return last;
  }
  void change(int input, bool rising, double age = nan, double position = nan) {
    drive.triggers.change[drive.triggers.count++] = {.input = static_cast<std::uint8_t>(input),
                                                     .rising = rising,
                                                     .age = age,
                                                     .position = position};
  }
  void run(int ticks) {
    for (int i = 0; i < ticks; ++i) step();
  }
  /// Accelerates at 1000 u/s^2 from now on.
  void go() {
    from = last.position;
    step({command::MoveVelocity{.velocity = 1000, .dynamics = {.acceleration = 1000}}});
    begun = tick;
  }
  /// The setpoint at an instant, s after the beginning of the run.
  [[nodiscard]] double setpoint(double t) const {
    const double s = t - static_cast<double>(begun) * dt;
    return from + 500 * s * s;
  }
  [[nodiscard]] double now() const { return static_cast<double>(tick) * dt; }

  MotionAxis axis;
  Feedback drive;
  Tick last;
  std::vector<Capture> all;
  std::int64_t tick = -1, begun = 0;
  double from = 0;  // position at the beginning of the run
};

TEST(TouchProbe, CapturesThePositionsAtTheInstantOfTheEdge) {
  Probed axis;
  axis.go();
  axis.run(50);
  axis.step({command::TouchProbe{.input = 2}});
  EXPECT_EQ(axis.last.probe.waiting, 0b10);
  axis.run(20);
  axis.change(2, true, 0.0037);
  axis.step();
  ASSERT_EQ(axis.all.size(), 1U);
  const Capture& got = axis.all[0];
  const double t = axis.now() - 0.0037;
  EXPECT_EQ(got.input, 2);
  EXPECT_TRUE(got.rising);
  EXPECT_NEAR(got.commanded, axis.setpoint(t), 1e-9);
  EXPECT_NEAR(got.master, 2 + 5 * t + 3 * t * t, 1e-9);
  // Interpolated on a straight line, because the drive reports no velocity: a dt^2 / 8 at most.
  EXPECT_NEAR(got.actual, axis.setpoint(t - dt) - 0.3, 1000 * dt * dt / 8 + 1e-9);
  EXPECT_EQ(axis.last.probe.waiting, 0) << "a single one";
  EXPECT_EQ(axis.last.probe.total, 1U);
}

TEST(TouchProbe, APositionThatTheDriveLatchedIsTaken) {
  Probed axis;
  axis.go();
  axis.step({command::SetPosition{.position = 0}});  // refused in motion
  axis.step({command::TouchProbe{}});
  axis.run(2);
  axis.change(1, true, 0.0001, 77.25);
  axis.step();
  ASSERT_EQ(axis.all.size(), 1U);
  EXPECT_EQ(axis.all[0].position(), 77.25 + axis.last.offset);
}

TEST(TouchProbe, ASingleOneEndsACountedOneFillsAndAnEndlessOneGoesOn) {
  for (const auto& [count, expected] : {std::pair{1, 1}, {4, 4}, {256, 256}, {0, 300}}) {
    Probed axis;
    axis.step({command::TouchProbe{.count = count}});
    for (int i = 0; i < 300; ++i) {
      axis.change(1, true, 0.0002);
      axis.step();
    }
    EXPECT_EQ(axis.all.size(), static_cast<std::size_t>(expected));
    EXPECT_EQ(axis.last.probe.waiting, count == 0 ? 1 : 0);
  }
}

TEST(TouchProbe, CapturesTheSelectedEdges) {
  for (const auto edge : {ProbeEdge::rising, ProbeEdge::falling, ProbeEdge::both}) {
    Probed axis;
    axis.step({command::TouchProbe{.edge = edge, .count = 0}});
    axis.change(1, true, 0.0009);
    axis.change(3, true, 0.0008);  // another input
    axis.change(1, false, 0.0001);
    axis.step();
    ASSERT_EQ(axis.all.size(), edge == ProbeEdge::both ? 2U : 1U);
    EXPECT_EQ(axis.all[0].rising, edge != ProbeEdge::falling);
  }
}

TEST(TouchProbe, OnlyInItsWindow) {
  Probed axis;
  axis.go();
  axis.step({command::TouchProbe{.count = 0, .first_position = 20, .last_position = 45}});
  for (int i = 0; i < 400; ++i) {
    axis.change(1, true, 0.0005);
    axis.step();
  }
  ASSERT_FALSE(axis.all.empty());
  EXPECT_GE(axis.all.front().position(), 20);
  EXPECT_LT(axis.all.front().position(), 20.3);
  EXPECT_LE(axis.all.back().position(), 45);
  EXPECT_GT(axis.all.back().position(), 44.7);
}

TEST(TouchProbe, TheWindowOfAModuloAxisMayExtendBeyondTheTurn) {
  Probed axis({.limits = limits(1000, 1000), .modulo = 10});
  axis.go();
  axis.step({command::TouchProbe{.count = 0, .first_position = 9, .last_position = 1}});
  for (int i = 0; i < 250; ++i) {
    axis.change(1, true, 0.0005);
    axis.step();
  }
  ASSERT_GT(axis.all.size(), 20U);
  for (const Capture& capture : axis.all) {
    const double place = capture.position() - 10 * std::floor(capture.position() / 10);
    EXPECT_TRUE(place >= 9 || place <= 1) << place;
  }
}

TEST(TouchProbe, AnEdgeBeforeItsStartDoesNotCount) {
  Probed axis;
  axis.go();
  axis.run(20);
  axis.change(1, true);
  axis.step({command::TouchProbe{}});
  EXPECT_TRUE(axis.all.empty()) << "in the tick of the command";
  axis.change(1, true, 0.0025);  // reported two cycles late
  axis.step();
  EXPECT_TRUE(axis.all.empty());
  axis.change(1, true, 0.0005);
  axis.step();
  EXPECT_EQ(axis.all.size(), 1U);
}

TEST(TouchProbe, AnEdgeIsReportedUpToEightCyclesLate) {
  Probed axis;
  axis.go();
  axis.step({command::TouchProbe{}});
  axis.run(30);
  axis.change(1, true, TouchProbes::latest * dt);
  axis.step();
  ASSERT_EQ(axis.all.size(), 1U);
  EXPECT_NEAR(axis.all[0].commanded, axis.setpoint(axis.now() - 0.008), 1e-9);
}

TEST(TouchProbe, TheHomeSwitchAndTheIndexAreInputs) {
  Probed axis;
  axis.step({command::TouchProbe{.input = home_switch_input, .edge = ProbeEdge::both, .count = 0}});
  axis.step({command::TouchProbe{.input = index_input, .count = 0}});
  axis.run(1);
  axis.drive.sensors.home.on = true;
  axis.drive.sensors.home.edge = 3.5;
  axis.step();
  axis.drive.sensors.home.on = false;  // a drive without a latch
  axis.drive.sensors.index.edge = 4.25;
  axis.step();
  ASSERT_EQ(axis.all.size(), 3U);
  EXPECT_EQ(axis.all[0].input, home_switch_input);
  EXPECT_EQ(axis.all[0].position(), 3.5);
  EXPECT_TRUE(axis.all[0].rising);
  EXPECT_FALSE(axis.all[1].rising);
  EXPECT_EQ(axis.all[1].position(), axis.last.position - 0.3);
  EXPECT_EQ(axis.all[2].position(), 4.25);
}

TEST(TouchProbe, ASecondOneReplacesTheFirstAndAnAbortEndsIt) {
  Probed axis;
  axis.step({command::TouchProbe{.edge = ProbeEdge::falling}});
  axis.step({command::TouchProbe{.edge = ProbeEdge::rising}});
  axis.change(1, false, 0.0001);
  axis.step();
  EXPECT_TRUE(axis.all.empty());
  EXPECT_EQ(refusal(axis.step({command::AbortTrigger{1}})), Cause::none);
  axis.change(1, true, 0.0001);
  axis.step();
  EXPECT_TRUE(axis.all.empty());
  EXPECT_EQ(refusal(axis.step({command::AbortTrigger{1}})), Cause::no_touch_probe);
  EXPECT_EQ(refusal(axis.step({command::AbortTrigger{3}})), Cause::no_touch_probe);
}

TEST(TouchProbe, IsRejectedWithoutItsInputAndForAWindowThatCannotBeReached) {
  Limits range = limits(1000, 1000);
  range.position_min = -10;
  range.position_max = 100;
  Probed axis({.limits = range});
  const auto answer = [&](const command::TouchProbe& what) { return refusal(axis.step({what})); };
  EXPECT_EQ(answer({.first_position = 50, .last_position = 40}), Cause::probe_window);
  EXPECT_EQ(answer({.first_position = 101}), Cause::probe_window);
  EXPECT_EQ(answer({.last_position = -11}), Cause::probe_window);
  EXPECT_EQ(answer({.first_position = 100}), Cause::none);
  axis.drive.triggers.wired = 0b10;
  axis.drive.sensors.home.wired = axis.drive.sensors.index.wired = false;
  for (const int input : {1, 3, home_switch_input, index_input})
    EXPECT_EQ(answer({.input = input}), Cause::no_trigger_input) << input;
  EXPECT_EQ(answer({.input = 2}), Cause::none);
}

TEST(TouchProbe, WorksInAFaultWhileDisabledAndInTheTickOfAStop) {
  Probed axis;
  axis.go();
  axis.run(50);
  axis.step({command::TouchProbe{.count = 0}});
  axis.run(1);
  axis.change(1, true, 0.0001);
  axis.step({command::Stop{}});
  EXPECT_EQ(axis.all.size(), 1U);
  axis.step({command::Abort{}});
  EXPECT_EQ(axis.last.state, State::error_stop);
  axis.change(1, true, 0.0001);
  axis.step();
  EXPECT_EQ(axis.all.size(), 2U);
}

TEST(TouchProbe, ANewCoordinateOfTheAxisAppliesToEarlierPositionsAsWell) {
  Probed axis;
  axis.step({command::TouchProbe{}});
  axis.run(10);
  axis.step({command::SetPosition{.position = 1000}});
  axis.change(1, true, 0.0025);
  axis.step();
  ASSERT_EQ(axis.all.size(), 1U);
  EXPECT_EQ(axis.all[0].commanded, 1000);
  EXPECT_NEAR(axis.all[0].actual, 999.7, 1e-12);
}

TEST(PositionHistory, IsExactForAConstantJerkAndUnknownBeforeItsLength) {
  PositionHistory history;
  EXPECT_TRUE(std::isnan(history.before(0)));
  const auto at = [](double t) { return 1 + 2 * t + 3 * t * t + 40 * t * t * t; };
  for (int k = 0; k <= 20; ++k) {
    const double t = k * 0.01;
    history.add(0.01, at(t), 2 + 6 * t + 120 * t * t);
  }
  for (const double age : {0.0, 0.001, 0.0137, 0.05, 0.149})
    EXPECT_NEAR(history.before(age), at(0.2 - age), 1e-12) << age;
  EXPECT_TRUE(std::isnan(history.before(0.1501)));
  history.shift(5);
  EXPECT_NEAR(history.before(0.02), at(0.18) + 5, 1e-12);
}

}  // namespace
}  // namespace jounce::touch_probe_test
