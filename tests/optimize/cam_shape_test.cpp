// SPDX-License-Identifier: Apache-2.0
#include "jounce/optimize/cam_shape.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

namespace jounce::cam_shape_test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Up, dwell, down, dwell; degrees and millimeters.
CamSpec up_and_down(Law law) {
  CamSpec cam;
  cam.periodic = true;
  cam.segments = {{law, {100, 50}, "up"},
                  {Law::dwell, {180, 50}},
                  {law, {280, 0}, "down"},
                  {Law::dwell, {360, 0}}};
  return cam;
}

CamShapeProblem problem_of(CamSpec cam, std::vector<FreeShape> shapes, ShapeFigure figure) {
  CamShapeProblem problem;
  problem.cam = std::move(cam);
  problem.shapes = std::move(shapes);
  problem.minimize = {{{std::move(figure), 1}}};
  return problem;
}

PeakOf peak(int order) {
  return {derivative_of_shape(order)};
}
RmsOf rms(int order) {
  return {derivative_of_shape(order)};
}

double peak_of(const Cam& cam, int order, std::size_t first, std::size_t last) {
  return std::abs(segment_extrema(cam, first, last)[static_cast<std::size_t>(order)].peak().value);
}

/// The pieces of a segment of the spec.
std::pair<std::size_t, std::size_t> pieces_of(const CamDesign& made, std::size_t segment) {
  std::size_t first = 0;
  while (made.origin[first] != segment) ++first;
  std::size_t last = first;
  while (last + 1 < made.origin.size() && made.origin[last + 1] == segment) ++last;
  return {first, last};
}

void expect_same(const Segment& a, const Segment& b) {
  EXPECT_EQ(a.length, b.length);
  EXPECT_EQ(a.c, b.c);
}

TEST(CamShapes, WhatIsDesignedIsWhatWasReached) {
  const auto outcome =
      optimize_cam_shapes(problem_of(up_and_down(Law::modified_sine), {{0, 30}}, peak(3)));
  ASSERT_TRUE(outcome.usable()) << outcome.reason;
  ASSERT_EQ(outcome.runs.size(), 1U);
  const CamDesign made = design(outcome.best);
  const auto [first, last] = pieces_of(made, 0);
  const FigureResult& jerk = outcome.runs[0].shape.figures[0];
  // The joints of the spline are true to 1e-12 of the stroke: over pieces of 1/30 that is 1e-7 of jerk.
  EXPECT_NEAR(peak_of(made.cam, 3, first, last), jerk.reached, 1e-7 * jerk.reached);
  EXPECT_GE(jerk.reached, 32 * 50 / 1e6 * (1 - 1e-9)) << "the perfect spline";
  EXPECT_LE(jerk.reached, 32 * 50 / 1e6 * 1.06) << "30 pieces come close";
  EXPECT_LT(jerk.reached, jerk.given);
}

TEST(CamShapes, PointsAreTheShapeToRounding) {
  for (const int continuity : {2, 3, 4, 5, 6}) {
    const auto outcome =
        optimize_cam_shapes(problem_of(up_and_down(Law::nonic), {{0, 20, continuity}}, rms(3)));
    ASSERT_TRUE(outcome.usable()) << continuity << ": " << outcome.reason;
    const Trajectory shape(outcome.runs[0].shape.best, 0);
    const Cam cam = design(outcome.best).cam;
    for (double x = 0; x < 100; x += 0.7) {
      const Jet wanted = shape.jet(x);
      const Jet found = cam.jet(x);
      EXPECT_NEAR(found[0], wanted[0], 1e-12 * 50) << continuity << " at " << x;
      EXPECT_NEAR(found[1], wanted[1], 1e-11 * 1) << continuity << " at " << x;
      EXPECT_NEAR(found[2], wanted[2], 1e-10 * 0.03) << continuity << " at " << x;
      EXPECT_NEAR(found[3], wanted[3], 1e-8 * 0.003) << continuity << " at " << x;
    }
  }
}

