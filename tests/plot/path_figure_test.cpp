// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/path_figure.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jounce::path_figure_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

PathFigure corner() {
  return {.title = "a <path>",
          .x_label = "x [mm]",
          .y_label = "y [mm]",
          .speed_label = "speed [mm/s]",
          .x = {0, 50, 100, 100, 100},
          .y = {0, 0, 0, 50, 100},
          .speed = {0, 100, 0, 100, 0},
          .marks = {{100, 0, "line 3"}}};
}

TEST(PathFigure, DrawsOneElementForEachSpeed) {
  PathFigure figure = corner();
  EXPECT_EQ(count(svg(figure), "class=\"speed\""), 1U);  // each line has the mean 50
  figure.speed = {100, 100, 100, 0, 0};
  EXPECT_EQ(count(svg(figure), "class=\"speed\""), 3U);  // 100, 50 and 0
}

TEST(PathFigure, EscapesAndMarks) {
  const std::string picture = svg(corner());
  EXPECT_THAT(picture, HasSubstr("a &lt;path&gt;"));
  EXPECT_THAT(picture, HasSubstr(">line 3</text>"));
  EXPECT_THAT(picture, HasSubstr("speed [mm/s]"));
  EXPECT_THAT(picture, Not(HasSubstr("nan")));
}

PathFigure with_rapids() {
  PathFigure figure = corner();
  figure.x = {-900, 0, 100, 100, -900};
  figure.y = {-900, 0, 0, 100, -900};
  figure.speed = {100, 100, 100, 100, 100};
  figure.rapid = {false, true, false, false, true};
  figure.marks = {{-900, -900, "start"}, {100, 0, "line 3"}};
  return figure;
}

TEST(PathFigure, DrawsRapidsThinAndFramesTheOtherLines) {
  const std::string picture = svg(with_rapids());
  EXPECT_EQ(count(picture, "stroke=\"#9aa0a6\""), 2U) << "the rapids, and their key";
  EXPECT_THAT(picture, HasSubstr(">rapid</text>"));
  EXPECT_THAT(picture, Not(HasSubstr(">start</text>"))) << "outside the frame";
  EXPECT_THAT(picture, HasSubstr(">line 3</text>"));
  EXPECT_THAT(picture, HasSubstr(">100</text>"));
  EXPECT_THAT(picture, Not(HasSubstr("-500</text>")));
}

TEST(PathFigure, LabelsEveryRing) {
  PathFigure figure = corner();
  figure.marks.clear();
  for (int line = 1; line <= 5; ++line)
    figure.marks.push_back({50.0 + line, 0, "line " + std::to_string(line)});
  const std::string picture = svg(figure);
  for (const PathFigure::Mark& mark : figure.marks)
    EXPECT_THAT(picture, HasSubstr(">" + mark.text + "</text>"));
}

TEST(PathFigure, IsFiniteForALineAndAPoint) {
  PathFigure figure = corner();
  figure.y.assign(5, 3);
  EXPECT_THAT(svg(figure), Not(HasSubstr("nan")));
  figure.x.assign(5, 7);
  figure.speed.assign(5, 0);
  EXPECT_THAT(svg(figure), Not(HasSubstr("nan")));
  EXPECT_THAT(svg(figure), Not(HasSubstr("inf")));
}

}  // namespace
}  // namespace jounce::path_figure_test
