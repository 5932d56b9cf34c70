// SPDX-License-Identifier: Apache-2.0
#include "axis/src/follow/live_player.hpp"

#include <gtest/gtest.h>

namespace jounce::live_player_test {
namespace {

/// Returns its moment as its setpoint, and ends a pass 0.4 ms before each moment.
class Echo final : public Movement {
 public:
  Echo() : Movement(7, Course::live) {}
  Cause begin(const MotionState& /*axis*/, const Moment& /*now*/) noexcept override {
    return Cause::none;
  }
  Setpoint at(const Moment& now) noexcept override {
    return {now.master[0], now.master[1], {now.master[0], now.t, now.dt, 0}};
  }
  [[nodiscard]] Progress progress() const noexcept override { return Progress::running; }
  [[nodiscard]] std::optional<Moment> pass_end(const Moment& now) const noexcept override {
    if (now.t < 1) return std::nullopt;
    return Moment{now.t - 0.0004, now.dt, {now.master[0] - 2, now.master[1], 0, 0}};
  }
  [[nodiscard]] std::span<const ProfileEvent> events() const noexcept override {
    return {&begun, 1};
  }

  ProfileEvent begun{ProfileEvent::Kind::begin, 2, 1.9997, 8};
};

Moment moment(double t, double master) {
  return {t, 0.001, {master, 30, 0, 0}};
}

TEST(LivePlayer, TimeBeginsWithTheMovement) {
  Echo echo;
  LivePlayer player(1'000'000);
  EXPECT_EQ(player.movement(), nullptr);
  player.begin(echo, 500);
  EXPECT_EQ(player.movement(), &echo);
  EXPECT_EQ(player.at(moment(0, 10), 500).slave[1], 0);
  EXPECT_EQ(player.at(moment(0, 10), 1750).slave[1], 1.25);
  EXPECT_DOUBLE_EQ(player.at(moment(-0.0002, 10), 1750).slave[1], 1.2498);
  player.end();
  EXPECT_EQ(player.movement(), nullptr);
}

TEST(LivePlayer, ANewCoordinateOfTheMasterDoesNotMoveTheSlave) {
  Echo echo;
  LivePlayer player(1'000'000);
  player.shift_master(100);  // before it begins
  player.begin(echo, 0);
  EXPECT_EQ(player.at(moment(0, 10), 1).slave[0], 10);
  player.shift_master(5);
  player.shift_master(-2);
  const Setpoint next = player.at(moment(0, 13), 2);
  EXPECT_EQ(next.slave[0], 10);
  EXPECT_EQ(next.master, 13);
  EXPECT_EQ(next.master_velocity, 30);
}

TEST(LivePlayer, APassEndsInTheTimeAndTheCoordinateOfTheAxis) {
  Echo echo;
  LivePlayer player(1'000'000);
  player.begin(echo, 0);
  EXPECT_FALSE(player.pass_end(moment(0, 13), 999));
  player.shift_master(3);
  const auto end = player.pass_end(moment(0, 13), 2000);
  ASSERT_TRUE(end);
  EXPECT_NEAR(end->t, -0.0004, 1e-15);
  EXPECT_EQ(end->master[0], 11);
}

TEST(LivePlayer, EventsAreInTheTimeAndTheCoordinateOfTheAxis) {
  Echo echo;
  LivePlayer player(1'000'000);
  player.begin(echo, 0);
  player.shift_master(3);
  ProfileStep step;
  player.add_pass(*player.pass_end(moment(0, 13), 2000), 2000, step);
  player.add_events(2000, step);
  ASSERT_EQ(step.events().size(), 2U);
  const ProfileEvent& pass = step.events()[0];
  EXPECT_EQ(pass.kind, ProfileEvent::Kind::pass_end);
  EXPECT_EQ(pass.number, 1) << "of this cam";
  EXPECT_NEAR(pass.t, -0.0004, 1e-15);
  EXPECT_EQ(pass.master, 11);
  const ProfileEvent& begin = step.events()[1];
  EXPECT_EQ(begin.kind, ProfileEvent::Kind::begin);
  EXPECT_EQ(begin.number, 2);
  EXPECT_NEAR(begin.t, -0.0003, 1e-15);
  EXPECT_EQ(begin.master, 11);
}

}  // namespace
}  // namespace jounce::live_player_test
