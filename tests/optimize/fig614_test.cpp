// SPDX-License-Identifier: Apache-2.0
// PMC600 manual 6.2, Fig. 6.14, under velocity <= 3 and acceleration <= 0.15, which the given cam
// breaks. The values pinned here as upper limits were measured; what must hold besides is proven.
#include <gtest/gtest.h>

#include "jounce/optimize/optimize.hpp"

#include "optimize/rest_to_rest.hpp"
#include "optimize/src/knots/bound.hpp"

namespace jounce::fig614_test {
namespace {

using namespace test_optimize;

constexpr double segment_one = 0.077924463939;  ///< peak acceleration of the fixed run up

void expect_sound(const CamProblem& problem, const Outcome<CamSpec>& outcome) {
  EXPECT_TRUE(outcome.usable()) << outcome.reason;
  const Cam cam = design(outcome.best).cam;
  EXPECT_TRUE(check(cam, problem.limits).ok());
  EXPECT_TRUE(check_continuity(cam, 2).ok());
  // The synchronous part stays exact: slope 1 all along.
  const Ranges synchronous = segment_extrema(cam, outcome.best.segments.size() - 3);
  EXPECT_NEAR(synchronous[1].min.value, 1, 1e-12);
  EXPECT_NEAR(synchronous[1].max.value, 1, 1e-12);
  for (std::size_t k = 0; k < problem.minimize.size(); ++k) {
    const FigureResult& r = outcome.figures[k];
    EXPECT_EQ(r.name, name(problem.minimize[k]));
    EXPECT_EQ(r.reached, value_of(problem.minimize[k], cam));
    EXPECT_GE(r.reached, *r.bound * (1 - 1e-12));
  }
}

TEST(Fig614, GivenCamBreaksTheLimits) {
  const CamProblem problem = fig614();
  EXPECT_EQ(check(design(problem.cam).cam, problem.limits).broken(), 2U);
}

TEST(Fig614, MasterAndVelocityOfTheReturnKnotBringThePeakDownToTheRunUps) {
  CamProblem problem = fig614();
  problem.free = {{3, fig614_master, {}, fig614_velocity, {}}};
  const Outcome<CamSpec> outcome = optimize(problem);
  expect_sound(problem, outcome);
  EXPECT_NEAR(outcome.figures[0].given, 0.1619234501, 1e-10);
  EXPECT_NEAR(outcome.figures[0].reached, segment_one, 2e-6 * segment_one);
  EXPECT_NEAR(*outcome.figures[0].bound, segment_one, 1e-12);
  EXPECT_LE(outcome.figures[2].reached, 0.038162);
}

TEST(Fig614, AllOfTheReturnKnot) {
  CamProblem problem = fig614();
  problem.free = {{3, fig614_master, fig614_slave, fig614_velocity, fig614_acceleration}};
  const Outcome<CamSpec> outcome = optimize(problem);
  expect_sound(problem, outcome);
  EXPECT_NEAR(outcome.figures[0].reached, segment_one, 2e-6 * segment_one);
  EXPECT_LE(outcome.figures[2].reached, 0.038106);
}

TEST(Fig614, WithTheAccelerationAtTheSeam) {
  CamProblem problem = fig614();
  problem.free = {{3, fig614_master, fig614_slave, fig614_velocity, fig614_acceleration},
                  {0, {}, {}, {}, fig614_acceleration}};
  const Outcome<CamSpec> outcome = optimize(problem);
  expect_sound(problem, outcome);
  EXPECT_EQ(outcome.status, OptimizeStatus::converged) << outcome.reason;
  EXPECT_LE(outcome.figures[0].reached, 0.070737);
  EXPECT_LE(outcome.figures[1].reached, 0.0059065);
  EXPECT_NEAR(*outcome.figures[0].bound, 25.0 / 510, 1e-15);
  EXPECT_EQ(outcome.best.start.geo_acceleration, outcome.best.segments.back().end.geo_acceleration);
}

TEST(Fig614, TheSeamMayBeNamedByEitherEnd) {
  CamProblem problem = fig614();
  problem.free = {{3, fig614_master, {}, fig614_velocity, {}},
                  {0, {}, {}, {}, fig614_acceleration}};
  const Outcome<CamSpec> by_start = optimize(problem);
  problem.free[1].knot = 4;
  const Outcome<CamSpec> by_last = optimize(problem);
  expect_sound(problem, by_last);
  EXPECT_NEAR(by_start.figures[0].reached, by_last.figures[0].reached,
              1e-6 * by_start.figures[0].reached);
}

TEST(Fig614, WithAKnotInTheRunUp) {
  CamProblem problem = fig614();
  const Jet middle = design(problem.cam).cam.jet(40);
  problem.cam.segments.insert(problem.cam.segments.begin(),
                              {Law::quintic, {40, middle[0], middle[1], middle[2]}, "lift"});
  problem.free = {{1, Bound{10, 65}, Bound{0, 100}, fig614_velocity, fig614_acceleration},
                  {4, fig614_master, fig614_slave, fig614_velocity, fig614_acceleration},
                  {0, {}, {}, {}, fig614_acceleration}};
  const Outcome<CamSpec> outcome = optimize(problem);
  expect_sound(problem, outcome);
  EXPECT_LE(outcome.figures[0].reached, 0.05879);
}

}  // namespace
}  // namespace jounce::fig614_test
