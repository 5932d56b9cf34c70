// SPDX-License-Identifier: Apache-2.0
#include "axis/src/homing/home_search.hpp"

#include <gtest/gtest.h>

#include "axis/bench.hpp"

namespace jounce::home_search_test {
namespace {

using namespace test;

AxisConfig ranged() {
  AxisConfig config{.limits = limits(100, 1000)};
  config.limits.position_min = -50;
  config.limits.position_max = 50;
  config.homing = {.method = 23, .search_velocity = 20, .index_velocity = 5, .timeout = 0.1};
  return resolved(config);
}

Homing::Seen seen(bool at_rest = true) {
  Homing::Seen now{.at_rest = at_rest, .dt = 1e-3};
  now.sensors.home.wired = true;
  return now;
}

TEST(HomeSearch, TheRangeAppliesIfAndOnlyIfNoSearchRuns) {
  const AxisConfig config = ranged();
  HomeSearch search(config);
  EXPECT_EQ(search.rules().limits.position_max, 50);
  HomeOrder order;
  ASSERT_FALSE(home_order_of({}, config, order));
  search.begin(order, seen());
  EXPECT_TRUE(search.running());
  EXPECT_FALSE(search.rules().limits.position_min);
  EXPECT_FALSE(search.rules().limits.position_max);
  EXPECT_EQ(search.rules().limits.velocity, 100);
  search.end();
  EXPECT_FALSE(search.running());
  EXPECT_EQ(search.rules().limits.position_min, -50);
}

TEST(HomeSearch, ReportsANewVelocityOnceAndTheFaultThatEndsIt) {
  const AxisConfig config = ranged();
  HomeSearch search(config);
  HomeOrder order;
  ASSERT_FALSE(home_order_of({}, config, order));
  search.begin(order, seen());
  int velocities = 0;
  HomeSearch::Step step;
  for (int i = 0; i < 200 && step.fault == Cause::none; ++i) {
    step = search.step(seen(velocities == 0));
    if (!step.velocity) continue;
    ++velocities;
    EXPECT_EQ(*step.velocity, 20);
  }
  EXPECT_EQ(velocities, 1);
  EXPECT_EQ(step.fault, Cause::home_timeout);
  EXPECT_EQ(step.exceeded, 0.1);
  EXPECT_FALSE(step.done);
}

TEST(HomeSearch, TheNumbersOfACommandReplaceThoseOfTheAxis) {
  const AxisConfig config = ranged();
  HomeOrder order;
  ASSERT_FALSE(home_order_of({.offset = 3, .search_velocity = 40}, config, order));
  EXPECT_EQ(order.spec.offset, 3);
  EXPECT_EQ(order.spec.search_velocity, 40);
  EXPECT_EQ(order.spec.index_velocity, 5);
}

TEST(HomeSearch, RejectsWhatItCannotDo) {
  const AxisConfig config = ranged();
  HomeOrder order;
  EXPECT_EQ(home_order_of({.method = 15}, config, order)->cause, Cause::no_such_method);
  EXPECT_EQ(home_order_of({.search_velocity = 101}, config, order)->cause, Cause::velocity_limit);
  EXPECT_EQ(home_order_of({.timeout = 0}, config, order)->cause, Cause::not_positive);
  EXPECT_EQ(home_order_of({.offset = 60}, config, order)->cause, Cause::position_limit);
}

}  // namespace
}  // namespace jounce::home_search_test
