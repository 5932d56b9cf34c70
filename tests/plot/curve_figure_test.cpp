// SPDX-License-Identifier: Apache-2.0
#include "plot/src/figure/curve_figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/design/over_time.hpp"
#include "jounce/plot/input_figure.hpp"
#include "jounce/plot/label.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/profiles/error.hpp"

#include "plot/markup.hpp"
#include "plot/samples.hpp"
#include "plot/src/figure/panel.hpp"

namespace jounce::curve_figure_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<std::string> marker_texts(const Panel& panel) {
  std::vector<std::string> texts;
  for (const Marker& marker : panel.markers) texts.push_back(marker.text);
  return texts;
}

/// Values where the jumps of a series are: its pairs of points at one x that differ.
std::vector<std::array<double, 3>> jumps(const Series& series) {
  std::vector<std::array<double, 3>> found;
  for (std::size_t i = 1; i < series.x.size(); ++i)
    if (series.x[i] == series.x[i - 1] && series.y[i] != series.y[i - 1])
      found.push_back({series.x[i], series.y[i - 1], series.y[i]});
  return found;
}

TEST(CurveFigure, MarksTheExtremaOfTheManual) {
  const Figure figure = curve_figure(pmc600_cam(), pmc600_look());
  ASSERT_EQ(figure.panels.size(), 4U);
  // PMC600 manual, Fig. 6.14: segment maxima, to the six digits shown.
  EXPECT_THAT(marker_texts(figure.panels[0]), ElementsAre("232.362", "0"));
  EXPECT_THAT(marker_texts(figure.panels[1]), ElementsAre("2.10739", "−3.39227"));
  EXPECT_THAT(marker_texts(figure.panels[2]), Contains("−0.161923"));
  // Segment 1 peaks at the master position 42, exactly.
  EXPECT_NEAR(figure.panels[1].markers[0].x, 42, 1e-9);
  EXPECT_THAT(figure.panels[1].markers[0].hint, HasSubstr("geo_velocity 2.1073"));
}

TEST(CurveFigure, ShowsEveryExtremumInTheSvg) {
  for (const double width : {860.0, 370.0}) {
    const Markup markup(svg(curve_figure(pmc600_cam(), pmc600_look()), {.width = width}));
    std::vector<std::string> texts;
    for (const Element& e : markup.with("text", "halo")) texts.push_back(e.text);
    for (const Range& range : extrema(pmc600_cam())) {
      EXPECT_THAT(texts, Contains(short_number(range.max.value)));
      EXPECT_THAT(texts,
                  Contains(short_number(std::abs(range.min.value) < 1e-12 ? 0 : range.min.value)));
    }
  }
}

TEST(CurveFigure, MarksWhatIsBroken) {
  const Figure figure = curve_figure(pmc600_cam(), pmc600_look());
  const auto broken = [&](std::size_t panel) {
    std::vector<std::string> texts;
    for (const Marker& m : figure.panels[panel].markers)
      if (m.broken) texts.push_back(m.text);
    return texts;
  };
  EXPECT_THAT(broken(0), IsEmpty());
  EXPECT_THAT(broken(1), ElementsAre("−3.39227"));
  EXPECT_THAT(broken(2), ElementsAre("−0.161923"));
  EXPECT_THAT(broken(3), IsEmpty());
}

TEST(CurveFigure, MarksEachSegmentThatBreaksALimit) {
  CurveLook look = pmc600_look();
  look.limits.velocity = 2;
  const Panel panel = curve_figure(pmc600_cam(), look).panels[1];
  // PMC600 manual, Fig. 6.14: max abs V of segments 1, 3 and 4; segment 2 runs at 1.
  EXPECT_THAT(marker_texts(panel), ElementsAre("2.10739", "−3.39227", "−2.35137"));
  EXPECT_TRUE(std::all_of(panel.markers.begin(), panel.markers.end(),
                          [](const Marker& m) { return m.broken; }));
}

TEST(CurveFigure, MarksALimitThatIsMetAsMet) {
  CurveLook look;
  look.limits.velocity = 10;
  const Panel panel = curve_figure(trapezoid_move(), look).panels[1];
  EXPECT_FALSE(panel.markers[0].broken);
}

TEST(CurveFigure, MarksAPlateauOnce) {
  CurveLook look;
  look.limits.acceleration = 19;
  const Trajectory s = s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve();
  EXPECT_THAT(marker_texts(curve_figure(s, look).panels[2]), ElementsAre("20", "−20"));
}

TEST(CurveFigure, NamesQuantitiesAndUnits) {
  const auto labels = [](const Figure& f) {
    std::vector<std::string> out{f.x_label};
    for (const Panel& panel : f.panels) out.push_back(panel.y_label);
    return out;
  };
  EXPECT_THAT(labels(curve_figure(pmc600_cam(), {.axis_unit = "deg", .unit = "mm"})),
              ElementsAre("master [deg]", "position [mm]", "geo_velocity [mm/deg]",
                          "geo_acceleration [mm/deg²]", "geo_jerk [mm/deg³]"));
  EXPECT_THAT(labels(curve_figure(trapezoid_move(), {.axis_unit = "s", .unit = "mm"})),
              ElementsAre("time [s]", "position [mm]", "velocity [mm/s]", "acceleration [mm/s²]",
                          "jerk [mm/s³]"));
  EXPECT_THAT(labels(curve_figure(trapezoid_move(), {})),
              ElementsAre("time", "position", "velocity", "acceleration", "jerk"));
}

