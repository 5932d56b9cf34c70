// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/figure.hpp"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/plot/sweep_figure.hpp"

#include "plot/markup.hpp"
#include "plot/samples.hpp"
#include "plot/src/figure/panel.hpp"
#include "plot/src/figure/text.hpp"

namespace jounce::figure_test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Figure with(Series series) {
  Figure figure{.title = "t", .x_label = "x"};
  figure.panels.push_back({.y_label = "y", .series = {std::move(series)}});
  return figure;
}

std::vector<std::string> texts(const Markup& markup, std::string_view kind = {}) {
  std::vector<std::string> out;
  for (const Element& e : markup.with("text", kind)) out.push_back(e.text);
  return out;
}

/// The estimated place of each text.
std::vector<Rectangle> text_boxes(const Markup& markup) {
  std::vector<Rectangle> boxes;
  for (const Element& e : markup.with("text")) {
    const double size = e.has_class("title")   ? title_font
                        : e.has_class("label") ? label_font
                                               : small_font;
    const double width = text_width(e.text, size);
    const double shift = e.has_class("mid") ? width / 2 : e.has_class("end") ? width : 0;
    const double left = e.number("x") - shift;
    boxes.push_back({left, e.number("y") - 0.75 * size, left + width, e.number("y") + 0.2 * size});
  }
  return boxes;
}

/// No figure is malformed, shows a text outside or over another, or prints a nan.
void expect_tidy(const Figure& figure, double width = 860) {
  const Markup markup(svg(figure, {.width = width}));
  for (const Element& e : markup.elements())
    for (const char* place : {"d", "x", "y", "cx", "cy", "width", "height", "viewBox"})
      if (const auto it = e.attributes.find(place); it != e.attributes.end()) {
        EXPECT_EQ(it->second.find_first_not_of("0123456789 .-MVHvhlz"), std::string::npos)
            << it->second;
      }
  for (const Element& e : markup.with("text"))
    for (const char* broken : {"nan", "inf", "e+", "e-"})
      EXPECT_EQ(e.text.find(broken), std::string::npos) << e.text;
  const double height = markup.with("svg").at(0).number("height");
  const auto boxes = text_boxes(markup);
  const auto words = texts(markup);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_GE(boxes[i].left, 0) << words[i];
    EXPECT_LE(boxes[i].right, width) << words[i];
    EXPECT_GE(boxes[i].top, 0) << words[i];
    EXPECT_LE(boxes[i].bottom, height) << words[i];
    for (std::size_t k = 0; k < i; ++k)
      EXPECT_FALSE(overlap(boxes[i], boxes[k])) << words[i] << " over " << words[k];
  }
  for (const Element& path : markup.with("path", "l"))
    for (const auto& line : lines_of(path.attributes.at("d")))
      for (const Pixel& p : line) {
        EXPECT_TRUE(p.x >= 0 && p.x <= width) << p.x;
        EXPECT_TRUE(p.y >= 0 && p.y <= height) << p.y;
      }
}

TEST(Svg, IsTidyForTheSamples) {
  for (const double width : {860.0, 500.0, 370.0}) {
    expect_tidy(curve_figure(pmc600_cam(), pmc600_look()), width);
    expect_tidy(curve_figure(trapezoid_move(), {.title = "move", .axis_unit = "s", .unit = "mm"}),
                width);
    const Trajectory s =
        s_curve(
            {.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100, .deceleration_jerk = 50})
            .curve();
    CurveLook look{.title = "S-curve", .axis_unit = "s", .unit = "mm"};
    look.limits = {
        .position_min = -1, .position_max = 50, .velocity = 9, .acceleration = 19, .jerk = 1e9};
    expect_tidy(curve_figure(s, trapezoid_move(), look), width);
  }
}

TEST(Svg, IsTidyForDegenerateData) {
  for (const double c : {0.0, 1.0, -7.5, 1e12, -1e12, 1e-12, 1e300, -1e300, 5e-324}) {
    expect_tidy(with({"constant", {0, 1}, {c, c}, Style::line}));
    expect_tidy(with({"point", {c}, {c}, Style::line}));
    expect_tidy(with({"ramp", {0, 1}, {0, c}, Style::line}));
    expect_tidy(with({"long", {0, c}, {0, 1}, Style::dots}));
    expect_tidy(with({"tiny step", {0, 1}, {c, c * (1 + 1e-15)}, Style::under}));
  }
  expect_tidy(with({"negative", {-5, -4}, {-3, -2}, Style::line}));
  expect_tidy(with({"widest", {-1e300, 1e300}, {-1e300, 1e300}, Style::line}));
  expect_tidy(with({"empty", {}, {}, Style::line}));
  expect_tidy(with({"none", {nan, 0}, {0, infinity}, Style::line}));
  expect_tidy(Figure{});
}

