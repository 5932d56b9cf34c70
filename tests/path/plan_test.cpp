// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/plan.hpp"

#include <gtest/gtest.h>

namespace jounce::plan_test {
namespace {

GroupLimits axes_of(std::size_t n, double jerk = 1e4) {
  return {.axes = std::vector<Limits>(n, {.acceleration = 1000, .jerk = jerk})};
}

Program square(Corner corner, double value) {
  Program p(2);
  p.set({.velocity = 100, .corner = corner, .value = value});
  p.line({100, 0}, 1);
  p.line({100, 100}, 2);
  p.line({0, 100}, 3);
  p.line({0, 0}, 4);
  return p;
}

TEST(Plan, Line) {
  Program p(1);
  p.set({.velocity = 100});
  p.line({200});
  EXPECT_NEAR(plan(p, axes_of(1)).duration(), 2.2, 1e-12);
}

TEST(Plan, Squares) {
  EXPECT_NEAR(plan(square(Corner::stop, 0), axes_of(2)).duration(), 4.8, 1e-12);
  EXPECT_NEAR(plan(square(Corner::deviation, 1), axes_of(2)).duration(), 4.568655, 5e-7);
  EXPECT_NEAR(plan(square(Corner::deviation, 4), axes_of(2)).duration(), 4.2, 5e-7);
  EXPECT_NEAR(plan(square(Corner::deviation, 0.05), axes_of(2, 1e5)).duration(), 4.413147, 5e-7);
}

}  // namespace
}  // namespace jounce::plan_test
