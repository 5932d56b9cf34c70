// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/chart_data.hpp"

#include <array>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/design/over_time.hpp"
#include "jounce/plot/findings.hpp"
#include "jounce/plot/input_figure.hpp"
#include "jounce/plot/page.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/spec/spec.hpp"

#include "plot/markup.hpp"
#include "support/errors.hpp"

namespace jounce::chart_data_test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";

Input example(const std::string& path) {
  return read_inputs(examples + path).front();
}

Segment segment_of(const json& piece) {
  Segment f;
  f.length = piece[0];
  f.degree = static_cast<int>(piece[1].size()) - 1;
  for (std::size_t k = 0; k < piece[1].size(); ++k) f.c[k] = piece[1][k];
  if (piece.size() < 3) return f;
  f.sines = static_cast<int>(piece[2].size()) / 3;
  for (std::size_t i = 0; i < static_cast<std::size_t>(f.sines); ++i)
    f.sine[i] = {piece[2][3 * i], piece[2][3 * i + 1], piece[2][3 * i + 2]};
  return f;
}

/// Expects that the data restores every number of the curve.
template <class Over>
void expect_same(const json& data, const Curve<Over>& curve) {
  EXPECT_EQ(data["start"], curve.start());
  ASSERT_EQ(data["pieces"].size(), curve.segments().size());
  for (std::size_t i = 0; i < curve.segments().size(); ++i) {
    const Segment& want = curve.segments()[i];
    const Segment got = segment_of(data["pieces"][i]);
    EXPECT_EQ(got.length, want.length);
    EXPECT_EQ(got.degree, want.degree);
    EXPECT_EQ(got.c, want.c);
    ASSERT_EQ(got.sines, want.sines);
    for (std::size_t k = 0; k < static_cast<std::size_t>(want.sines); ++k) {
      EXPECT_EQ(got.sine[k].amplitude, want.sine[k].amplitude);
      EXPECT_EQ(got.sine[k].angle, want.sine[k].angle);
      EXPECT_EQ(got.sine[k].phase, want.sine[k].phase);
    }
  }
}

/// A motion over time of this many cubics.
Input many_pieces(std::size_t count) {
  std::vector<Segment> pieces;
  for (std::size_t i = 0; i < count; ++i) {
    const double p = std::sin(0.37 * static_cast<double>(i));
    pieces.push_back(cubic(0.01, p, 0, std::sin(0.37 * static_cast<double>(i + 1)), 0));
  }
  Input input = example("generators/03-move.toml");
  input.spec.reset();
  input.limits = {};
  input.labels.segments.clear();
  input.curve = Trajectory(std::move(pieces));
  return input;
}

TEST(ChartData, RestoresEveryNumberOfTheSegments) {
  for (const char* name :
       {"pmc600-cam/cam.toml", "residual-17hz/cam.toml", "valve-train/cam.toml"}) {
    const Input input = example(name);
    const json data = json::parse(chart_data(input));
    expect_same(data["views"][0]["curves"][0], std::get<Cam>(*input.curve));
  }
}

TEST(ChartData, HasTheSlaveOverTimeWithItsLimitsInTheirUnits) {
  const Input input = example("packaging-pusher/cam.toml");
  const json data = json::parse(chart_data(input));
  ASSERT_EQ(data["views"].size(), 2U);
  const Input slave = over_time(input);
  expect_same(data["views"][1]["curves"][0], std::get<Trajectory>(*slave.curve));
  const json& velocity = data["views"][1]["panels"][1];
  EXPECT_EQ(velocity["unit"], "m/s");
  EXPECT_EQ(velocity["size"], 1000.0);  // mm/s
  EXPECT_EQ(velocity["upper"], 1.5);
  EXPECT_EQ(velocity["lower"], -1.5);
  EXPECT_EQ(data["views"][1]["unit"], "s");
  EXPECT_EQ(data["views"][0]["panels"][1]["upper"], 3.0);
  EXPECT_EQ(data["views"][0]["unit"], "deg");
}