TEST(CurveFigure, UsesAngularTicksForDegrees) {
  const Markup markup(svg(curve_figure(pmc600_cam(), {.axis_unit = "deg"}), {.width = 500}));
  std::vector<std::string> ticks;
  for (const Element& e : markup.with("text", "mid")) ticks.push_back(e.text);
  for (const char* tick : {"0", "90", "180", "270", "360"}) EXPECT_THAT(ticks, Contains(tick));
}

TEST(CurveFigure, DrawsJumpsAsVerticals) {
  const Figure figure = curve_figure(trapezoid_move(), {});
  using Jump = std::array<double, 3>;
  EXPECT_THAT(jumps(figure.panels[2].series[0]),
              ElementsAre(Jump{0.5, 20, 0}, Jump{5.125, 0, -40}));
  const Markup markup(svg(figure));
  const auto line = lines_of(markup.with("path", "l").at(2).attributes.at("d"));
  ASSERT_EQ(line.size(), 1U);
  // Six corners: along 20, down to 0, along, down to -40, along.
  ASSERT_EQ(line[0].size(), 6U);
  EXPECT_EQ(line[0][1].x, line[0][2].x);
  EXPECT_EQ(line[0][3].x, line[0][4].x);
  EXPECT_NEAR((line[0][4].y - line[0][3].y) / (line[0][2].y - line[0][1].y), 2, 1e-3);
}

TEST(CurveFigure, KeepsRoundingFlat) {
  // The synchronous stretch alone, as a quintic: its acceleration and jerk are rounding.
  const Cam cam({quintic(125, 100, 1, 0, 225.0, 1, 0), quintic(80.1, 225, 1, 0, 305.1, 1, 0)}, 75);
  const Figure figure = curve_figure(cam, {});
  for (const std::size_t k : {2U, 3U}) {
    EXPECT_THAT(marker_texts(figure.panels[k]), ElementsAre("0"));
    const Markup markup(svg(figure));
    for (const auto& line : lines_of(markup.with("path", "l").at(k).attributes.at("d")))
      for (const Pixel& p : line) EXPECT_EQ(p.y, line[0].y);
  }
}

TEST(CurveFigure, IsNotFlattenedByASliver) {
  // A jerk of +-6000 around a stretch of 1e-9 s, whose coefficients of degree 9 are rounding.
  Segment up{.length = 0.1, .degree = 3, .c = {0, 0, 0, 1}};
  Segment sliver{.length = 1e-9, .degree = 9, .c = {1, 3e-8, 3e-16, 0, 0, 0, 0, 0, 0, 1e-26}};
  Segment down{.length = 0.1, .degree = 3, .c = {1 + 3e-8, 3, 3, -1}};
  const Figure figure = curve_figure(Trajectory({up, sliver, down}, 0), {});
  EXPECT_LT(figure.panels[3].noise, 1e-6);
  EXPECT_NEAR(figure.panels[3].markers[0].y, 6000, 1e-6);
  EXPECT_GT(panel_axis(figure.panels[3], 120).extent.span(), 12000);
}

TEST(CurveFigure, LaysTheOneBeforeUnder) {
  const Figure figure = curve_figure(trapezoid_move(), scaled(trapezoid_move(), 1, 2),
                                     {.label = "optimized", .before = "as drawn"});
  for (const Panel& panel : figure.panels) {
    ASSERT_EQ(panel.series.size(), 2U);
    EXPECT_EQ(panel.series[0].style, Style::line);
    EXPECT_EQ(panel.series[1].style, Style::under);
    EXPECT_DOUBLE_EQ(panel.series[1].x.back(), 10.75);
  }
  const std::string text = svg(figure);
  EXPECT_THAT(text, HasSubstr(">optimized</text>"));
  EXPECT_THAT(text, HasSubstr(">as drawn</text>"));
}

TEST(CurveFigure, TakesKnotsOfTheSpec) {
  EXPECT_THAT(curve_figure(trapezoid_move(), {}).knots, ElementsAre(0, 0.5, 5.125, 5.375));
  EXPECT_THAT(curve_figure(trapezoid_move(), {.knots = std::vector{1.0}}).knots, ElementsAre(1));
}

TEST(CurveFigure, RejectsBadLimits) {
  CurveLook look;
  look.limits.velocity = -1;
  EXPECT_THROW(curve_figure(trapezoid_move(), look), InputError);
}

