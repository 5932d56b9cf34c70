// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/optimize/cam_shape.hpp"

namespace jounce::pairs_test {
namespace {

using Status = OptimizeStatus;

std::vector<ShapeFigure> all_figures() {
  std::vector<ShapeFigure> all{ResidualOf{0.03, 0.03, 0.02, 0.02}, ResidualOf{0.03, 0.04, 0, 0.02}};
  for (int order = 1; order <= 4; ++order) {
    all.emplace_back(PeakOf{derivative_of_shape(order)});
    all.emplace_back(RmsOf{derivative_of_shape(order)});
  }
  return all;
}

CamShapeProblem rise(std::vector<ShapeFigure> figures) {
  CamShapeProblem problem;
  problem.cam.segments = {{Law::poly345, {120, 50}}};
  problem.shapes = {{0, 16}};
  for (ShapeFigure& figure : figures) problem.minimize.push_back({{std::move(figure), 1}});
  return problem;
}

/// The second figure is minimized among the shapes that have the first to the concession: it is as good
/// as that lets it, and the first within it.
TEST(LexicographicPairs, EndAtTheOptimum) {
  const std::vector<ShapeFigure> figures = all_figures();
  int stalled = 0;
  for (const ShapeFigure& first : figures) {
    const CamShapeOutcome alone = optimize_cam_shapes(rise({first}));
    ASSERT_TRUE(alone.usable()) << name(first) << ": " << alone.reason;
    const double least = alone.runs[0].shape.figures[0].reached;
    const double given = alone.runs[0].shape.figures[0].given;
    for (const ShapeFigure& second : figures) {
      if (name(first) == name(second)) continue;
      const CamShapeOutcome both = optimize_cam_shapes(rise({first, second}));
      const std::string what = name(first) + ", then " + name(second) + ": ";
      const bool ended = both.status == Status::optimal || both.status == Status::converged;
      stalled += !ended;
      EXPECT_TRUE(ended) << what << name(both.status) << ": " << both.reason;
      EXPECT_TRUE(both.usable()) << what << both.reason;
      EXPECT_FALSE(both.reason.empty()) << what;
      ASSERT_EQ(both.runs[0].shape.figures.size(), 2U) << what;
      EXPECT_EQ(both.runs[0].shape.figures[0].name, name(first)) << what;
      EXPECT_EQ(both.runs[0].shape.figures[1].name, name(second)) << what;
      EXPECT_LE(both.runs[0].shape.figures[0].reached, (least * 1.001 + 1e-6 * given) * (1 + 1e-5))
          << what;
      for (const FigureResult& f : both.runs[0].shape.figures)
        EXPECT_GE(f.reached, f.bound.value_or(0) * (1 - 1e-9)) << what << f.name;
    }
  }
  EXPECT_EQ(stalled, 0) << "of 88";
}

}  // namespace
}  // namespace jounce::pairs_test