Input cam_with(const std::string& sections) {
  return inputs_of(parse_spec("jounce = 1\nkind = \"cam\"\nname = \"c\"\nperiodic = true\n"
                              "units = { master = \"mm\", position = \"mm\" }\n"
                              "start = { master = 0, slave = 0 }\n"
                              "[[segment]]\nlaw = \"345\"\nend = { master = 200, slave = 60 }\n"
                              "[[segment]]\nlaw = \"345\"\nend = { master = 400, slave = 0 }\n" +
                                  sections,
                              "c.toml"),
                   "c.toml")
      .front();
}

TEST(ChartData, HasTheLimitsOfTheSlaveOverTheMasterAtItsSpeed) {
  const std::string slave = "[limits.slave]\nvelocity = 150\nacceleration = 900\njerk = 270000\n";
  const auto view = [](const Input& input) { return json::parse(chart_data(input))["views"][0]; };
  const json drawn =
      view(cam_with("[master]\nvelocity = 300\n" + slave + "[limits]\ngeo_jerk = 0.001\n"));
  EXPECT_EQ(drawn["note"], "limits at 300 mm/s");
  EXPECT_TRUE(drawn["panels"][0]["upper"].is_null());
  EXPECT_DOUBLE_EQ(drawn["panels"][1]["upper"], 0.5);   // 150 / 300
  EXPECT_DOUBLE_EQ(drawn["panels"][2]["upper"], 0.01);  // 900 / 300^2
  EXPECT_DOUBLE_EQ(drawn["panels"][2]["lower"], -0.01);
  EXPECT_DOUBLE_EQ(drawn["panels"][3]["upper"], 0.001);  // that of [limits]: 270000 / 300^3 is 0.01
  // Peaks of 3-4-5: 1.875 h / L = 0.5625, 5.7735 h / L^2 = 0.00866.
  EXPECT_EQ(drawn["panels"][1]["marks"][0][2], true);
  EXPECT_EQ(drawn["panels"][2]["marks"][0][2], false);
  // A master that accelerates is slower somewhere: the line stays, no point is broken for sure.
  const json ramp = view(cam_with("[master]\nvelocity = 300\nacceleration = 500\n" + slave));
  EXPECT_DOUBLE_EQ(ramp["panels"][1]["upper"], 0.5);
  EXPECT_EQ(ramp["panels"][1]["marks"][0][2], false);
  const json minutes = view(cam_with("[master]\nvelocity = \"18 m/min\"\n" + slave));
  EXPECT_EQ(minutes["note"], "limits at 18 m/min");
  EXPECT_DOUBLE_EQ(minutes["panels"][1]["upper"], 0.5);
  EXPECT_EQ(view(cam_with("[master]\nvelocity = 300\n"))["note"], "");
}

TEST(ChartData, HasTheMotionBeforeInTheUnitsOfTheMotion) {
  const Input input = example("packaging-pusher/cam.toml");
  Input before = input;
  before.name = "old";
  before.curve = scaled(std::get<Cam>(*input.curve), 0.5);
  const json view = json::parse(chart_data(input, before))["views"][0];
  ASSERT_EQ(view["curves"].size(), 2U);
  EXPECT_EQ(view["curves"][1]["label"], "old");
  expect_same(view["curves"][1], std::get<Cam>(*before.curve));
  EXPECT_EQ(test::key_of([&] { chart_data(input, example("generators/03-move.toml")); }), "before");
}

