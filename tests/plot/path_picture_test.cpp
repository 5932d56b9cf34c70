// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/path_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/design/input.hpp"
#include "jounce/path/plan.hpp"
#include "jounce/spec/spec.hpp"

namespace jounce::path_picture_test {
namespace {

Spec spec_of(const std::string& commands) {
  const std::string axis = "limits = { velocity = 1000, acceleration = 5000, jerk = 100000 }\n";
  return parse_spec(
      "jounce = 1\nkind = \"path\"\nname = \"p\"\nunits = { position = \"mm\", time = \"s\" }\n"
      "[path]\nvelocity = 100\ncorner = { deviation = 0.5 }\n[[axis]]\nname = \"x\"\n" +
          axis + "[[axis]]\nname = \"y\"\n" + axis + commands,
      "p.toml");
}

std::vector<Input> program(const std::string& commands) {
  return inputs_of(spec_of(commands), "p.toml");
}

double size_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

/// The distance of a place from the lines of a figure.
double distance(const PathFigure& figure, double x, double y) {
  double least = HUGE_VAL;
  for (std::size_t i = 0; i + 1 < figure.x.size(); ++i) {
    const double dx = figure.x[i + 1] - figure.x[i];
    const double dy = figure.y[i + 1] - figure.y[i];
    const double square = dx * dx + dy * dy;
    const double along =
        square > 0 ? ((x - figure.x[i]) * dx + (y - figure.y[i]) * dy) / square : 0;
    const double t = std::clamp(along, 0.0, 1.0);
    least = std::min(least, std::hypot(x - figure.x[i] - t * dx, y - figure.y[i] - t * dy));
  }
  return least;
}

/// The greatest distance of the planned path from the lines, as a share of the size of the path.
double error_of(const PathFigure& figure, const Plan& plan) {
  constexpr int instants = 3000;
  const double size = std::max(size_of(figure.x), size_of(figure.y));
  std::vector<Motion> axes(plan.path().axes());
  double worst = 0;
  for (int k = 0; k <= instants; ++k) {
    plan.at(plan.duration() * k / instants, axes);
    worst = std::max(worst, distance(figure, axes[0].position, axes[1].position));
  }
  return worst / size;
}

/// The greatest change of the speed over a line that is long enough to be seen, as a share of the
/// greatest speed.
double step_of(const PathFigure& figure) {
  const double size = std::max(size_of(figure.x), size_of(figure.y));
  const double fastest = *std::max_element(figure.speed.begin(), figure.speed.end());
  double worst = 0;
  for (std::size_t i = 0; i + 1 < figure.x.size(); ++i)
    if (std::hypot(figure.x[i + 1] - figure.x[i], figure.y[i + 1] - figure.y[i]) > 0.001 * size)
      worst = std::max(worst, std::abs(figure.speed[i + 1] - figure.speed[i]) / fastest);
  return worst;
}

constexpr const char* curves =
    "[[command]]\ntype = \"line\"\nto = [50, 0]\n"
    "[[command]]\ntype = \"spline\"\n"
    "point = [ { to = [80, 30] }, { to = [60, 60] }, { to = [20, 50] } ]\n"
    "[[command]]\ntype = \"line\"\nto = [-40, -30]\n"
    "[[command]]\ntype = \"bspline\"\n"
    "point = [ { to = [-60, 0] }, { to = [-60, 60] }, { to = [-20, 70] } ]\n"
    "[[command]]\ntype = \"ellipse\"\ncenter = [-20, 50]\nratio = 0.5\nmajor = 90\n"
    "to = [-20, 30]\nrotation = \"counterclockwise\"\n"
    "[[command]]\ntype = \"arc\"\ncenter = [0, 30]\nto = [-20, 30]\n"
    "rotation = \"clockwise\"\nturns = 3\n";

TEST(PathPicture, DrawsCurvesWithinATenthOfAPixel) {
  const std::vector<Input> axes = program(curves);
  for (const PathFigure& figure : {path_figure(axes, "x,y"), *path_figure(axes.front())}) {
    EXPECT_LE(error_of(figure, *axes.front().plan), 1.2e-4);  // 0.1 px of 800
    EXPECT_LE(step_of(figure), 1.0 / 16);                     // one color
    EXPECT_LT(figure.x.size(), 4000U);
  }
}

TEST(PathPicture, DrawsTheMiddleOfALineWithoutPoints) {
  const std::vector<Input> axes = program("[[command]]\ntype = \"line\"\nto = [900, 300]\n");
  const PathFigure figure = path_figure(axes, "x,y");
  const auto cruises = std::count(figure.speed.begin(), figure.speed.end(), 100.0);
  EXPECT_LE(cruises, 4);  // the ends of the stretch at constant speed
  EXPECT_LE(error_of(figure, *axes.front().plan), 1e-12);
  EXPECT_LE(step_of(figure), 1.0 / 16);
}

// G0 at 1000 mm/s or less, G1 at 100 mm/s: only the G1 count for the scale.
TEST(PathPicture, MarksTheRapidsOfAProgram) {
  Spec spec = spec_of("");
  set_gcode(std::get<PathSpec>(spec.subject),
            "G21 G90 G61\nG0 X200 Y100\nG1 X210 F6000\nG1 Y120\nG0 X0 Y0\n", "p.ngc");
  const std::vector<Input> axes = inputs_of(spec, "p.toml");
  for (const PathFigure& figure : {path_figure(axes, "x,y"), *path_figure(axes.front())}) {
    ASSERT_EQ(figure.rapid.size(), figure.x.size());
    EXPECT_LE(*std::max_element(figure.speed.begin(), figure.speed.end()), 100 * (1 + 1e-9));
    for (std::size_t i = 1; i < figure.x.size(); ++i) {
      const double x = (figure.x[i - 1] + figure.x[i]) / 2;
      EXPECT_EQ(figure.rapid[i], x < 199.999 || figure.y[i] < figure.y[i - 1]) << i;
    }
  }
}

}  // namespace
}  // namespace jounce::path_picture_test
