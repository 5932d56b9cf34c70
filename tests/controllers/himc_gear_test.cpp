// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/himc/himc_gear.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace jounce::himc {
namespace {

Gears powered() {
  Gears gears;
  for (GearAxis& axis : gears.axis) axis.enabled = true;
  return gears;
}

TEST(HimcGear, OfTheManualsRatiosDisplacesTheSlaves) {
  // HMPL manual 6.1.2: ratios 1, 2, 4, -1; master 0 -> 100.
  Gears gears = powered();
  const double ratios[] = {1, 2, 4, -1};
  for (int i = 0; i < 4; ++i) {
    gears = enable_gear(gears, 0, i + 1).gears;
    const GearAnswer in = gear_in(gears, 0, i + 1, ratios[i], 0, 0);
    ASSERT_EQ(in.error, GearError::ok);
    gears = in.gears;
  }
  const double expected[] = {100, 200, 400, -100};
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(gear_position(gears, i + 1, 100), expected[i]);
    EXPECT_EQ(gear_ratio(gears, i + 1), ratios[i]);
    EXPECT_TRUE(is_in_gear(gears, i + 1));
    EXPECT_TRUE(is_gear_slave(gears, i + 1));
  }
  EXPECT_TRUE(is_gear_master(gears, 0));
  EXPECT_FALSE(is_gear_master(gears, 1));
}

TEST(HimcGear, KeepsTheOrderOfItsCalls) {
  Gears gears = powered();
  EXPECT_EQ(gear_in(gears, 0, 1, 1, 0, 0).error, GearError::not_enabled);
  EXPECT_EQ(gear_out(gears, 1).error, GearError::not_enabled);
  EXPECT_EQ(disable_gear(gears, 1).error, GearError::not_enabled);
  gears = enable_gear(gears, 0, 1).gears;
  EXPECT_EQ(enable_gear(gears, 0, 1).error, GearError::ok) << "again";
  EXPECT_EQ(gear_out(gears, 1).error, GearError::ok) << "not engaged yet: nothing happens";
  EXPECT_EQ(gear_in(gears, 0, 1, 0, 0, 0).error, GearError::bad_ratio);
  EXPECT_EQ(gear_in(gears, 0, 1, INFINITY, 0, 0).error, GearError::bad_ratio);
  EXPECT_EQ(gear_in(gears, 2, 1, 1, 0, 0).error, GearError::bad_link) << "another's slave";
  gears = gear_in(gears, 0, 1, 3, 10, 5).gears;
  EXPECT_EQ(gear_position(gears, 1, 12), 11);
  EXPECT_EQ(disable_gear(gears, 1).error, GearError::synchronized);
  gears = gear_out(gears, 1).gears;
  EXPECT_FALSE(is_in_gear(gears, 1));
  EXPECT_TRUE(is_gear_slave(gears, 1));
  gears = disable_gear(gears, 1).gears;
  EXPECT_FALSE(is_gear_slave(gears, 1));
  EXPECT_EQ(gear_ratio(gears, 1), 0);
  EXPECT_TRUE(gears.axis[1].enabled);
}

TEST(HimcGear, RejectsLinksThatCannotBe) {
  Gears gears = enable_gear(powered(), 0, 1).gears;
  EXPECT_EQ(enable_gear(gears, 0, 16).error, GearError::bad_slave);
  EXPECT_EQ(enable_gear(gears, 0, -1).error, GearError::bad_slave);
  EXPECT_EQ(enable_gear(gears, 16, 2).error, GearError::bad_link);
  EXPECT_EQ(enable_gear(gears, 2, 2).error, GearError::bad_link);
  EXPECT_EQ(enable_gear(gears, 2, 1).error, GearError::bad_link) << "has a master";
  EXPECT_EQ(enable_gear(gears, 2, 0).error, GearError::is_master);
  EXPECT_EQ(enable_gear(gears, 1, 2).error, GearError::bad_link) << "a slave as master";
  gears.axis[3].in_cam = true;
  EXPECT_EQ(enable_gear(gears, 0, 3).error, GearError::in_cam);
  gears.axis[4].enabled = false;
  EXPECT_EQ(enable_gear(gears, 0, 4).error, GearError::disabled);
  EXPECT_FALSE(is_gear_slave(enable_gear(gears, 0, 4).gears, 4)) << "and nothing has changed";
  EXPECT_EQ(static_cast<int>(GearError::bad_link), 0x1c2);
  for (const int none : {-1, 16, 99}) {
    EXPECT_EQ(gear_ratio(gears, none), 0);
    EXPECT_FALSE(is_in_gear(gears, none));
    EXPECT_FALSE(is_gear_slave(gears, none));
    EXPECT_EQ(gear_position(gears, none, 100), 0);
  }
}

}  // namespace
}  // namespace jounce::himc
