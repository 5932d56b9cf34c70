// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>

#include <gtest/gtest.h>

#include "jounce/stream/sender/client.hpp"
#include "jounce/stream/sender/driver.hpp"

#include "axis/tables.hpp"
#include "executor/site.hpp"

// A hold-to-run jog runs only while its session sends heartbeats.

namespace jounce::hold_to_run_test {
namespace {

using namespace test;
using namespace std::chrono_literals;

struct Jogging : Site {
  explicit Jogging(const ExecutorOptions& options) : Site({options}) {}
  Client client{link, "feeder", {}, clock};

  void expect_released() {
    advance(400ms);
    EXPECT_EQ(last().velocity, 0);
    EXPECT_EQ(last().state, State::standstill);
    EXPECT_EQ(last().reason, Cause::released);
    EXPECT_EQ(last().stopped, 1U);
  }
};

ExecutorOptions feeder() {
  return axis_named("feeder", limits(1000, 1e4, 1e6), {"", "mm"});
}

TEST(HoldToRun, RunsWhileItsSessionSendsAndStopsWhenItIsSilent) {
  ExecutorOptions options = feeder();
  options.stop_when_silent = false;  // that is for other motions
  options.receiver.session_timeout = 10s;
  double furthest = 0;
  Jogging site(options);
  ASSERT_TRUE(
      site.client.command(command::MoveVelocity{.velocity = 100, .hold_to_run = true}).ok());
  for (int i = 0; i < 20; ++i) {
    site.advance(150ms);
    ASSERT_EQ(site.last().velocity, 100) << i;
    ASSERT_TRUE(site.client.beat().ok());
  }
  site.advance(150ms);
  EXPECT_EQ(site.last().velocity, 100);
  site.after = [&] { furthest = std::max(furthest, std::abs(site.last().acceleration)); };
  site.expect_released();
  EXPECT_LE(furthest, 2e4 * (1 + 1e-9)) << "within the stop limits";
}

TEST(HoldToRun, StopsWhenItsSessionIsReleased) {
  Jogging site(feeder());
  ASSERT_TRUE(
      site.client.command(command::MoveVelocity{.velocity = -100, .hold_to_run = true}).ok());
  site.advance(100ms);
  EXPECT_EQ(site.last().velocity, -100);
  ASSERT_TRUE(site.client.release().ok());
  site.expect_released();
}

// It ends the session, too; the end of the session must not take its place.
TEST(HoldToRun, AnOperatorsStopIsConfirmedAndStaysAStop) {
  Jogging site(feeder());
  ASSERT_TRUE(
      site.client.command(command::MoveVelocity{.velocity = 100, .hold_to_run = true}).ok());
  site.advance(50ms);
  EXPECT_TRUE(operator_stop(site.link, "feeder", wire::StopMode::stop, 1s, {}, site.clock));
  site.advance(100ms);
  EXPECT_EQ(site.last().state, State::standstill);
  EXPECT_EQ(site.last().reason, Cause::stopped);
  EXPECT_EQ(site.last().stopped, 1U);
}

// Later orders of the session keep the hold-to-run, obeyed or rejected.
TEST(HoldToRun, NothingElseInTheSessionTurnsItIntoAMotionThatRunsOn) {
  for (int which = 0; which < 4; ++which) {
    Jogging site(feeder());
    ASSERT_TRUE(
        site.client.command(command::MoveVelocity{.velocity = 100, .hold_to_run = true}).ok());
    site.advance(50ms);
    if (which == 0) {
      EXPECT_FALSE(site.client.command(command::MoveVelocity{.velocity = 2000}).ok());
    } else if (which == 1) {
      EXPECT_TRUE(site.client.command(command::Override{0.5}).ok());
    } else if (which == 2) {
      EXPECT_TRUE(site.client.hold().ok() && site.client.resume().ok());
    } else {
      EXPECT_TRUE(site.client.command(command::MoveVelocity{.velocity = 200}).ok());
    }
    site.advance(150ms);
    EXPECT_GT(site.last().velocity, 0);
    site.advance(100ms);
    site.expect_released();
  }
}

TEST(HoldToRun, AJogWithoutItGoesOn) {
  Jogging site(feeder());
  ASSERT_TRUE(site.client.command(command::MoveVelocity{.velocity = 100}).ok());
  ASSERT_TRUE(site.client.release().ok());
  site.advance(1s);
  EXPECT_EQ(site.last().velocity, 100);
  ASSERT_TRUE(site.client.command(command::MoveVelocity{.velocity = 0, .hold_to_run = true}).ok());
  site.advance(100ms);
  EXPECT_EQ(site.last().state, State::standstill);
}

}  // namespace
}  // namespace jounce::hold_to_run_test