double distance(Pixel p, Pixel a, Pixel b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  const double t = std::clamp(
      ((p.x - a.x) * dx + (p.y - a.y) * dy) / std::max(dx * dx + dy * dy, 1e-30), 0.0, 1.0);
  return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

/// The largest distance in px of the true curve from what is drawn. The scale of each panel is
/// taken from its two extrema markers.
template <class Over>
double worst_distance(const Curve<Over>& f) {
  const Figure figure = curve_figure(f, {});
  const Markup markup(svg(figure));
  const auto circles = markup.with("circle", "mark");
  double worst = 0;
  for (std::size_t k = 0, c = 0; k < 4; ++k) {
    const auto& markers = figure.panels[k].markers;
    const auto line = lines_of(markup.with("path", "l").at(k).attributes.at("d")).at(0);
    const double left = line.front().x;
    const double px_per_x = (line.back().x - left) / f.length();
    const double top = circles.at(c).number("cy");
    const double px_per_y = (circles.at(c + 1).number("cy") - top) / (markers[1].y - markers[0].y);
    c += markers.size();
    for (int i = 0; i <= 20000; ++i) {
      const double x = std::min(f.start() + f.length() * i / 20000, f.end());
      const Pixel p{left + (x - f.start()) * px_per_x,
                    top + (f.jet(x, Side::left)[k] - markers[0].y) * px_per_y};
      double nearest = 1e9;
      for (std::size_t n = 1; n < line.size(); ++n)
        if (line[n].x > p.x - 3 && line[n - 1].x < p.x + 3)
          nearest = std::min(nearest, distance(p, line[n - 1], line[n]));
      worst = std::max(worst, nearest);
    }
  }
  return worst;
}

// Half a pixel by construction, a tenth by thinning, and rounding to hundredths.
constexpr double accuracy = 0.62;

TEST(CurveFigure, IsAccurateToAPixel) {
  EXPECT_LT(worst_distance(pmc600_cam()), accuracy);
  EXPECT_LT(
      worst_distance(s_curve({.to = 50, .velocity = 10, .acceleration = 20, .jerk = 100}).curve()),
      accuracy);
}

TEST(CurveFigure, IsAccurateOnAShortWildSegment) {
  Segment wild = line(0.02, 0, 0);  // ten oscillations on 2 % of the width
  wild.sines = 1;
  wild.sine[0] = {1, 20 * std::numbers::pi, 0};
  EXPECT_LT(worst_distance(Cam({line(0.49, 0, 0), wild, quintic(0.49, 0, 0, 0, 1, 0, 0)})),
            accuracy);
}

TEST(CurveFigure, IsLean) {
  EXPECT_LT(svg(curve_figure(pmc600_cam(), pmc600_look())).size(), 13'000U);
  EXPECT_LT(svg(curve_figure(pmc600_cam(), pmc600_look()), {.inlined = true}).size(), 10'000U);
  EXPECT_LT(svg(curve_figure(trapezoid_move(), {})).size(), 8'000U);
}

TEST(CurveFigure, IsLeanWithManySegments) {
  const Cam many = repeated(with(pmc600_cam(), Extrapolation::hold), 5000);
  EXPECT_LT(svg(curve_figure(many, {})).size(), 250'000U);
}

TEST(OverTimeFigure, HasNamesBesideItsZonesAndNoNumbersOfKnots) {
  const Input knife = read_inputs(JOUNCE_SOURCE_DIR "/examples/rotary-knife/knife.toml").front();
  const Figure figure = figure_of(over_time(knife));
  ASSERT_FALSE(figure.shades.empty());
  ASSERT_FALSE(figure.names.empty());
  for (const Shade& name : figure.names) {
    EXPECT_EQ(name.label.find_first_of("0123456789"), std::string::npos) << name.label;
    for (const Shade& shade : figure.shades)
      EXPECT_TRUE(name.to <= shade.from + 1e-9 || shade.to <= name.from + 1e-9) << name.label;
  }
  const Markup markup(svg(figure));
  EXPECT_FALSE(markup.with("path", "knot").empty());
  std::size_t named = 0;
  for (const Element& e : markup.with("text", "soft"))
    if (e.has_class("mid")) named += e.text.find_first_of("0123456789") == std::string::npos;
  EXPECT_GT(named, 0U);
}

TEST(OverTimeFigure, LeavesOutNamesThatDoNotFit) {
  Figure figure{.x_label = "time [s]"};
  figure.panels.push_back({.y_label = "y", .series = {{"curve", {0, 100}, {0, 1}}}});
  figure.knots = {50, 50.5};
  figure.names = {{0, 50, "start"}, {50, 50.5, "wait"}, {50.5, 100, "stop"}};
  const auto written = [&] {
    std::vector<std::string> all;
    for (const Element& e : Markup(svg(figure)).with("text")) all.push_back(e.text);
    return all;
  };
  EXPECT_THAT(written(), testing::IsSupersetOf({"start", "stop"}));
  EXPECT_THAT(written(), testing::Not(testing::Contains("wait")));
  EXPECT_THAT(written(), testing::Not(testing::Contains("50.5")));
}

}  // namespace
}  // namespace jounce::curve_figure_test