TEST(Svg, IsTidyForCurvesOfAnySize) {
  for (const double size : {1e12, 1e-12})
    for (const double stretch : {1e6, 1e-6}) {
      const auto figure = curve_figure(scaled(pmc600_cam(), size, stretch), {.title = "scaled"});
      expect_tidy(figure);
      EXPECT_EQ(Markup(svg(figure)).with("path", "l").size(), 4U);
    }
}

TEST(Svg, IsDeterministic) {
  EXPECT_EQ(svg(curve_figure(pmc600_cam(), pmc600_look())),
            svg(curve_figure(pmc600_cam(), pmc600_look())));
}

TEST(Svg, BreaksALineWhereAPointIsNotFinite) {
  const Markup markup(svg(with({"gap", {0, 1, 2, 3, 4}, {0, 1, nan, 1, 0}, Style::line})));
  EXPECT_EQ(lines_of(markup.with("path", "l").at(0).attributes.at("d")).size(), 2U);
}

TEST(Svg, DrawsOneDotAPoint) {
  const Markup markup(svg(with({"dots", {0, 1, 2, 3}, {0, 1, 2, 3}, Style::dots})));
  EXPECT_EQ(lines_of(markup.with("path", "dots").at(0).attributes.at("d")).size(), 4U);
}

TEST(Svg, DrawsLimitsAsDashedLinesWithTheirNumbers) {
  Figure figure = with({"v", {0, 1}, {-2, 4}, Style::line});
  figure.panels[0].upper = 3;
  figure.panels[0].lower = -3;
  const Markup markup(svg(figure));
  EXPECT_EQ(markup.with("path", "lim").size(), 2U);
  EXPECT_EQ(markup.with("path", "over").size(), 2U);
  EXPECT_THAT(texts(markup, "limtext"), testing::UnorderedElementsAre("limit 3", "limit −3"));
  // To scale: the line at 3 divides the curve from -2 to 4 at 5/6 of its rise.
  const auto line = lines_of(markup.with("path", "l").at(0).attributes.at("d")).at(0);
  std::vector<double> y;
  for (const Element& e : markup.with("path", "lim"))
    y.push_back(lines_of(e.attributes.at("d"))[0][0].y);
  EXPECT_NEAR(y.at(0), line.front().y + 5.0 / 6 * (line.back().y - line.front().y), 0.02);
  EXPECT_NEAR(y.at(1), line.front().y - 1.0 / 6 * (line.back().y - line.front().y), 0.02);
}

TEST(Svg, NotesALimitFarBeyondTheData) {
  Figure figure = with({"v", {0, 1}, {-2, 4}, Style::line});
  figure.panels[0].upper = 3000;
  figure.panels[0].lower = -3000;
  const Markup markup(svg(figure));
  EXPECT_TRUE(markup.with("path", "lim").empty());
  EXPECT_THAT(texts(markup), Contains("limits ±3000 off scale"));
}

TEST(Svg, DrawsABrokenLimitHoweverFar) {
  Figure figure = with({"v", {0, 1}, {-2, 4}, Style::line});
  figure.panels[0].upper = -3000;
  EXPECT_EQ(Markup(svg(figure)).with("path", "lim").size(), 1U);
}

TEST(Svg, MarksBrokenPointsByShapeToo) {
  Figure figure = with({"v", {0, 1}, {0, 1}, Style::line});
  figure.panels[0].markers = {{0, 0, "low", "", false}, {1, 1, "high", "the hint", true}};
  const Markup markup(svg(figure));
  EXPECT_EQ(markup.with("circle", "mark").size(), 1U);
  EXPECT_EQ(markup.with("path", "badmark").size(), 1U);
  EXPECT_THAT(texts(markup), Contains("low"));
  EXPECT_THAT(texts(markup, "bad"), Contains("high"));
  EXPECT_EQ(markup.with("title").at(0).text, "the hint");
}

TEST(Svg, GivesALabelOneStyleInAllPanels) {
  Figure figure;
  for (int panel = 0; panel < 2; ++panel) {
    figure.panels.emplace_back();
    for (const char* label : {"axis 1", "axis 2"})
      if (panel == 0 || std::string(label) == "axis 2")
        figure.panels.back().series.push_back({label, {0, 1}, {0, 1}, Style::line});
  }
  figure.panels[1].series.push_back({"before", {0, 1}, {0, 1}, Style::under});
  const Markup markup(svg(figure));
  EXPECT_EQ(markup.with("path", "l1").size(), 2U);  // the line and its place in the legend
  EXPECT_EQ(markup.with("path", "l2").size(), 3U);
  for (const char* label : {"axis 1", "axis 2", "before"})
    EXPECT_THAT(texts(markup), Contains(label));
}

