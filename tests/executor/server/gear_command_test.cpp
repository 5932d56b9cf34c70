// SPDX-License-Identifier: Apache-2.0
// The gear of a command on linear and modulo axes.
#include <memory>

#include <gtest/gtest.h>

#include "jounce/axis/axis_config.hpp"
#include "jounce/axis/movement.hpp"
#include "jounce/profiles/error.hpp"

#include "executor/src/server/executed_command.hpp"

namespace jounce::gear_command_test {
namespace {

/// Position in step, with the master at its sync position, of an axis that stands at `position`.
double in_step(double modulo, double position, const command::GearInPos& gear) {
  AxisConfig config;
  config.modulo = modulo;
  const std::unique_ptr<Movement> movement = gear_of(gear, 1, config, position);
  EXPECT_EQ(movement->begin({.position = position}, {.master = {0, 0, 0, 0}}), Cause::none);
  Setpoint last;
  for (int i = 0; i <= 200; ++i)
    last = movement->at(
        {.t = i * 1e-3, .dt = 1e-3, .master = {gear.master_sync_position * i / 200, 0}});
  return last.slave[0];
}

constexpr command::GearInPos forward{.numerator = 1,
                                     .denominator = 1,
                                     .master_sync_position = 100,
                                     .slave_sync_position = 10,
                                     .master_start_distance = 100};

TEST(GearCommand, EngagesAtTheNearestTurnOfAModuloAxis) {
  EXPECT_DOUBLE_EQ(in_step(360, 36000, forward), 36010) << "not a hundred turns back";
  EXPECT_DOUBLE_EQ(in_step(360, 36090, forward), 36010);
  EXPECT_DOUBLE_EQ(in_step(360, -350, forward), -350);
  EXPECT_DOUBLE_EQ(in_step(0, 40, forward), 10) << "a linear axis has one sync position";
}

TEST(GearCommand, AddsATurnToAModuloAxisToAvoidAReversal) {
  command::GearInPos gear = forward;
  gear.avoid_reversal = true;
  EXPECT_DOUBLE_EQ(in_step(360, 36090, gear), 36370) << "36010 is behind the axis";
  EXPECT_THROW(gear_of(gear, 1, AxisConfig{}, 40), InputError) << "777: no turn on a linear axis";
}

}  // namespace
}  // namespace jounce::gear_command_test
