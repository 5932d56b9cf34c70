// SPDX-License-Identifier: Apache-2.0
#include "plot/src/figure/path.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "plot/markup.hpp"

namespace jounce::path_test {
namespace {

double distance(Pixel p, const std::vector<Pixel>& line) {
  double least = std::hypot(p.x - line[0].x, p.y - line[0].y);
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double dx = line[i].x - line[i - 1].x;
    const double dy = line[i].y - line[i - 1].y;
    const double along = (p.x - line[i - 1].x) * dx + (p.y - line[i - 1].y) * dy;
    const double t = std::clamp(along / std::max(dx * dx + dy * dy, 1e-30), 0.0, 1.0);
    least = std::min(least, std::hypot(p.x - line[i - 1].x - t * dx, p.y - line[i - 1].y - t * dy));
  }
  return least;
}

TEST(Coordinate, HasTwoDecimalsAtMost) {
  EXPECT_EQ(coordinate(0), "0");
  EXPECT_EQ(coordinate(-0.001), "0");
  EXPECT_EQ(coordinate(12.5), "12.5");
  EXPECT_EQ(coordinate(-0.25), "-.25");
  EXPECT_EQ(coordinate(0.05), ".05");
  EXPECT_EQ(coordinate(100), "100");
  EXPECT_EQ(coordinate(99.999), "100");
}

TEST(PathData, IsRelativeAndShort) {
  const std::vector<Pixel> line{{10, 20}, {11.5, 18}, {13, 18.25}, {13, 30}, {13, 40}, {20, 40}};
  EXPECT_EQ(path_data(line), "M10 20l1.5-2 1.5 .25v11.75 10h7");
}

TEST(PathData, MakesADotOfASinglePoint) {
  EXPECT_EQ(path_data(std::vector<Pixel>{{1, 2}, {1.001, 2}}), "M1 2h0");
  EXPECT_EQ(path_data({}), "");
}

TEST(PathData, DoesNotAccumulateRounding) {
  std::vector<Pixel> line;
  for (int i = 0; i < 3000; ++i) line.push_back({i / 3.0, 50 + 40 * std::sin(i / 70.0)});
  const auto read = lines_of(path_data(line));
  ASSERT_EQ(read.size(), 1U);
  ASSERT_EQ(read[0].size(), line.size());
  for (std::size_t i = 0; i < line.size(); ++i) {
    ASSERT_NEAR(read[0][i].x, line[i].x, 0.0051);
    ASSERT_NEAR(read[0][i].y, line[i].y, 0.0051);
  }
}

TEST(Thinned, StaysWithinATenthOfAPixel) {
  std::vector<Pixel> line;
  for (int i = 0; i <= 1600; ++i) line.push_back({i / 2.0, 60 + 50 * std::sin(i / 60.0)});
  const auto thin = thinned(line);
  EXPECT_LT(thin.size(), line.size() / 5);
  for (const Pixel& p : line) ASSERT_LE(distance(p, thin), 0.1 + 1e-12);
}

TEST(Thinned, KeepsEveryPeakOfADenseTrace) {
  std::vector<Pixel> line;
  for (int i = 0; i < 1'000'000; ++i)
    line.push_back({i * 800.0 / 1e6, i == 654'321 ? 0.0 : 60 + 20 * std::sin(i * 1.7)});
  const auto thin = thinned(line);
  EXPECT_LE(thin.size(), 4U * 2 * 801);
  const auto peak = std::min_element(thin.begin(), thin.end(),
                                     [](const Pixel& a, const Pixel& b) { return a.y < b.y; });
  EXPECT_EQ(peak->y, 0);
  EXPECT_EQ(peak->x, line[654'321].x);
}

TEST(Thinned, KeepsJumpsVertical) {
  const std::vector<Pixel> step{{0, 10}, {5, 10}, {10, 10}, {10, 50}, {15, 50}, {20, 50}};
  EXPECT_EQ(path_data(thinned(step)), "M0 10h10v40h10");
}

TEST(Thinned, KeepsAClosedLine) {
  const std::vector<Pixel> square{{0, 0}, {9, 0}, {9, 9}, {0, 9}, {0, 0}};
  EXPECT_EQ(path_data(thinned(square)), "M0 0h9v9h-9v-9");
}

}  // namespace
}  // namespace jounce::path_test