TEST(Svg, NeedsNoLegendForOneLabel) {
  EXPECT_THAT(texts(Markup(svg(with({"alone", {0, 1}, {0, 1}, Style::line})))),
              Not(Contains("alone")));
}

TEST(Svg, DrawsKnotsAndShades) {
  const Markup markup(svg(curve_figure(pmc600_cam(), pmc600_look())));
  for (const Element& e : markup.with("path", "knot"))
    EXPECT_EQ(lines_of(e.attributes.at("d")).size(), 3U);  // the ends are the frame's
  EXPECT_EQ(markup.with("path", "knot").size(), 4U);
  for (const char* knot : {"75", "200", "280"}) EXPECT_THAT(texts(markup), Contains(knot));
  EXPECT_EQ(markup.with("path", "zone").size(), 4U);
  EXPECT_THAT(texts(markup, "zonetext"), Contains("synchronous"));
}

TEST(Svg, NamesStretchesAsFarAsTheyFit) {
  CurveLook look = pmc600_look();
  look.strips = {{{0, 75, "catch up"}, {75, 200, "in step"}, {200, 220, "too long for this"}},
                 {{200, 202, "no word fits here"}}};
  const Figure figure = curve_figure(pmc600_cam(), look);
  const Markup markup(svg(figure));
  EXPECT_THAT(texts(markup), Contains("catch up"));
  EXPECT_THAT(texts(markup), Contains("in step"));
  EXPECT_THAT(texts(markup),
              Contains(testing::AllOf(testing::StartsWith("too"), Not("too long for this"))));
  EXPECT_TRUE(markup.with("text", "zonetext").empty()) << "its stretch has a name already";
  Figure one_row = figure;
  one_row.strips.pop_back();
  EXPECT_EQ(svg(figure), svg(one_row)) << "a row of which nothing fits takes none";
  expect_tidy(figure);
}

TEST(Svg, KeepsTheNumberOfALineWhereItsNameDoesNotFit) {
  Figure figure = with({"curve", {0, 1000}, {0, 1}, Style::line});
  figure.strips = {{{0, 500, "line 38"},
                    {500, 530, "line 39"},
                    {530, 533, "line 40"},
                    {533, 570, "a long name"},
                    {570, 1000, "line 41"}}};
  const auto shown = texts(Markup(svg(figure)));
  EXPECT_THAT(shown, Contains("line 38"));
  EXPECT_THAT(shown, Contains("39"));
  EXPECT_THAT(shown, Not(Contains("40")));  // no space for the number, either
  EXPECT_THAT(shown, Not(Contains(HasSubstr("line…"))));
}

TEST(Svg, ShowsTheNumbersOfAPanelInTheScaleOfItsAxis) {
  Figure figure = with({"curve", {0, 1, 2}, {0, 0.000115777, 0}, Style::line});
  Panel& panel = figure.panels[0];
  panel.upper = 0.00012;
  panel.markers = {{.x = 1, .y = 0.000115777, .text = "0.000115777", .is_value = true},
                   {.x = 2, .y = 0, .text = "as given"}};
  const auto shown = texts(Markup(svg(figure)));
  EXPECT_THAT(shown, Contains("y (×10⁻⁶)"));
  EXPECT_THAT(shown, Contains("115.777"));
  EXPECT_THAT(shown, Contains("limit 120"));
  EXPECT_THAT(shown, Contains("as given"));
  EXPECT_THAT(shown, Not(Contains("0.000115777")));
  panel.upper = 5;
  EXPECT_THAT(texts(Markup(svg(figure))), Contains("limit 5×10⁶ off scale"));
}

TEST(Svg, DrawsNoCircleOverAPointOfASeries) {
  Figure figure = with({"rms", {0, 1, 2}, {0, 1, 2}, Style::dots});
  figure.panels[0].markers = {{.x = 1, .y = 1, .text = "here"}};
  EXPECT_EQ(Markup(svg(figure)).with("circle", "mark").size(), 1U);
  figure.panels[0].markers[0].text_only = true;
  const Markup markup(svg(figure));
  EXPECT_EQ(markup.with("circle", "mark").size(), 0U);
  EXPECT_THAT(texts(markup), Contains("here"));
}

TEST(Svg, PutsATextWhereItCoversNoLine) {
  // The point is between steep lines, the last 30 px beside it; the text is wider than their distance.
  Series comb{"curve", {}, {}, Style::line};
  for (int i = 0; i <= 40; ++i) {
    comb.x.push_back(i);
    comb.y.push_back(i >= 18 && i <= 22 ? i % 2 : 0);
  }
  Figure figure = with(comb);
  figure.panels[0].markers = {{.x = 20, .y = 0.5, .text = "drive, 11.3 Hz"}};
  const Markup markup(svg(figure, {.width = 860, .panel_height = 200}));
  const auto found = markup.with("text", "halo");
  ASSERT_EQ(found.size(), 1U);
  const double half = text_width("drive, 11.3 Hz", small_font) / 2;
  const auto dots = markup.with("circle", "mark");
  EXPECT_GT(std::abs(found[0].number("x") - dots[0].number("cx")) - half, 32);
}

