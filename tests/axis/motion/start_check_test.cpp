// SPDX-License-Identifier: Apache-2.0
#include "axis/src/motion/start_check.hpp"

#include <gtest/gtest.h>

#include "axis/bench.hpp"
#include "axis/model/model_movements.hpp"

namespace jounce::start_check_test {
namespace {

using namespace test;

/// A coupling with settable answers.
class Answers final : public Movement {
 public:
  Answers() : Movement(1, Course::live) {}

  Peaks need = {};
  std::optional<MotionState> first = {};
  int way = 0;

  Cause begin(const MotionState&, const Moment&) noexcept override { return Cause::none; }
  Setpoint at(const Moment&) noexcept override { return {}; }
  [[nodiscard]] Progress progress() const noexcept override { return Progress::running; }
  [[nodiscard]] double place() const noexcept override { return 7; }
  [[nodiscard]] int direction() const noexcept override { return way; }
  [[nodiscard]] Peaks demand(const Moment&) const noexcept override { return need; }
  [[nodiscard]] std::optional<MotionState> first_setpoint(const Moment&) const noexcept override {
    return first;
  }
};

const AxisConfig axis = resolved({.limits = limits(100, 1000)});
constexpr Moment now{.dt = 1e-3};

TEST(StartCheck, ARefusalNamesThePlaceThatTheMovementNeeds) {
  const Answers movement;
  const Refusal placed = begin_refusal(Cause::start_position, movement, {3, 0, 0});
  EXPECT_EQ(placed.value, 7);
  EXPECT_EQ(placed.limit, 3);
  const Refusal other = begin_refusal(Cause::start_velocity, movement, {3, 0, 0});
  EXPECT_EQ(other.value, 3);
  EXPECT_EQ(other.limit, 0);
}

TEST(StartCheck, APathOutwardsFromAnActiveSwitchIsRejected) {
  Answers path;
  path.way = 1;
  EXPECT_EQ(against_switch(path, true, false, 3)->cause, Cause::direction_blocked);
  EXPECT_FALSE(against_switch(path, false, true, 3));
  path.way = -1;
  EXPECT_TRUE(against_switch(path, false, true, 3));
  path.way = 0;
  EXPECT_FALSE(against_switch(path, true, true, 3));
}

TEST(StartCheck, ACouplingThatNeedsMoreThanALimitIsRejected) {
  Answers coupling;
  coupling.need = {.velocity = 100, .acceleration = 1000};
  EXPECT_FALSE(against_demand(coupling, now, axis));
  coupling.need.acceleration = 1001;
  EXPECT_EQ(against_demand(coupling, now, axis)->cause, Cause::acceleration_limit);
  coupling.need.velocity = 101;
  EXPECT_EQ(against_demand(coupling, now, axis)->limit, 100);
}

TEST(StartCheck, AFirstSetpointThatWouldBeAFaultIsRejected) {
  Answers coupling;
  EXPECT_FALSE(against_jump(coupling, now, {}, axis));
  coupling.first = MotionState{0.001, 2.5, 0};
  EXPECT_FALSE(against_jump(coupling, now, {}, axis));
  coupling.first->velocity = 4;
  EXPECT_EQ(against_jump(coupling, now, {}, axis)->cause, Cause::start_jump);
  coupling.first = MotionState{1, 0, 0};
  EXPECT_EQ(against_jump(coupling, now, {}, axis)->cause, Cause::velocity_limit);
  coupling.first = MotionState{0.001, 1, 1500};
  EXPECT_EQ(against_jump(coupling, now, {}, axis)->cause, Cause::acceleration_limit);
}

TEST(StartCheck, OnlyAFaultOfTheFirstSetpointDropsAWaitingMovement) {
  EXPECT_EQ(against_first(Cause::jump, {0, 5, 0}, 0, axis)->cause, Cause::start_jump);
  EXPECT_EQ(against_first(Cause::overspeed, {0, -150, 0}, 0, axis)->value, 150);
  EXPECT_EQ(against_first(Cause::overacceleration, {0, 0, 1500}, 0, axis)->limit, 1000);
  EXPECT_FALSE(against_first(Cause::positive_switch, {}, 0, axis));
}

TEST(StartCheck, ACrossingIsFoundOnceBetweenTwoTicks) {
  const Jet before{9, 1000, 0, 0};
  const Jet after{10, 1000, 0, 0};
  const auto at = crossing(9.25, before, after, 1e-3);
  ASSERT_TRUE(at);
  EXPECT_NEAR(at->t, -0.75e-3, 1e-12);
  EXPECT_NEAR(at->master[0], 9.25, 1e-9);
  EXPECT_FALSE(crossing(10.5, before, after, 1e-3));
  EXPECT_FALSE(crossing(9, before, before, 1e-3)) << "a master at rest passes nothing";
}

}  // namespace
}  // namespace jounce::start_check_test
