// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/drive/machine_sensors.hpp"
#include "jounce/stream/sender/client.hpp"
#include "jounce/stream/sender/driver.hpp"

#include "axis/tables.hpp"
#include "executor/record/log_judge.hpp"
#include "executor/site.hpp"
#include "support/temporary_folder.hpp"

// A homing that is ordered over the stream: what its log shows, and what becomes of other orders meanwhile.

namespace jounce::homing_test {
namespace {

using namespace test;
using namespace std::chrono_literals;

constexpr double acceleration = 800, jerk = 2e4, bounce = 0.004;

/// A slide between limit switches at -100 and 100, its home switch on from 10 to 32.
ExecutorOptions slide(double at) {
  ExecutorOptions options = axis_named("slide", limits(200, 1000, jerk), {"", "mm"});
  options.axis.homing = {
      .method = 24, .search_velocity = 50, .index_velocity = 5, .acceleration = acceleration};
  options.drive = std::make_shared<DriveOnMachine>(
      std::make_shared<NullDrive>(at),
      MachineSensorsSpec{.home = MachineSwitch{.position = 10, .width = 22, .bounce = bounce},
                         .negative = negative_switch(-100),
                         .positive = positive_switch(100),
                         .index = MachineIndex{.period = 10, .offset = 3}},
      1e-3);
  return options;
}

struct Slide : Site {
  explicit Slide(const ExecutorOptions& options) : Site({options}, {.recorded = true}) {
    EXPECT_TRUE(client.enable().ok());
  }
  /// Runs until the homing has ended; its owner sends heartbeats.
  void finish() {
    for (int i = 0; i < 4000 && last().state == State::homing; ++i) {
      advance(20ms);
      ASSERT_TRUE(client.beat().ok());
    }
  }
  Client client{link, "slide", {}, clock};
};

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(OrderedHoming, TheLogKeepsTheLimitsAndTheRecordReplays) {
  const TemporaryFolder folder;
  const auto csv = folder / "slide.csv";
  for (const int method : {1, 2, 8, 10, 17, 18, 23, 24, 25, 26, 33, 34})
    for (const double start : {-101.0, -50.0, 20.0, 60.0, 101.0}) {
      if ((method == 33 && start < -100) || (method == 34 && start > 100)) continue;
      SCOPED_TRACE("method " + std::to_string(method) + " from " + std::to_string(start));
      ExecutorOptions options = slide(start);
      options.log = csv;
      Slide site(options);
      const std::int64_t sent = site.last().tick;
      ASSERT_TRUE(site.client.command(command::Home{.offset = 7, .method = method}).ok());
      const std::vector<Accepted> orders{{.what = Accepted::What::homes,
                                          .sent = sent,
                                          .answered = site.last().tick,
                                          .acceleration = acceleration,
                                          .method = method,
                                          .fastest = 50,
                                          .home = 7,
                                          .timeout = 60,
                                          .words = "home"}};
      while (site.last().state == State::homing) {
        site.turn();
        if (site.last().tick % 100 != 0) continue;
        ASSERT_TRUE(site.client.beat().ok());
      }
      ASSERT_TRUE(site.last().homed) << name(site.last().fault);
      EXPECT_TRUE(site.replayed().same());
      const auto findings = judged(read(csv),
                                   {.velocity = 50,
                                    .acceleration = acceleration,
                                    .jerk = jerk,
                                    .stop_acceleration = acceleration,
                                    .stop_jerk = jerk,
                                    .machine = MachineBounds{.start = start,
                                                             .negative = -100,
                                                             .positive = 100,
                                                             .home_low = 10,
                                                             .home_high = 32,
                                                             .index_period = 10,
                                                             .index_offset = 3,
                                                             .tolerance = bounce * 5}},
                                   orders);
      for (const std::string& finding : findings) ADD_FAILURE() << finding;
      if (::testing::Test::HasFailure()) break;
    }
}

TEST(OrderedHoming, ItsEndIsInTheStatus) {
  Slide site(slide(-50));
  const auto status = [&] {
    site.advance(60ms);
    return site.dispatcher.server().status();
  };
  EXPECT_FALSE(status().homed);
  ASSERT_TRUE(site.client.command(command::Home{}).ok());
  EXPECT_EQ(status().state, State::homing);
  EXPECT_EQ(status().progress, wire::Progress::running);
  site.finish();
  EXPECT_TRUE(status().homed);
  EXPECT_EQ(status().state, State::standstill);
  EXPECT_EQ(status().finished, 1);
  ASSERT_TRUE(site.client.command(command::Home{}).ok());
  EXPECT_FALSE(status().homed) << "it searches anew";
}

TEST(OrderedHoming, OtherOrdersAreRejectedMeanwhile) {
  Slide site(slide(-50));
  ASSERT_TRUE(site.client.command(command::Home{}).ok());
  site.advance(200ms);
  for (const CallOutcome& outcome :
       {site.client.command(command::Home{}),
        site.client.command(command::MoveAbsolute{.position = 5}),
        site.client.command(command::MoveVelocity{.velocity = 5}),
        site.client.command(command::SetPosition{.position = 0}), site.client.hold()}) {
    EXPECT_EQ(outcome.error, StreamError::refused);
    EXPECT_EQ(outcome.cause, static_cast<std::int32_t>(Cause::in_motion)) << outcome.reason;
  }
  EXPECT_EQ(site.last().state, State::homing);
  Client other(site.link, "slide", {}, site.clock);
  EXPECT_EQ(other.command(command::Home{}).refusal, wire::Refusal::busy);
  const StreamOutcome streamed = site.play(*trapezoid_table(50, 10, 20, 20));
  EXPECT_FALSE(streamed.ok());
  EXPECT_EQ(streamed.refusal, wire::Refusal::busy);
  site.finish();
  EXPECT_TRUE(site.last().homed);
}

TEST(OrderedHoming, IsRejectedWhileATableIsPlayed) {
  Slide site(slide(-50));
  ASSERT_TRUE(
      site.client.command(command::MoveRelative{.distance = 50, .dynamics = {.velocity = 10}})
          .ok());
  site.advance(100ms);
  EXPECT_EQ(site.client.command(command::Home{}).cause,
            static_cast<std::int32_t>(Cause::in_motion));
  EXPECT_EQ(site.last().state, State::discrete_motion);
}

TEST(OrderedHoming, StopsByAnOperatorAndBySilence) {
  Slide stopped(slide(-50));
  ASSERT_TRUE(stopped.client.command(command::Home{}).ok());
  stopped.advance(300ms);
  ASSERT_TRUE(operator_stop(stopped.link, "slide", wire::StopMode::stop, 2s, {}, stopped.clock));
  stopped.advance(500ms);
  EXPECT_EQ(stopped.last().reason, Cause::stopped);
  EXPECT_EQ(stopped.last().state, State::standstill);
  EXPECT_FALSE(stopped.last().homed);

  Slide silent(slide(-50));
  ASSERT_TRUE(silent.client.command(command::Home{.method = 18}).ok());
  silent.advance(1800ms);
  EXPECT_EQ(silent.last().reason, Cause::stopped);
  EXPECT_FALSE(silent.last().homed);
}

TEST(OrderedHoming, WhatIsNotGivenOrWrong) {
  Slide site(slide(-50));
  const auto refused = [&](std::initializer_list<double> values) {
    wire::Command home = wire::message_of(command::Home{});
    std::copy(values.begin(), values.end(), home.value.begin());
    return site.client.request(home).reason;
  };
  const double nan = as_configured;
  EXPECT_NE(refused({nan, 99}).find("no_such_method"), std::string::npos);
  EXPECT_NE(refused({nan, 2.5}).find("method"), std::string::npos);
  EXPECT_NE(refused({nan, 24, 0}).find("search velocity must be greater than 0"),
            std::string::npos);
  EXPECT_NE(refused({nan, 24, 201}).find("velocity_limit"), std::string::npos);
  EXPECT_NE(refused({nan, 24, 10, 1, 100, -1}).find("timeout must be greater than 0"),
            std::string::npos);
  EXPECT_NE(refused({INFINITY, 24}).find("offset must be finite"), std::string::npos);
  EXPECT_EQ(site.last().state, State::standstill);
}

TEST(OrderedHoming, AnAxisThatRequiresItRejectsTablesBefore) {
  ExecutorOptions options = slide(0);
  options.axis.require_home = true;
  Slide site(options);
  ASSERT_TRUE(site.client.release().ok());
  const Table table = *trapezoid_table(50, 10, 20, 20);
  EXPECT_NE(site.play(table).reason.find("not_homed"), std::string::npos);
  ASSERT_TRUE(
      site.client.command(command::Home{.offset = 0, .method = command::Home::without_motion})
          .ok());
  ASSERT_TRUE(site.client.release().ok());
  EXPECT_TRUE(site.play(table).ok());
}

TEST(OrderedHoming, ARejectedTableNeitherNamesThePositionNorClearsAFault) {
  ExecutorOptions options = slide(0);
  options.axis.require_home = options.adopt_start = true;
  Slide site(options);
  ASSERT_TRUE(site.client.release().ok());
  const Table table = *there_and_back(30, 5, 2, Extrapolation::hold);
  EXPECT_NE(site.play(table).reason.find("not_homed"), std::string::npos);
  EXPECT_EQ(site.last().position, 0);
  EXPECT_EQ(site.last().offset, 0);
  ASSERT_TRUE(operator_stop(site.link, "slide", wire::StopMode::abort, 2s, {}, site.clock));
  EXPECT_NE(site.play(table).reason.find("not_homed"), std::string::npos);
  EXPECT_EQ(site.last().fault, Cause::aborted);
  EXPECT_EQ(site.last().offset, 0);
}

}  // namespace
}  // namespace jounce::homing_test