TEST(CamShapes, EverythingElseStaysExactly) {
  const CamSpec given = up_and_down(Law::modified_sine);
  const auto outcome = optimize_cam_shapes(problem_of(given, {{2, 24}}, rms(2)));
  ASSERT_TRUE(outcome.usable()) << outcome.reason;
  const CamDesign before = design(given);
  const CamDesign after = design(outcome.best);
  for (const std::size_t segment : {0U, 1U, 3U}) {
    const auto [first, last] = pieces_of(before, segment);
    const auto [from, to] = pieces_of(after, segment);
    ASSERT_EQ(last - first, to - from);
    for (std::size_t i = 0; i <= last - first; ++i)
      expect_same(before.cam.segments()[first + i], after.cam.segments()[from + i]);
  }
  EXPECT_TRUE(check_continuity(after.cam, 2).ok());
  EXPECT_NEAR(outcome.runs[0].shape.figures[0].reached, 0.0,
              outcome.runs[0].shape.figures[0].given);
}

TEST(CamShapes, TwoRunsAreOptimizedEachForItself) {
  CamSpec cam = up_and_down(Law::modified_sine);
  cam.segments[2].end.master = 300;
  const auto outcome = optimize_cam_shapes(problem_of(cam, {{0, 20}, {2, 20}}, rms(2)));
  ASSERT_EQ(outcome.runs.size(), 2U);
  EXPECT_EQ(outcome.runs[0].segments, std::vector<std::size_t>{0});
  EXPECT_EQ(outcome.runs[1].segments, std::vector<std::size_t>{2});
  // The second has 1.2 times the master for the same stroke.
  EXPECT_NEAR(outcome.runs[0].shape.figures[0].reached / outcome.runs[1].shape.figures[0].reached,
              1.44, 1e-4);
}

/// Down and up again over the seam, free between the dwell at the top and itself.
CamShapeProblem over_the_seam() {
  CamSpec cam;
  cam.periodic = true;
  cam.segments = {{Law::modified_sine, {100, 50}},
                  {Law::dwell, {160, 50}},
                  {Law::modified_sine, {260, 0}},
                  {Law::dwell, {360, 0}}};
  CamShapeProblem problem = problem_of(cam, {{0, 20}, {2, 20}, {3, 20}}, rms(2));
  for (const std::size_t knot : {3U, 4U}) {
    FreeKnot free;
    free.knot = knot;
    free.slave = Bound{-10, 20};
    free.geo_velocity = Bound{-infinite, infinite};
    free.geo_acceleration = Bound{-infinite, infinite};
    problem.knots.push_back(free);
  }
  return problem;
}

TEST(CamShapes, OneRunPassesTheSeam) {
  const auto outcome = optimize_cam_shapes(over_the_seam());
  ASSERT_TRUE(outcome.usable()) << outcome.reason;
  ASSERT_EQ(outcome.runs.size(), 1U);
  EXPECT_EQ(outcome.runs[0].segments, (std::vector<std::size_t>{2, 3, 0}));
  EXPECT_NE(outcome.best.start.slave, 0);
  EXPECT_NEAR(outcome.best.start.slave, outcome.best.segments[3].end.slave, 1e-12);
  EXPECT_LE(outcome.best.start.slave, 20);
  EXPECT_GE(outcome.best.segments[2].end.slave, -10);
  const Cam cam = design(outcome.best).cam;
  EXPECT_TRUE(check_continuity(cam, 2).ok());
  const double jerk = std::abs(extrema(cam, 3).peak().value);
  EXPECT_NEAR(cam.jet(0)[3], cam.jet(360, Side::left)[3], 1e-6 * jerk) << "one spline";
}

TEST(CamShapes, CorridorsAreCutAtTheSeam) {
  CamShapeProblem problem = over_the_seam();
  const LinearQuantity slave = derivative_of_shape(0);
  problem.corridors = {{slave, 300, 360, {}, Edge{8, 5}}, {slave, 0, 30, {}, Edge{5, 15}}};
  const auto outcome = optimize_cam_shapes(problem);
  ASSERT_TRUE(outcome.usable()) << outcome.reason;
  const Cam cam = design(outcome.best).cam;
  for (double x = 300; x <= 360; x += 1)
    EXPECT_LE(cam.jet(x)[0], 8 - 3 * (x - 300) / 60 + 1e-9) << x;
  for (double x = 0; x <= 30; x += 1) EXPECT_LE(cam.jet(x)[0], 5 + x / 3 + 1e-9) << x;
  problem.corridors = {{slave, 110, 150, {}, Edge{8, 5}}};
  EXPECT_THROW((void)optimize_cam_shapes(problem), InputError) << "in the dwell";
}

