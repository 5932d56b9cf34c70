// SPDX-License-Identifier: Apache-2.0
#include "jounce/path/plan_progress.hpp"

#include <atomic>
#include <memory>

#include <gtest/gtest.h>

#include "jounce/path/plan.hpp"

#include "tests/path/paths.hpp"

namespace jounce::plan_progress_test {
namespace {

std::shared_ptr<const Plan> planned(const Program& program) {
  return std::make_shared<const Plan>(plan(program, path_tests::usual(program.axes())));
}

/// 100 mm/s, 1000 mm/s^2, 1e4 mm/s^3: a stop from 100 mm/s takes 0.2 s and 10 mm.
TEST(PlanProgress, ALineIsBrakedTenMillimetersBeforeItsEnd) {
  Program program(1);
  program.set({.velocity = 100});
  program.line({200}, 7);
  const PlanProgress progress(planned(program));
  const PlanPlace start = progress.at(0);
  EXPECT_EQ(start.position, 0);
  EXPECT_NEAR(start.remaining, 2.2, 1e-12);
  EXPECT_NEAR(start.look_ahead, 190, 1e-9);
  EXPECT_EQ(start.line, 7);
  EXPECT_EQ(start.commands, 1U);
  const PlanPlace middle = progress.at(1.2);
  EXPECT_NEAR(middle.position, 110, 1e-9);  // 10 mm in the ramp of 0.2 s, then 100 mm
  EXPECT_NEAR(middle.remaining, 1, 1e-12);
  EXPECT_NEAR(middle.look_ahead, 80, 1e-9);
  EXPECT_EQ(progress.at(2.1).look_ahead, 0) << "it brakes";
  EXPECT_EQ(progress.at(9).remaining, 0) << "after the end";
}

TEST(PlanProgress, CountsTheCommandsThatHaveNotEnded) {
  Program program(2);
  program.set({.velocity = 100, .corner = Corner::deviation, .value = 1});
  program.line({100, 0}, 1);
  program.line({100, 100}, 2);
  program.dwell(0.5, 3);
  program.line({0, 100}, 4);
  const auto plan = planned(program);
  const PlanProgress progress(plan);
  EXPECT_EQ(progress.at(0).commands, 3U);
  EXPECT_EQ(progress.at(0).line, 1);
  const PlanPlace last = progress.at(plan->duration() - 0.01);
  EXPECT_EQ(last.line, 4);
  EXPECT_EQ(last.commands, 1U);
  EXPECT_NEAR(progress.at(0).look_ahead, plan->path().length() - 10, 1e-9)
      << "a stop in between does not end the path";
}

TEST(PlanProgress, ARestAtTheEndIsNoMotion) {
  Program program(1);
  program.set({.velocity = 100});
  program.line({200}, 1);
  program.dwell(1, 2);
  EXPECT_NEAR(PlanProgress(planned(program)).at(0).look_ahead, 190, 1e-9);
}

TEST(Plan, IsCanceledFromOutside) {
  Program program(2);
  program.set({.velocity = 100, .corner = Corner::deviation, .value = 0.1});
  for (int i = 1; i <= 50; ++i) program.line({10.0 * i, i % 2 == 0 ? 0.0 : 5.0}, i);
  std::atomic<bool> canceled = false;
  const GroupLimits limits = path_tests::usual(2);
  EXPECT_NO_THROW(plan(program, limits, {.canceled = &canceled}));
  canceled = true;
  EXPECT_THROW(plan(program, limits, {.canceled = &canceled}), PlanCanceled);
}

}  // namespace
}  // namespace jounce::plan_progress_test
