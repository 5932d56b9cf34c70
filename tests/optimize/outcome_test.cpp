// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/optimize/optimize.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "optimize/rest_to_rest.hpp"

namespace jounce::outcome_test {
namespace {

using test_optimize::fig614;
using test_optimize::rest_to_rest;
using testing::HasSubstr;
using Status = OptimizeStatus;

bool same_knots(const CamSpec& a, const CamSpec& b) {
  const auto x = resolved_knots(a);
  const auto y = resolved_knots(b);
  bool same = x.size() == y.size();
  for (std::size_t i = 0; same && i < x.size(); ++i)
    same = x[i].master == y[i].master && x[i].slave == y[i].slave &&
           x[i].geo_velocity == y[i].geo_velocity && x[i].geo_acceleration == y[i].geo_acceleration;
  return same;
}

CamProblem all_of_knot_three() {
  using namespace test_optimize;
  CamProblem problem = fig614();
  problem.free = {{3, fig614_master, fig614_slave, fig614_velocity, fig614_acceleration}};
  return problem;
}

TEST(Outcome, IsDeterministic) {
  const CamProblem problem = all_of_knot_three();
  const Outcome<CamSpec> a = optimize(problem);
  const Outcome<CamSpec> b = optimize(problem);
  EXPECT_TRUE(same_knots(a.best, b.best));
  EXPECT_EQ(a.evaluations, b.evaluations);
  EXPECT_EQ(a.reason, b.reason);
}

TEST(Outcome, NamesTheBrokenLimitIfNothingIsFree) {
  CamProblem problem = all_of_knot_three();
  problem.limits.acceleration = 0.06;  // segment 1 has 0.0779
  const Outcome<CamSpec> outcome = optimize(problem);
  EXPECT_EQ(outcome.status, Status::infeasible);
  EXPECT_FALSE(outcome.usable());
  EXPECT_THAT(outcome.reason, HasSubstr("segment 1"));
  EXPECT_THAT(outcome.reason, HasSubstr("geo_acceleration is 0.0779245"));
  const Finding& worst = outcome.limits.findings.front();
  EXPECT_TRUE(worst.broken);
  EXPECT_EQ(worst.rule, "limit/geo_acceleration");
  EXPECT_EQ(worst.segment, 0U);
}

TEST(Outcome, ProvesThatNoLawCanKeepALimit) {
  // Rest to rest needs 4; the free knot cannot help.
  CamProblem problem = rest_to_rest({0.5}, Objective::peak_acceleration);
  problem.limits.acceleration = 3.9;
  Outcome<CamSpec> outcome = optimize(problem);
  EXPECT_EQ(outcome.status, Status::infeasible);
  EXPECT_THAT(outcome.reason, HasSubstr("no law"));
  EXPECT_THAT(outcome.reason, HasSubstr("at least 4 is needed, 3.9 allowed"));
  problem.limits = {{}, {}, {}, {}, 31};
  outcome = optimize(problem);
  EXPECT_THAT(outcome.reason, HasSubstr("at least 32 is needed, 31 allowed"));
}

TEST(Outcome, AnswersTheLeastViolatedCam) {
  // One knot in the middle with a free velocity alone; the least peak acceleration is about 5.76.
  CamProblem problem = rest_to_rest({0.5}, Objective::peak_jerk);
  problem.free = {{1, {}, {}, Bound{0, 4}, {}}};
  problem.minimize = {Objective::peak_acceleration};
  const double least = optimize(problem).figures.front().reached;
  problem.limits.acceleration = 5;
  problem.minimize = {Objective::peak_jerk};
  const Outcome<CamSpec> outcome = optimize(problem);
  EXPECT_EQ(outcome.status, Status::infeasible);
  EXPECT_THAT(outcome.reason, HasSubstr("convex"));
  EXPECT_NEAR(value_of(Objective::peak_acceleration, design(outcome.best).cam), least, 1e-6);
  EXPECT_NEAR(outcome.limits.findings.front().margin, 1 - least / 5, 1e-6);
}

TEST(Outcome, KeepsLimitsExactlyWhereTheyBind) {
  CamProblem problem = all_of_knot_three();
  problem.limits.velocity = 2.5;
  const Outcome<CamSpec> outcome = optimize(problem);
  EXPECT_EQ(outcome.status, Status::converged) << outcome.reason;
  EXPECT_TRUE(check(design(outcome.best).cam, problem.limits).ok());
  EXPECT_LE(std::abs(extrema(design(outcome.best).cam, 1).peak().value), 2.5 * (1 + 1e-12));
  const auto binds = [](const Finding& f) { return f.rule == "limit/geo_velocity"; };
  const auto it = std::find_if(outcome.active.begin(), outcome.active.end(), binds);
  ASSERT_NE(it, outcome.active.end());
  EXPECT_NEAR(it->value, -2.5, 2.5e-6);
  EXPECT_GE(it->segment, 2U);
}

TEST(Outcome, KeepsAPositionLimitOnWhichTheCamBeginsAndEnds) {
  CamProblem problem = all_of_knot_three();
  problem.limits.position_min = 0;
  problem.limits.position_max = 230;
  const Outcome<CamSpec> outcome = optimize(problem);
  EXPECT_TRUE(outcome.usable()) << outcome.reason;
  const Range travel = extrema(design(outcome.best).cam, 0);
  EXPECT_GE(travel.min.value, -1e-9);
  EXPECT_LE(travel.max.value, 230 * (1 + 1e-12));
}

TEST(Outcome, NamesActiveBounds) {
  CamProblem problem = rest_to_rest({0.5}, Objective::peak_jerk);
  problem.free = {{1, {}, {}, Bound{1.875, 1.95}, {}}};  // it would rather be 2
  const Outcome<CamSpec> outcome = optimize(problem);
  const auto is_bound = [](const Finding& f) { return f.rule == "bound/geo_velocity"; };
  const auto it = std::find_if(outcome.active.begin(), outcome.active.end(), is_bound);
  ASSERT_NE(it, outcome.active.end());
  EXPECT_EQ(it->quantity, "segment[1].free.geo_velocity");
  EXPECT_DOUBLE_EQ(it->value, 1.95);
}

TEST(Outcome, CanBeCancelledAtOnceAndLater) {
  const CamProblem problem = rest_to_rest({0.3, 0.6}, Objective::peak_acceleration);
  const Outcome<CamSpec> none = optimize(problem, [](const OptimizeProgress&) { return false; });
  EXPECT_EQ(none.status, Status::cancelled);
  EXPECT_TRUE(none.usable());
  EXPECT_TRUE(same_knots(none.best, problem.cam));
  EXPECT_EQ(none.figures[0].reached, none.figures[0].given);
  std::optional<double> best;
  const Outcome<CamSpec> some = optimize(problem, [&](const OptimizeProgress& progress) {
    if (progress.reached) best = progress.reached;
    return !best;
  });
  EXPECT_EQ(some.starts, 8) << "the number of starts of this optimizer";
  EXPECT_EQ(some.status, Status::cancelled);
  EXPECT_LT(some.figures[0].reached, some.figures[0].given);
  EXPECT_LE(some.figures[0].reached, *best);
}

TEST(Outcome, PassesOnTheCallersExceptions) {
  const CamProblem problem = rest_to_rest({0.5}, Objective::peak_jerk);
  EXPECT_THROW(
      optimize(problem, [](const OptimizeProgress&) -> bool { throw std::runtime_error("mine"); }),
      std::runtime_error);
}

TEST(Outcome, StallsWhenEvaluationsRunOut) {
  CamProblem problem = rest_to_rest({0.2, 0.4, 0.6, 0.8}, Objective::peak_acceleration);
  problem.options.budget.evaluations = 40;
  const Outcome<CamSpec> outcome = optimize(problem);
  EXPECT_EQ(outcome.status, Status::stalled);
  EXPECT_THAT(outcome.reason, HasSubstr("40 evaluations"));
  EXPECT_TRUE(outcome.usable());
  EXPECT_LE(outcome.figures[0].reached, outcome.figures[0].given);
  EXPECT_LE(outcome.evaluations, 60);  // the last linearized steps are few
}

/// Random cams of four quintics, free quantities and limits: every answer must be true.
TEST(Outcome, IsTrueForRandomProblems) {
  std::mt19937 random(2024);
  const auto draw = [&](double lo, double hi) {
    return lo + (hi - lo) * (static_cast<double>(random()) * 0x1p-32);
  };
  for (int i = 0; i < 60; ++i) {
    CamProblem problem;
    problem.cam.periodic = i % 2 == 0;
    problem.cam.start = {draw(-5, 5), 0, 0, 0};
    double master = problem.cam.start.master;
    for (std::size_t k = 1; k <= 4; ++k) {
      master += draw(0.5, 2);
      const double slave = k == 4 ? 0 : draw(-3, 3);
      const double v = k == 4 ? 0 : draw(-1, 1);
      problem.cam.segments.push_back({Law::quintic, {master, slave, v, 0}, ""});
      if (k == 4) break;
      FreeKnot knot{k, {}, {}, Bound{-4, 4}, Bound{-20, 20}};
      if (random() % 2 == 0) knot.master = Bound{master - 0.3, master + 0.3};
      if (random() % 2 == 0) knot.slave = Bound{slave - 0.5, slave + 0.5};
      if (random() % 3 > 0) problem.free.push_back(knot);
    }
    if (random() % 2 == 0) problem.free.push_back({0, {}, {}, {}, Bound{-10, 10}});
    if (problem.free.empty()) continue;
    const Cam given = design(problem.cam).cam;
    const Ranges range = extrema(given);
    if (i % 3 > 0) problem.limits.velocity = std::abs(range[1].peak().value) * draw(0.7, 1.1);
    if (i % 4 > 0) problem.limits.acceleration = std::abs(range[2].peak().value) * draw(0.5, 1.2);
    problem.minimize = {std::array{Objective::peak_acceleration, Objective::peak_jerk,
                                   Objective::rms_acceleration}[random() % 3]};
    problem.options.starts = 3;
    const Outcome<CamSpec> outcome = optimize(problem);
    const Cam best = design(outcome.best).cam;
    const FigureResult& r = outcome.figures.front();
    EXPECT_EQ(outcome.usable(), check(best, problem.limits).ok()) << i;
    EXPECT_EQ(outcome.usable(), outcome.status != Status::infeasible) << i << outcome.reason;
    EXPECT_EQ(r.reached, value_of(problem.minimize.front(), best)) << i;
    if (outcome.usable()) {
      EXPECT_GE(r.reached, *r.bound * (1 - 1e-12)) << i;
    }
    EXPECT_NE(outcome.status, Status::stalled) << i << ": " << outcome.reason;
    if (check(given, problem.limits).ok()) {
      EXPECT_TRUE(outcome.usable()) << i;
      EXPECT_LE(r.reached, r.given) << i;
    }
    for (const FreeKnot& free : problem.free) {
      const CamKnot& knot =
          free.knot == 0 ? outcome.best.start : outcome.best.segments[free.knot - 1].end;
      if (free.master) {
        EXPECT_GE(knot.master, free.master->lower);
        EXPECT_LE(knot.master, free.master->upper);
      }
      EXPECT_LE(std::abs(*knot.geo_acceleration), free.geo_acceleration->upper);
    }
  }
}

TEST(Outcome, RejectsBadInputOnly) {
  CamProblem problem = all_of_knot_three();
  problem.options.starts = 0;
  EXPECT_THROW(optimize(problem), InputError);
}

}  // namespace
}  // namespace jounce::outcome_test
