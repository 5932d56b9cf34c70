// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/axis/axis.hpp"
#include "jounce/axis/fifo_movement.hpp"
#include "jounce/axis/live_cam.hpp"
#include "jounce/axis/live_clutch.hpp"
#include "jounce/axis/live_gear.hpp"
#include "jounce/controllers/googol/googol_pt.hpp"

#include "axis/model/model_movements.hpp"
#include "axis/tables.hpp"
#include "support/random.hpp"

namespace jounce::axis_inputs_test {
namespace {

using namespace test;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<double> extremes() {
  std::vector<double> all{std::nan(""), infinity, -infinity, 0.0, -0.0, 5e-324};
  for (const double x : {1e20, 1e49, 1e51, 1e60, 1e101, 1e154, 1e200, 1e300, 1.7e308}) {
    all.push_back(x);
    all.push_back(-x);
  }
  return all;
}

/// Every coupling behind a live master.
std::vector<std::function<std::unique_ptr<Movement>()>> couplings() {
  const auto cam = [](const CouplingSpec& spec) {
    return [spec] { return std::make_unique<LiveCam>(1, pmc600_cam(), spec); };
  };
  const auto follow = [](FollowEvent event) {
    return [event] {
      auto made = std::make_unique<FifoFollow>(1, FifoSpec{.each = 8, .stream = false, .loops = 0},
                                               FollowRun{.event = {.event = event, .position = 2}});
      googol::push(made->fifos(), 0, {100, 50});
      googol::push(made->fifos(), 0, {200, 50, PtType::stop});
      return made;
    };
  };
  const double none = 0;
  return {[] { return std::make_unique<LiveGear>(1, GearInSpec{.acceleration = 1e4}); },
          [] {
            return std::make_unique<LiveGear>(1, GearInSpec{.numerator = 2147483647,
                                                            .denominator = 2147483646,
                                                            .acceleration = 1e4,
                                                            .jerk = 1e6});
          },
          [none] {
            return std::make_unique<LiveGearInPos>(1, GearInPosSpec{.master_sync_position = 100,
                                                                    .slave_sync_position = 50,
                                                                    .master_start_distance = 80,
                                                                    .slave_start = none});
          },
          [] { return std::make_unique<LiveClutch>(1, 0.5, 0.05); },
          cam({}),
          cam({.master_absolute = false, .start = StartMode::relative}),
          cam({.start = StartMode::ramp_in, .velocity_diff = 100, .acceleration = 1e4}),
          cam({.start = StartMode::ramp_in,
               .velocity_diff = 100,
               .acceleration = 1e4,
               .slave_period = 360,
               .master_jump = 1}),
          cam({.start = StartMode::ramp_in_distance, .distance = 20}),
          follow(FollowEvent::start),
          follow(FollowEvent::pass)};
}

bool finite(const Tick& tick) {
  for (const double x : {tick.position, tick.velocity, tick.acceleration, tick.master,
                         tick.master_velocity, tick.rate, tick.override_, tick.offset})
    if (!std::isfinite(x)) return false;
  return true;
}

bool known_or_not(double x) {
  return std::isfinite(x) || std::isnan(x);
}

// In the cycle nothing throws: a master with invalid numbers is lost in that very tick, and the
// axis brakes with that cause.
TEST(AxisInputs, NoNumberOfAMasterBreaksACoupling) {
  int couplings_so_far = 0;
  for (const auto& make : couplings()) {
    ++couplings_so_far;
    for (const double value : extremes())
      for (std::size_t k = 0; k < 4; ++k)
        for (const int at : {0, 3}) {
          Bench bench({.limits = limits(1e3, 1e5)});
          bench.send(Kind::enable);
          const auto movement = make();
          Tick tick;
          Tick before;
          for (int i = 0; i < 8; ++i) {
            Inputs inputs;
            inputs.master = {i * 1e-2, 10, 0, 0};
            if (i == at) inputs.master[k] = value;
            Command command;
            if (i == 0) command = {command::Couple{.movement = movement.get()}};
            tick = bench.step(command, inputs);
            const std::string told = "coupling " + std::to_string(couplings_so_far) + ", value " +
                                     std::to_string(value) + " in " + std::to_string(k);
            ASSERT_TRUE(finite(tick)) << told;
            ASSERT_LE(std::abs(tick.velocity - before.velocity), 300) << told;
            before = tick;
          }
          if (std::abs(value) <= 1e50) continue;
          EXPECT_EQ(tick.job, 0U);
          EXPECT_EQ(tick.fault, at == 0 ? Cause::none : Cause::master_lost) << value;
        }
  }
}

TEST(AxisInputs, MovementsRejectThemToo) {
  for (const auto& make : couplings())
    for (const double value : {1e51, 1e101, 1e200, 1e300, infinity})
      for (std::size_t k = 0; k < 4; ++k) {
        const auto movement = make();
        Moment moment{0, 1e-3, {0, 10, 0, 0}};
        moment.master[k] = value;
        EXPECT_EQ(movement->begin({}, moment), Cause::no_master_input);
        moment.master = {0, 10, 0, 0};
        if (movement->begin({}, moment) != Cause::none) continue;
        static_cast<void>(movement->at(moment));
        moment.master[k] = value;
        moment.t = 1e-3;
        static_cast<void>(movement->at(moment));
        EXPECT_EQ(movement->progress(), Progress::broken);
        EXPECT_EQ(movement->cause(), Cause::master_lost);
      }
}

TEST(AxisInputs, ADriveThatReportsNonsenseHasFailed) {
  for (const double value : extremes())
    for (double Feedback::*field : {&Feedback::position, &Feedback::velocity, &Feedback::torque}) {
      Bench bench({.limits = limits(1e3, 1e5)});
      Inputs inputs;
      bench.send(Kind::enable);
      bench.step({command::MoveVelocity{.velocity = 1e3}});
      bench.run(5);
      inputs.feedback.*field = value;
      const Tick tick = bench.step({}, inputs);
      ASSERT_TRUE(finite(tick));
      EXPECT_TRUE(known_or_not(tick.actual_position) && known_or_not(tick.torque));
      const double most = field == &Feedback::position ? 0x1p40 : 1e50;  // 1 u in a tick
      const bool nonsense = std::abs(value) > most;
      EXPECT_EQ(tick.fault, nonsense ? Cause::drive_fault : Cause::none) << value;
      EXPECT_EQ(tick.state == State::disabled, nonsense);
    }
}

TEST(AxisInputs, ADisabledAxisRejectsAPositionBeyondItsRange) {
  for (const double value : extremes()) {
    Bench bench({.limits = limits(1e3, 1e5), .position = 7});
    Inputs inputs;
    inputs.feedback.position = value;
    Tick tick = bench.step({}, inputs);
    EXPECT_EQ(tick.position, std::abs(value) <= 0x1p40 ? value : 7) << value;
    tick = bench.step({command::Enable{}}, inputs);
    EXPECT_EQ(tick.refused.has_value(), std::abs(value) > 0x1p40) << value;
    EXPECT_TRUE(finite(tick));
  }
}

/// Any of the numbers of the inputs replaced by an extreme one, now and then, under moves, couplings
/// and tables: what goes out stays finite and within the limits, and what ends a motion has a cause.
TEST(AxisInputs, WithExtremeNumbersAnywhereTheSetpointStaysWithinTheLimits) {
  const std::vector<double> values = extremes();
  const AxisConfig config{.limits = limits(500, 2e4)};
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    test::Random random(seed);
    MotionAxis axis(config);
    std::vector<std::unique_ptr<Movement>> made;
    Tick before;
    double drive = 0;
    std::vector<std::string> told;
    for (std::int64_t i = 0; i < 400; ++i) {
      Inputs inputs;
      inputs.master = {static_cast<double>(i) * 1e-2, 10, 0, 0};
      inputs.feedback = {drive, 0, 0};
      const std::array<double*, 7> numbers{&inputs.master[0],         &inputs.master[1],
                                           &inputs.master[2],         &inputs.master[3],
                                           &inputs.feedback.position, &inputs.feedback.velocity,
                                           &inputs.feedback.torque};
      const bool odd = random.below(20) == 0;
      if (odd)
        *numbers[static_cast<std::size_t>(random.below(7))] =
            values[static_cast<std::size_t>(random.below(static_cast<int>(values.size())))];
      Command command;
      switch (random.below(12)) {
        case 0: {
          const auto all = couplings();
          made.push_back(
              all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))]());
          command = {command::Couple{.movement = made.back().get()}};
          break;
        }
        case 1:
          command = {command::Enable{}};
          break;
        case 2:
          command = {command::Reset{}};
          break;
        case 3:
          command = {command::MoveRelative{.distance = random.uniform(-20, 20)}};
          break;
        case 4:
          command = {command::MoveVelocity{.velocity = 1e3}};
          break;
        case 5:
          command = {command::SetPosition{
              .position =
                  values[static_cast<std::size_t>(random.below(static_cast<int>(values.size())))]}};
          break;
        default:
          break;
      }
      const Tick now = axis.step(i, command, inputs);
      const std::string place = "seed " + std::to_string(seed) + ", tick " + std::to_string(i);
      ASSERT_TRUE(finite(now)) << place;
      ASSERT_TRUE(known_or_not(now.actual_position) && known_or_not(now.following_error)) << place;
      ASSERT_LE(std::abs(now.velocity), 500 * (1 + 1e-8)) << place;
      const bool off = now.state == State::disabled;
      ASSERT_TRUE(off || std::abs(now.velocity - before.velocity) <= 40 + 20 + 1e-6) << place;
      const bool renamed = command.kind() == Kind::set_position || before.state == State::disabled;
      const double moved = renamed ? 0 : now.position - before.position;
      ASSERT_LE(std::abs(moved), 0.5 * (1 + 1e-6) + 1e-11 * std::abs(now.position)) << place;
      if (before.job != 0 && now.job == 0 && now.fault == Cause::none &&
          movement_of(command.what) == nullptr) {
        ASSERT_TRUE(command.kind() != Kind::none || now.reason != Cause::none ||
                    now.finished > before.finished || now.state == State::continuous_motion)
            << place;
      }
      drive = now.position - now.offset;
      before = now;
    }
  }
}

}  // namespace
}  // namespace jounce::axis_inputs_test