TEST(ChartData, HasTheExactExtremaOfBlocksOfALargeCurve) {
  const Input input = many_pieces(200'000);
  const std::string text = chart_data(input);
  EXPECT_LT(text.size(), most_chart_bytes);
  const json curve = json::parse(text)["views"][0]["curves"][0];
  EXPECT_FALSE(curve.contains("pieces"));
  EXPECT_EQ(curve["count"], 200'000);
  const auto& motion = std::get<Trajectory>(*input.curve);
  const std::size_t blocks = curve["edges"].size() - 1;
  ASSERT_GT(blocks, 2000U);
  EXPECT_EQ(curve["edges"][0], motion.start());
  EXPECT_EQ(curve["edges"][blocks], motion.end());
  std::array<double, 4> rounding{};
  for (std::size_t k = 0; k < 4; ++k) {  // the extrema of the whole motion are kept
    const Range whole = extrema(motion, static_cast<int>(k));
    rounding[k] = 1e-12 * whole.max.value;
    double low = curve["low"][k][0];
    double high = curve["high"][k][0];
    for (std::size_t i = 0; i < blocks; ++i) {
      low = std::min(low, curve["low"][k][i].get<double>());
      high = std::max(high, curve["high"][k][i].get<double>());
    }
    EXPECT_EQ(low, whole.min.value);
    EXPECT_EQ(high, whole.max.value);
  }
  for (std::size_t i = 0; i < blocks; i += 97) {  // no value leaves its block
    const double x = (curve["edges"][i].get<double>() + curve["edges"][i + 1].get<double>()) / 2;
    const Jet jet = motion.jet(x);
    for (std::size_t k = 0; k < 4; ++k) {
      EXPECT_GE(jet[k], curve["low"][k][i].get<double>() - rounding[k]);
      EXPECT_LE(jet[k], curve["high"][k][i].get<double>() + rounding[k]);
    }
  }
}

TEST(ChartData, KeepsTheSegmentsOfACurveThatFits) {
  const json curve = json::parse(chart_data(many_pieces(5000)))["views"][0]["curves"][0];
  EXPECT_EQ(curve["pieces"].size(), 5000U);
}

TEST(ChartData, HasTheIntervalsInWhichOutputsAreOn) {
  std::string text = R"(jounce = 1
kind = "cam"
name = "switched"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
[[segment]]
law = "modified_sine"
end = { master = 360, slave = 10 }
[master]
velocity = 360
distance = 360
[switches]
of = "master"
[[switch]]
track = 3
first_on_position = 90
last_on_position = 180
)";
  const Input input = inputs_of(parse_spec(text, "switched.toml"), "switched.toml").front();
  const json outputs = json::parse(chart_data(input))["views"][1]["outputs"];
  ASSERT_EQ(outputs.size(), 1U);
  EXPECT_EQ(outputs[0][0], "track 3");
  ASSERT_EQ(outputs[0][1].size(), 1U);
  EXPECT_NEAR(outputs[0][1][0][0].get<double>(), 0.25, 1e-12);  // 90 deg at 360 deg/s
  EXPECT_NEAR(outputs[0][1][0][1].get<double>(), 0.5, 1e-12);
}

TEST(ChartData, InAPageCannotEndItsElement) {
  Input input = example("packaging-pusher/cam.toml");
  const std::string evil = "</script><script>alert(1)</script><!--<script>\xff";
  input.name = evil;
  Figure figure = figure_of(input);
  const std::string page =
      html({.title = "t", .sections = {{"", {Chart{figure, "", chart_data(input)}}}}});
  const Markup markup(page, true);
  const auto scripts = markup.with("script");
  ASSERT_EQ(scripts.size(), 2U);
  EXPECT_EQ(scripts[0].attributes.at("type"), "application/json");
  EXPECT_THAT(scripts[0].text, Not(HasSubstr("<")));
  const std::string name = json::parse(scripts[0].text)["name"];
  EXPECT_EQ(name, "</script><script>alert(1)</script><!--<script>\xEF\xBF\xBD");
  EXPECT_TRUE(scripts[1].attributes.empty());
}

TEST(ChartData, GivesThePagePlacesForItsRows) {
  Report report;
  report.findings.resize(2);
  report.findings[0].rule = "limit/velocity";
  report.findings[0].where = 0.1;
  report.findings[1].rule = "drive/gain";
  report.findings[1].where = 3;
  report.findings[1].where_unit = "Hz";
  const DataTable table = findings_table(report, {});
  ASSERT_TRUE(table.rows[0].place);
  EXPECT_EQ(table.rows[0].place->from, 0.1);
  EXPECT_FALSE(table.rows[1].place) << "a frequency is no place of the motion";
  const Markup markup(html({.title = "t", .sections = {{"", {table}}}}), true);
  const auto rows = markup.with("tr");
  EXPECT_EQ(rows.at(1).attributes.at("data-from"), "0.1");
  EXPECT_EQ(rows.at(2).attributes.count("data-from"), 0U);
}

}  // namespace
}  // namespace jounce::chart_data_test
