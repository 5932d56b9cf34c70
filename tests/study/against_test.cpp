// SPDX-License-Identifier: Apache-2.0
#include "study/src/tune/against.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/validate/linear_drive.hpp"

namespace jounce::against_test {
namespace {

/// An index of 120 deg in 0.15 s between two dwells.
CamShapeProblem index_problem(DriveFigure figure) {
  CamShapeProblem problem;
  problem.cam.segments = {
      {Law::dwell, {30, 0}}, {Law::modified_sine, {210, 120}, "index"}, {Law::dwell, {240, 120}}};
  problem.shapes = {{.segment = 1, .pieces = 30}};
  problem.minimize = {{{asked(figure)}}};
  return problem;
}

Against axis() {
  Against against{.drive = servo_400w(), .velocity = 1200, .settle = 0.1};
  against.drive.position_per_rev = 360;
  return against;
}

/// A motor alone with no friction, whose torque is fed forward: T = J theta'' exactly.
Against rigid() {
  Against against = axis();
  against.drive = Drive{};
  against.drive.motor.inertia = 1e-4;
  against.drive.motor.torque_limit = 100;
  against.drive.controller = {.position_gain = 40, .velocity_gain = 0.05};
  against.drive.position_per_rev = 360;
  return against;
}

/// The peak of a figure over the whole motion.
double exact_peak(const CamSpec& cam, const Against& against, DriveFigure figure) {
  const CamDesign made = design(cam);
  std::vector<Segment> segments;
  for (Segment segment : made.cam.segments()) {
    segment.length /= against.velocity;
    segments.push_back(segment);
  }
  const DriveResult run =
      exact_through(Trajectory(segments), against.drive, {.settle = against.settle}).value();
  return std::abs(figure == DriveFigure::torque ? run.torque.value : run.following_error.value);
}

double rms_acceleration_torque() {  // least rms: theta'' is a straight line, sqrt(12) h / t^2
  const double h = 2 * M_PI / 3;
  const double t = 180.0 / 1200;
  return 1e-4 * std::sqrt(12.0) * h / (t * t) * std::sqrt(180.0 / 240);
}

TEST(Against, RigidDriveHasTheRmsTorqueOfTheParabolaOfVelocity) {
  CamShapeProblem problem = index_problem(DriveFigure::rms_torque);
  problem.shapes = {{.segment = 1, .pieces = 100, .continuity = 2}};
  const AgainstOutcome outcome = optimize_against(problem, rigid());
  ASSERT_TRUE(outcome.usable()) << outcome.reason;
  const double least = rms_acceleration_torque();
  EXPECT_GE(outcome.driven_best.rms_torque, least * (1 - 1e-6)) << "below what any motion needs";
  EXPECT_LE(outcome.driven_best.rms_torque, least * 1.03) << "acceleration is 0 at both ends";
  EXPECT_EQ(outcome.rounds, 1);
}

TEST(Against, WhatIsReachedIsWhatIsIntegrated) {
  for (const DriveFigure figure : {DriveFigure::torque, DriveFigure::rms_torque}) {
    SCOPED_TRACE(name(figure));
    const AgainstOutcome outcome = optimize_against(index_problem(figure), axis());
    ASSERT_TRUE(outcome.usable()) << outcome.reason;
    ASSERT_EQ(outcome.driven_figures.size(), 1U);
    const FigureResult& f = outcome.driven_figures.front();
    const FigureResult& modelled = outcome.runs.front().shape.figures.front();
    EXPECT_LT(f.reached, 0.95 * f.given);
    EXPECT_NEAR(modelled.given, f.given, 2e-3 * f.given) << "between its instants";
    EXPECT_NEAR(modelled.reached, f.reached, 2e-3 * f.given);
  }
}

class AgainstPeaks : public ::testing::TestWithParam<DriveFigure> {};

/// A fast index: 500 instants are 0.5 ms apart, and the response has poles of 2 ms. exact_through()
/// isolates the peaks of the whole motion.
TEST_P(AgainstPeaks, BetweenTheInstantsCount) {
  const DriveFigure figure = GetParam();
  const CamShapeProblem problem = index_problem(figure);
  const Against against = axis();
  const AgainstOutcome outcome = optimize_against(problem, against);
  ASSERT_TRUE(outcome.usable()) << outcome.reason;
  const FigureResult& modelled = outcome.runs.front().shape.figures.front();
  const double exact = exact_peak(outcome.best, against, figure);
  EXPECT_NEAR(modelled.reached, exact, 2e-6 * exact);
  const ShapeOutcome& shape = outcome.runs.front().shape;
  ASSERT_TRUE(shape.bound);
  EXPECT_LE(exact / modelled.given, *shape.bound * (1 + 1e-5))
      << "no spline over these knots has a lower peak anywhere";
}

INSTANTIATE_TEST_SUITE_P(Of, AgainstPeaks,
                         ::testing::Values(DriveFigure::torque, DriveFigure::following_error),
                         [](const auto& param) {
                           return param.param == DriveFigure::torque ? "Torque" : "FollowingError";
                         });

TEST(Against, WhatCanBeNothingIsNothingAndTheCamStaysGentle) {
  for (const DriveFigure figure : {DriveFigure::residual, DriveFigure::end_following_error}) {
    SCOPED_TRACE(name(figure));
    const AgainstOutcome outcome = optimize_against(index_problem(figure), axis());
    ASSERT_TRUE(outcome.usable()) << outcome.reason;
    EXPECT_EQ(outcome.status, OptimizeStatus::optimal) << outcome.reason;
    EXPECT_LE(outcome.driven_figures[0].reached, 1e-9 * 120) << "of the stroke, by integration";
    EXPECT_LE(outcome.driven_best.rms_torque, 5 * outcome.driven_given.rms_torque)
        << "one of many shapes, and not a wild one";
  }
}

TEST(Against, LeastFollowingErrorIsProven) {
  const AgainstOutcome outcome =
      optimize_against(index_problem(DriveFigure::following_error), axis());
  ASSERT_TRUE(outcome.usable()) << outcome.reason;
  EXPECT_NE(outcome.status, OptimizeStatus::stalled) << outcome.reason;
  const ShapeOutcome& shape = outcome.runs.front().shape;
  ASSERT_TRUE(shape.bound);
  EXPECT_GE(*shape.bound, shape.value * (1 - 1e-4));
  EXPECT_LT(outcome.driven_figures[0].reached, 0.7 * outcome.driven_figures[0].given);
}

TEST(Against, NarrowCeilingsBesideAnRmsAreKeptByIntegration) {
  CamShapeProblem problem = index_problem(DriveFigure::rms_torque);
  problem.shapes.front().pieces = 20;
  const double given = std::abs(optimize_against(problem, axis()).driven_given.residual.value);
  double before = 0;
  for (const double share : {1e-2, 1e-5}) {
    SCOPED_TRACE(share);
    problem.ceilings = {{asked(DriveFigure::residual), share * given}};
    const AgainstOutcome outcome = optimize_against(problem, axis());
    ASSERT_TRUE(outcome.usable()) << outcome.reason;
    EXPECT_NE(outcome.status, OptimizeStatus::stalled) << outcome.reason;
    EXPECT_LE(std::abs(outcome.driven_best.residual.value), share * given * (1 + 1e-6));
    EXPECT_GE(outcome.driven_best.rms_torque, before) << "less allowed, no less needed";
    before = outcome.driven_best.rms_torque;
  }
}

TEST(Against, WhatComesSecondIsMinimisedBesideWhatIsNothing) {
  CamShapeProblem problem = index_problem(DriveFigure::residual);
  problem.shapes.front().pieces = 20;
  const AgainstOutcome alone = optimize_against(problem, axis());
  problem.minimize.push_back({{asked(DriveFigure::rms_torque)}});
  const AgainstOutcome both = optimize_against(problem, axis());
  ASSERT_TRUE(both.usable()) << both.reason;
  EXPECT_LE(both.driven_figures[0].reached, 1e-9 * 120);
  EXPECT_LT(both.driven_best.rms_torque, alone.driven_best.rms_torque);
}

TEST(Against, CeilingsOfTheDriveHoldByIntegration) {
  CamShapeProblem problem = index_problem(DriveFigure::rms_torque);
  const AgainstOutcome free = optimize_against(problem, axis());
  ASSERT_TRUE(free.usable());
  const double most = 0.9 * std::abs(free.driven_best.torque.value);
  problem.ceilings = {{asked(DriveFigure::torque), most}};
  const AgainstOutcome limited = optimize_against(problem, axis());
  ASSERT_TRUE(limited.usable()) << limited.reason;
  EXPECT_LE(std::abs(limited.driven_best.torque.value), most * (1 + 1e-6));
  EXPECT_GE(limited.driven_best.rms_torque, free.driven_best.rms_torque * (1 - 1e-4));
}

TEST(Against, DriveWithDryFrictionDoesBetterByItsOwnRuns) {
  Against against = axis();
  against.drive.train.front().friction.coulomb = 0.15;
  ASSERT_TRUE(nonlinearity(against.drive));
  const AgainstOutcome outcome = optimize_against(index_problem(DriveFigure::rms_torque), against);
  ASSERT_TRUE(outcome.usable()) << outcome.reason;
  EXPECT_LT(outcome.driven_best.rms_torque, outcome.driven_given.rms_torque);
  EXPECT_NE(outcome.status, OptimizeStatus::optimal) << "nothing is proven";
  EXPECT_FALSE(outcome.runs.front().shape.bound);
}

TEST(Against, AnArmIsMovedWithItsWeightInMind) {
  Against against = axis();
  against.drive.train.front().gravity_torque = 0.3;  // more than what accelerates
  const AgainstOutcome outcome = optimize_against(index_problem(DriveFigure::rms_torque), against);
  ASSERT_TRUE(outcome.usable()) << outcome.reason;
  EXPECT_LT(outcome.driven_best.rms_torque, 0.85 * outcome.driven_given.rms_torque);
}

TEST(Against, AGivenCamThatBreaksACeilingIsImprovedOnByOneThatKeepsIt) {
  CamShapeProblem problem = index_problem(DriveFigure::rms_torque);
  problem.shapes.front().pieces = 20;
  problem.ceilings = {{asked(DriveFigure::residual), 5e-3}};
  const AgainstOutcome outcome = optimize_against(problem, axis());
  ASSERT_GT(std::abs(outcome.driven_given.residual.value), 5e-3);
  EXPECT_TRUE(outcome.usable()) << outcome.reason;
  EXPECT_GT(outcome.driven_best.rms_torque, outcome.driven_given.rms_torque) << "it has its price";
}

TEST(Against, ACamThatTurnsForEverIsOptimizedInItsSteadyState) {
  // The rest after the index is too short for the loops to calm down: once from rest is another matter.
  Against once = axis();
  once.velocity = 4800;
  Against forever = once;
  forever.periodic = true;
  CamShapeProblem problem = index_problem(DriveFigure::rms_torque);
  problem.cam.segments.push_back({Law::poly345, {360, 0}, "back"});
  problem.shapes.front().pieces = 15;
  const AgainstOutcome outcome = optimize_against(problem, forever);
  ASSERT_TRUE(outcome.usable()) << outcome.reason;
  const FigureResult& f = outcome.driven_figures.front();
  EXPECT_LT(f.reached, 0.98 * f.given);
  EXPECT_NEAR(outcome.runs.front().shape.figures.front().reached, f.reached, 5e-3 * f.given);
  const AgainstOutcome other = optimize_against(problem, once);
  EXPECT_GT(std::abs(other.driven_given.rms_torque - outcome.driven_given.rms_torque),
            1e-3 * outcome.driven_given.rms_torque);
}

TEST(Against, RejectsWhatItCannotDo) {
  CamShapeProblem none = index_problem(DriveFigure::torque);
  none.minimize = {{{PeakOf{derivative_of_shape(2)}}}};
  EXPECT_THROW(optimize_against(none, axis()), InputError);
  CamShapeProblem apart = index_problem(DriveFigure::torque);
  apart.shapes = {{.segment = 0}, {.segment = 2}};
  EXPECT_THROW(optimize_against(apart, axis()), InputError);
  Against forever = axis();
  forever.periodic = true;
  EXPECT_THROW(optimize_against(index_problem(DriveFigure::residual), forever), InputError);
  forever.drive.motor.friction.coulomb = 0.1;
  EXPECT_THROW(optimize_against(index_problem(DriveFigure::torque), forever), InputError);
  Against still = axis();
  still.velocity = 0;
  EXPECT_THROW(optimize_against(index_problem(DriveFigure::torque), still), InputError);
}

}  // namespace
}  // namespace jounce::against_test