TEST(Svg, PutsATextWhereItCoversNoPoint) {
  // Points right of the mark, where its text would be, and far away on both sides.
  Figure figure = with({"cases", {0, 50, 53, 56, 100}, {0, 0.5, 0.5, 0.5, 1}, Style::dots});
  figure.panels[0].markers = {{.x = 50, .y = 0.5, .text = "as given"}};
  const Markup markup(svg(figure));
  const auto found = markup.with("text", "halo");
  ASSERT_EQ(found.size(), 1U);
  const double half = text_width("as given", small_font) / 2;
  const double level = markup.with("circle", "mark")[0].number("cy");
  const double below = found[0].number("y") - level;  // base line
  const bool aside = found[0].number("x") + half < markup.with("circle", "mark")[0].number("cx");
  EXPECT_TRUE(aside || below > 12 || below < -5) << below;
}

TEST(Svg, ShowsTheNoteOfAFigureBehindItsAxis) {
  Figure figure = with({"curve", {0, 1}, {0, 1}, Style::line});
  figure.x_note = "limits at 300 mm/s";
  EXPECT_THAT(texts(Markup(svg(figure))), Contains("x · limits at 300 mm/s"));
}

TEST(Svg, ReportsThatKnotsAreTooDense) {
  Figure figure = with({"v", {0, 1}, {0, 1}, Style::line});
  for (int i = 0; i <= 1000; ++i) figure.knots.push_back(i / 1000.0);
  const Markup markup(svg(figure));
  EXPECT_TRUE(markup.with("path", "knot").empty());
  EXPECT_THAT(texts(markup), Contains("x · 1001 knots, too dense to draw"));
}

TEST(Svg, EscapesEveryText) {
  const std::string evil = "<script>alert(\"1\")</script>&'\x01";
  Figure figure{.title = evil, .x_label = evil};
  figure.panels.push_back(
      {.y_label = evil,
       .series = {{evil, {0, 1}, {0, 1}, Style::line}, {"other", {0, 1}, {0, 1}, Style::under}},
       .markers = {{0, 0, evil, evil, true}}});
  figure.shades = {{0, 1, evil}};
  const std::string text = svg(figure);
  EXPECT_THAT(text, Not(HasSubstr("<script")));
  const Markup markup(text);
  EXPECT_TRUE(markup.with("script").empty());
  EXPECT_THAT(texts(markup), Contains(HasSubstr("&lt;script&gt;")).Times(6));
}

TEST(Svg, CutsLongTexts) {
  const std::string longest(500, 'w');
  Figure figure{.title = longest, .x_label = longest};
  figure.panels.push_back({.y_label = longest,
                           .series = {{longest, {0, 1}, {0, 1}, Style::line},
                                      {longest + "2", {0, 1}, {0, 1}, Style::dots}}});
  figure.shades = {{0, 0.1, longest}};
  expect_tidy(figure);
  expect_tidy(figure, 370);
}

TEST(Svg, TakesFewerTicksWhereTheirLabelsAreLong) {
  for (const double width : {860.0, 370.0})
    expect_tidy(with({"v", {1000, 1000.001}, {0, 1}, Style::line}), width);
}

TEST(Svg, LeavesRoomForNumbersAboveAndBelowTheData) {
  const Markup markup(svg(with({"v", {0, 1}, {-2, 4}, Style::line}), {.panel_height = 120}));
  const auto line = lines_of(markup.with("path", "l").at(0).attributes.at("d")).at(0);
  EXPECT_NEAR(line.front().y - line.back().y, 120 - 2 * 17, 0.02);
}

TEST(Svg, SurvivesAWidthTooSmall) {
  EXPECT_NO_THROW(
      Markup(svg(curve_figure(pmc600_cam(), pmc600_look()), {.width = 40, .panel_height = 10})));
}

TEST(SweepLook, HasHighPanelsForAParetoFront) {
  SweepSpec spec = read_sweep(JOUNCE_SOURCE_DIR "/examples/cam-sweep/front.toml");
  spec.objectives.clear();
  EXPECT_EQ(sweep_look(spec).panel_height, SvgOptions{}.panel_height);
  spec.objectives.resize(2);
  EXPECT_GT(sweep_look(spec).panel_height, SvgOptions{}.panel_height);
}

}  // namespace
}  // namespace jounce::figure_test