TEST(CamShapes, ARotarySlaveAdvancesOverTheSeam) {
  CamSpec cam;
  cam.periodic = true;
  cam.slave_period = 360;
  cam.segments = {{Law::quintic, {100, 120}}, {Law::line, {200, 220}}, {Law::quintic, {360, 360}}};
  CamShapeProblem problem = problem_of(cam, {{0, 20}, {2, 20}}, rms(2));
  FreeKnot seam;
  seam.knot = 3;
  seam.geo_velocity = Bound{-infinite, infinite};
  seam.geo_acceleration = Bound{-infinite, infinite};
  problem.knots = {seam};
  problem.limits.velocity = 1.5;
  const auto outcome = optimize_cam_shapes(problem);
  ASSERT_TRUE(outcome.usable()) << outcome.reason;
  const Cam made = design(outcome.best).cam;
  EXPECT_NEAR(made.jet(360, Side::left)[0] - made.jet(0)[0], 360, 1e-10);
  EXPECT_TRUE(check_continuity(made, 2).ok());
  EXPECT_LE(std::abs(extrema(made, 1).peak().value), 1.5 * (1 + 1e-12));
  EXPECT_GT(made.jet(0)[1], 0.1) << "it does not stop at the seam";
}

TEST(CamShapes, AllOfAPeriodicCamIsOneClosedRun) {
  CamSpec cam;
  cam.periodic = true;
  cam.segments = {{Law::modified_sine, {180, 50}}, {Law::modified_sine, {360, 0}}};
  CamShapeProblem problem = problem_of(cam, {{0, 30}, {1, 30}}, rms(2));
  for (const std::size_t knot : {0U, 1U}) {
    FreeKnot free;
    free.knot = knot;
    free.geo_velocity = Bound{-infinite, infinite};
    free.geo_acceleration = Bound{-infinite, infinite};
    problem.knots.push_back(free);
  }
  const auto outcome = optimize_cam_shapes(problem);
  ASSERT_TRUE(outcome.usable()) << outcome.reason;
  // Given two heights half a turn apart, the cubic spline has the least rms: sqrt(12) h / L^2, its
  // slopes 0 at both by symmetry.
  EXPECT_NEAR(outcome.runs[0].shape.figures[0].reached, std::sqrt(12.) * 50 / (180. * 180),
              1e-4 * outcome.runs[0].shape.figures[0].reached);
  EXPECT_TRUE(check_continuity(design(outcome.best).cam, 3, 1e-6).ok());
}

TEST(CamShapes, AJerkThatDidNotStepStillDoesNot) {
  for (const Law law : {Law::poly4567, Law::modified_sine}) {
    const auto outcome = optimize_cam_shapes(problem_of(up_and_down(law), {{0, 30}}, rms(3)));
    ASSERT_TRUE(outcome.usable()) << outcome.reason;
    const CamDesign made = design(outcome.best);
    const double jerk = std::abs(extrema(made.cam, 3).peak().value);
    const double step = std::abs(made.cam.jet(0)[3]);
    if (law == Law::poly4567)
      EXPECT_LT(step, 1e-7 * jerk);
    else
      EXPECT_GT(step, 0.5 * jerk) << "a 345 has the least rms of the jerk";
  }
}

TEST(CamShapes, MonotoneShapesNeverTurnBack) {
  CamShapeProblem problem = problem_of(up_and_down(Law::modified_sine), {{0, 30}}, rms(2));
  // To be nearly there at half the way makes the best shape swing over.
  problem.corridors = {{derivative_of_shape(0), 50, 50, Edge{49, 49}, {}}};
  const auto free = optimize_cam_shapes(problem);
  ASSERT_TRUE(free.usable());
  EXPECT_GT(extrema(design(free.best).cam, 0).max.value, 50.5);
  problem.shapes[0].monotone = true;
  const auto monotone = optimize_cam_shapes(problem);
  ASSERT_TRUE(monotone.usable()) << monotone.reason;
  const CamDesign made = design(monotone.best);
  const auto [first, last] = pieces_of(made, 0);
  EXPECT_GE(segment_extrema(made.cam, first, last)[1].min.value, -1e-9);
  EXPECT_GE(monotone.runs[0].shape.figures[0].reached, free.runs[0].shape.figures[0].reached);
}

TEST(CamShapes, LaterFiguresKeepEarlierOnes) {
  CamShapeProblem problem = problem_of(up_and_down(Law::modified_sine), {{0, 30}}, rms(2));
  const auto alone = optimize_cam_shapes(problem);
  problem.minimize.push_back({{peak(3), 1}});
  problem.concession = 0.02;
  const auto both = optimize_cam_shapes(problem);
  ASSERT_TRUE(both.usable()) << both.reason;
  ASSERT_EQ(both.runs[0].shape.figures.size(), 2U);
  const double least = alone.runs[0].shape.figures[0].reached;
  EXPECT_LE(both.runs[0].shape.figures[0].reached,
            least * 1.02 + 2e-6 * alone.runs[0].shape.figures[0].given);
  EXPECT_GE(both.runs[0].shape.figures[0].reached, least * (1 - 1e-6));
  EXPECT_LT(both.runs[0].shape.figures[1].reached,
            std::abs(extrema(design(alone.best).cam, 3).peak().value));
}

TEST(CamShapes, LimitsHoldAsDesigned) {
  CamShapeProblem problem = problem_of(up_and_down(Law::modified_sine), {{0, 40}}, peak(3));
  problem.limits = {
      .position_min = {}, .position_max = {}, .velocity = 0.8, .acceleration = 0.026, .jerk = {}};
  problem.limits.velocity = 0.9;
  const auto outcome = optimize_cam_shapes(problem);
  ASSERT_EQ(outcome.runs.size(), 1U);
  // The descent is fixed and breaks them: the outcome reports this.
  EXPECT_FALSE(outcome.usable());
  for (const Finding& finding : outcome.limits.findings)
    if (finding.broken) {
      EXPECT_EQ(finding.segment, 2U);
    }
  problem.shapes.push_back({2, 40});
  const auto all = optimize_cam_shapes(problem);
  EXPECT_TRUE(all.usable()) << all.reason;
  EXPECT_TRUE(check(design(all.best).cam, problem.limits).ok());
}

TEST(CamShapes, ALimitOfTheJerkHoldsAsDesigned) {
  CamShapeProblem problem = problem_of(up_and_down(Law::poly345), {{0, 40}, {2, 40}}, peak(2));
  problem.limits.jerk = 40 * 50 / 1e6;  // between the least, 32, and that of the 345, 60
  const auto outcome = optimize_cam_shapes(problem);
  ASSERT_TRUE(outcome.usable()) << outcome.reason;
  const Cam cam = design(outcome.best).cam;
  EXPECT_TRUE(check(cam, problem.limits).ok());
  const double jerk = std::abs(extrema(cam, 3).peak().value);
  EXPECT_GT(jerk, 0.9999 * *problem.limits.jerk) << "and it is used";
}

TEST(CamShapes, StopsWithTheBestSoFar) {
  CamShapeProblem problem =
      problem_of(up_and_down(Law::modified_sine), {{0, 40}, {2, 40}}, peak(2));
  int calls = 0;
  const auto outcome = optimize_cam_shapes(problem, [&](const OptimizeProgress& p) {
    EXPECT_EQ(p.runs, 2U);
    ++calls;
    return false;
  });
  EXPECT_GE(calls, 2) << "both runs are asked for what they have";
  EXPECT_EQ(outcome.status, OptimizeStatus::cancelled);
  EXPECT_EQ(outcome.runs.size(), 2U);
}

TEST(CamShapes, RejectWhatCannotBe) {
  const auto complaint = [](const CamShapeProblem& problem) -> std::string {
    try {
      require_valid(problem);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  const CamShapeProblem good = problem_of(up_and_down(Law::modified_sine), {{0}}, rms(2));
  EXPECT_EQ(complaint(good), "no error");
  CamShapeProblem bad = good;
  bad.shapes.clear();
  EXPECT_EQ(complaint(bad), "shapes: are missing: free at least one segment");
  bad = good;
  bad.shapes = {{7}};
  EXPECT_EQ(complaint(bad), "segment[8].free.shape = 100: is not the number of a segment");
  bad = good;
  bad.minimize.clear();
  EXPECT_EQ(complaint(bad), "minimize: must name at least one figure");
  bad = good;
  bad.shapes = {{1, 10, 4, true}};
  EXPECT_EQ(complaint(bad), "segment[2].free.monotone = true: needs a segment with a stroke");
  bad = good;
  bad.limits.velocity = -1;
  EXPECT_NE(complaint(bad), "no error");
}

}  // namespace
}  // namespace jounce::cam_shape_test
