// SPDX-License-Identifier: Apache-2.0
// Specs of other kinds than cams: their handles, and the changes that these make in the text.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "jounce/base/file.hpp"
#include "jounce/design/input.hpp"
#include "jounce/spec/spec.hpp"

#include "edit/src/analysis.hpp"
#include "edit/src/change.hpp"
#include "edit/src/editable.hpp"
#include "support/errors.hpp"

namespace jounce::edit_kinds_test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

json editable(const std::string& text) {
  const Spec spec = parse_spec(text, "a.toml");
  return json::parse(edit_detail::editable_json(spec, inputs_of(spec, "a.toml")));
}

std::string changed(const std::string& text, const std::string& change) {
  return edit_detail::changed("a.toml", text, change).text;
}

/// The text with one replacement; the old words must occur once.
std::string replaced(std::string text, const std::string& was, const std::string& now) {
  const std::size_t at = text.find(was);
  EXPECT_NE(at, std::string::npos) << was;
  EXPECT_EQ(text.find(was, at + 1), std::string::npos) << was;
  return text.replace(at, was.size(), now);
}

json handle(const json& document, const std::string& label, int axis, int order) {
  for (const json& each : document.at("handles"))
    if (each["label"] == label && each["axis"] == axis && each["order"] == order) return each;
  throw std::runtime_error("there is no handle " + label);
}

const std::string pvt = R"(jounce = 1
kind = "pvt"
name = "three"  # knots
units = { position = "mm", time = "s" }
knot = [
  { time = "0 ms", position = 0, velocity = 0 },
  { time = "500 ms", position = "6 cm", velocity = 180 },  # through
  { time = 1.2, position = 120, velocity = 0 },
]
)";

TEST(EditKinds, PvtKnotsKeepTheirUnitsAndComments) {
  const json all = editable(pvt);
  EXPECT_EQ(handle(all, "knot 2", 0, 0)["x"],
            json::parse(R"({"place": 0.5, "key": "knot[2].time", "value": 0.5})"));
  EXPECT_EQ(handle(all, "knot 2", 0, 0)["between"], json::parse("[0.0, 1.2]"));
  EXPECT_EQ(handle(all, "knot 2", 0, 0)["slope"]["key"], "knot[2].velocity");
  EXPECT_EQ(handle(all, "knot 3", 0, 1)["y"]["value"], 0);
  EXPECT_EQ(changed(pvt, R"({"do":"numbers","knot[2].time":0.6,"knot[2].position":60})"),
            replaced(pvt, "\"500 ms\"", "\"600 ms\""));
  EXPECT_EQ(changed(pvt, R"({"do":"numbers","knot[2].position":61,"knot[2].velocity":150})"),
            replaced(replaced(pvt, "6 cm", "6.1 cm"), "180", "150"));
}

TEST(EditKinds, APvtKnotIsInsertedOnTheCurveAndRemoved) {
  const Spec spec = parse_spec(pvt, "a.toml");
  const Jet jet = std::get<Table>(spec.subject).curve<OverTime>().jet(0.25);
  const std::string text = changed(pvt, R"({"do":"insert","at":0.25})");
  const Spec with = parse_spec(text, "a.toml");
  const auto& columns = std::get<Table>(with.subject).columns();
  ASSERT_EQ(columns.x.size(), 4U);
  EXPECT_EQ(columns.x[1], 0.25);
  EXPECT_NEAR(columns.p[1], jet[0], 1e-10);
  EXPECT_NEAR(columns.v[1], jet[1], 1e-9);
  EXPECT_THAT(text, HasSubstr("  # through\n"));
  EXPECT_EQ(changed(text, R"({"do":"remove","row":"knot[2]"})"), pvt);
}

TEST(EditKinds, AFilledVelocityIsAddedAndRemoved) {
  const std::string filled = replaced(replaced(pvt, ", velocity = 180 }", " }"),
                                      "name = ", "velocities = \"clamped\"\nname = ");
  const json all = editable(filled);
  EXPECT_TRUE(handle(all, "knot 2", 0, 1)["y"]["value"].is_null()) << "the rule gives it";
  const std::string with = changed(filled, R"({"do":"numbers","knot[2].velocity":150})");
  EXPECT_EQ(with, replaced(filled, "\"6 cm\" }", "\"6 cm\", velocity = 150 }"));
  EXPECT_EQ(changed(with, R"({"do":"numbers","knot[2].velocity":null})"), filled);
}

TEST(EditKinds, NamesWhatIsWrong) {
  const auto refused = [&](const std::string& change) {
    return test::error_of([&] { (void)changed(pvt, change); });
  };
  EXPECT_THAT(refused(R"({"do":"numbers","knot[9].time":1})"),
              HasSubstr("knot[9].time = 1: is not the key of a number of this spec"));
  EXPECT_THAT(refused(R"({"do":"numbers"})"), HasSubstr("needs the key of a number"));
  EXPECT_THAT(refused(R"({"do":"numbers","knot[1].time":"x"})"), HasSubstr("must be a number"));
  EXPECT_THAT(refused(R"({"do":"remove","row":"knot[4]"})"),
              HasSubstr("must be knot[1] to knot[3]"));
  EXPECT_THAT(refused(R"({"do":"remove","row":"units"})"), HasSubstr("must be a table of a list"));
  EXPECT_THAT(refused(R"({"do":"remove","row":"point[1]"})"), HasSubstr("not a list of tables"));
  EXPECT_THAT(refused(R"({"do":"insert","at":0.5})"), HasSubstr("is the place of a point"));
  EXPECT_THAT(refused(R"({"do":"insert","at":3})"), HasSubstr("must be inside the motion"));
  EXPECT_THAT(refused(R"({"do":"insert_in_plane","before":1,"place":[1,2]})"),
              HasSubstr("insert the point in the text"));
}

const std::string via = R"(jounce = 1
kind = "axes"
units = { position = "mm" }
[[axis]]
name = "x"
velocity = 1000
acceleration = 2000
[[axis]]
name = "y"
velocity = 1000
acceleration = 2000
[[point]]
position = [0, 0]
[[point]]                  # over the belt
position = [1000, 1000]
[[point]]
position = [3000, 2000]
)";

TEST(EditKinds, ViaPointsInThePicturesAndInThePlane) {
  const json all = editable(via);
  ASSERT_EQ(all["plane"].size(), 3U);
  EXPECT_EQ(all["plane"][1]["at"][1],
            json::parse(R"({"place": 1000.0, "key": "point[2].position[2]", "value": 1000.0})"));
  // The handle is where the motion passes the point.
  const Spec spec = parse_spec(via, "a.toml");
  const auto axes = inputs_of(spec, "a.toml");
  const json second = handle(all, "point 2", 0, 0);
  EXPECT_NEAR(std::get<Trajectory>(*axes[1].curve).jet(second["x"]["place"].get<double>())[0], 1000,
              1e-6);
  EXPECT_TRUE(second["x"]["key"].is_null()) << "the time is computed";
  EXPECT_EQ(changed(via, R"({"do":"numbers","point[2].position[1]":1200.5})"),
            replaced(via, "[1000, 1000]", "[1200.5, 1000]"));
  EXPECT_EQ(
      changed(via, R"({"do":"insert_in_plane","before":3,"place":[2000,1500]})"),
      replaced(via, "1000]\n[[point]]", "1000]\n[[point]]\nposition = [2000, 1500]\n\n[[point]]"));
  const double middle = (second["x"]["place"].get<double>() +
                         handle(all, "point 3", 0, 0)["x"]["place"].get<double>()) /
                        2;
  const std::string text = changed(via, json({{"do", "insert"}, {"at", middle}}).dump());
  EXPECT_EQ(editable(text)["plane"].size(), 4U);
  EXPECT_EQ(changed(text, R"({"do":"remove","row":"point[3]"})"),
            changed(changed(text, R"({"do":"remove","row":"point[3]"})"),
                    R"({"do":"numbers","point[3].position[1]":3000})"));
}

const std::string path = R"(jounce = 1
kind = "path"
units = { position = "mm", time = "s" }
[path]
velocity = 100
[[axis]]
name = "x"
limits = { velocity = 200, acceleration = 1000, jerk = 10000 }
[[axis]]
name = "y"
limits = { velocity = 200, acceleration = 1000, jerk = 10000 }
[[command]]
type = "line"
to = [100, 0]
[[command]]
type = "arc"
center = [0, 30]           # relative
to = [0, 60]
rotation = "counterclockwise"
relative = true
[[command]]
type = "line"
to = ["0 cm", 60]
)";

TEST(EditKinds, PathPointsInThePlane) {
  const json all = editable(path);
  ASSERT_EQ(all["plane"].size(), 4U);
  // The arc is relative: its center is at (100, 30), and the text counts from (100, 0).
  EXPECT_EQ(all["plane"][2]["label"], "command 2: center");
  EXPECT_EQ(all["plane"][2]["at"][0],
            json::parse(R"({"place": 100.0, "key": "command[2].center[1]", "value": 0.0})"));
  EXPECT_EQ(all["plane"][1]["at"][1]["place"], 60);
  EXPECT_EQ(changed(path, R"({"do":"numbers","command[3].to[1]":25})"),
            replaced(path, "0 cm", "2.5 cm"));
  EXPECT_EQ(changed(path, R"({"do":"insert_in_plane","before":3,"place":[50,70]})"),
            replaced(path, "relative = true\n",
                     "relative = true\n[[command]]\ntype = \"line\"\nto = [50, 70]\n\n"));
  EXPECT_THAT(test::error_of([] {
                (void)changed(path, R"({"do":"insert_in_plane","before":2,"place":[50,70]})");
              }),
              HasSubstr("before = 2: must be a line whose end is not relative"));
}

TEST(EditKinds, PointsOfASplineAreCornersOfItsPolygon) {
  const json all = editable(path +
                            "[[command]]\ntype = \"spline\"\n"
                            "point = [{ to = [0, 90] }, { to = [50, 99] }]\n");
  ASSERT_EQ(all["plane"].size(), 6U);
  EXPECT_EQ(all["plane"][4]["label"], "command 4: point 1");
  EXPECT_EQ(all["plane"][4]["corner"], true);
  EXPECT_FALSE(all["plane"][2].contains("corner")) << "the center of an arc";
}

TEST(EditKinds, FollowTablesCountFromTheOriginOfTheirPass) {
  const std::string text = R"(jounce = 1
kind = "follow"
units = { position = "pulse", master = "pulse", time = "ms" }
[[follow.table]]
segment = [{ master = 5000, slave = 2500 }]
[[follow.table]]
loops = 0
segment = [
  { master = 1000, slave = 1000, type = "continue" },
  { master = 4000, slave = 3400 },
]
)";
  const json all = editable(text);
  const json second = handle(all, "end of follow.table[2].segment 2", 0, 0);
  EXPECT_EQ(
      second["x"],
      json::parse(
          R"({"place": 9000.0, "key": "follow.table[2].segment[2].master", "value": 4000.0})"));
  EXPECT_EQ(second["y"]["place"], 5900);
  EXPECT_EQ(changed(text, R"({"do":"numbers","follow.table[2].segment[2].slave":3500})"),
            replaced(text, "3400", "3500"));
  const std::string with = changed(text, R"({"do":"insert","at":7000})");
  EXPECT_THAT(with, HasSubstr("{ master = 2000, slave = "));
  EXPECT_EQ(changed(with, R"({"do":"remove","row":"follow.table[2].segment[2]"})"), text);
}

TEST(EditKinds, TargetsOfMoves) {
  const std::string text = R"(jounce = 1
kind = "move"
units = { position = "mm" }
[move]
profile = "s_curve"
to = "15 cm"               # the station
velocity = 250
acceleration = 1500
jerk = 12000
[limits]
velocity = 250
)";
  const json all = editable(text);
  const json target = handle(all, "move.to", 0, 0);
  EXPECT_EQ(target["y"]["value"], 150);
  EXPECT_TRUE(target["x"]["key"].is_null());
  EXPECT_EQ(changed(text, R"({"do":"numbers","move.to":180})"), replaced(text, "15 cm", "18 cm"));
  EXPECT_EQ(changed(text, R"({"do":"numbers","limits.velocity":300})"),
            replaced(text, "[limits]\nvelocity = 250", "[limits]\nvelocity = 300"));
  // The start is not in the text, and is added to its section.
  EXPECT_THAT(changed(text, R"({"do":"numbers","move.from":-10})"), HasSubstr("\nfrom = -10\n"));
  std::vector<std::string> labels;
  for (const json& row : all["tables"].back()["rows"]) labels.push_back(row["label"]);
  EXPECT_THAT(labels, ::testing::Contains("limits.velocity [mm/s]"));
}

TEST(EditKinds, SplinePointsOfACam) {
  const std::string text = R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
[[segment]]
law = "quintic_spline"
points = [ { master = 90, slave = 20 } ]   # measured
end = { master = 180, slave = 30 }
[[segment]]
law = "345"
end = { master = 360, slave = 0 }
)";
  const std::string with = changed(text, R"({"do":"insert","at":120})");
  EXPECT_THAT(with, HasSubstr("points = [ { master = 90, slave = 20 }, { master = 120, slave = "));
  EXPECT_EQ(parse_spec(with, "a.toml").is_cam(), true);
  EXPECT_EQ(editable(with)["tables"][0]["rows"].size(), 2U);
  EXPECT_EQ(changed(with, R"({"do":"remove","row":"segment[1].points[2]"})"), text);
  // In another segment, the new point is a knot.
  const std::string split = changed(text, R"({"do":"insert","at":270})");
  EXPECT_EQ(std::get<CamSpec>(parse_spec(split, "a.toml").subject).segments.size(), 3U);
}

/// Every example opens with its findings, and its numbers can be set to themselves.
TEST(EditKinds, EveryExampleOpens) {
  for (const char* name :
       {"googol-pt/sine.toml", "pmc600-pt/position.toml", "pmc600-pt/velocity.toml",
        "generators/03-move.toml", "generators/07-synchronize.toml", "generators/09-queue.toml",
        "generators/10-aborting.toml", "generators/26-follow.toml", "spline-times/axes.toml",
        "himc-path/arc-forms.toml", "pmc600-path/sequence.toml", "kinematics/scara.toml",
        "points-file/pvt.toml", "rotary-knife/knife.toml", "googol-clutch/gear.toml",
        "homing/axis.toml", "printing-line/machine.toml", "compensation/screw.toml"}) {
    const std::string file = std::string(JOUNCE_SOURCE_DIR "/examples/") + name;
    const std::string text = read_file(file);
    edit_detail::Json shown;
    add_to(shown, edit_detail::analysis_of(file, text));
    const json all = shown;
    for (const json& finding : all["result"]["findings"])
      EXPECT_FALSE(finding["rule"].get<std::string>().starts_with("input/")) << name << finding;
    if (all["edit"].is_null()) continue;
    for (const json& table : all["edit"]["tables"])
      for (const json& row : table["rows"])
        for (const json& cell : row["cells"]) {
          if (cell["key"].is_null() || cell["value"].is_null()) continue;
          json change = row["change"];
          change[cell["key"].get<std::string>()] = cell["value"];
          EXPECT_EQ(edit_detail::changed(file, text, change.dump()).text, text)
              << name << ' ' << cell;
        }
  }
}

}  // namespace
}  // namespace jounce::edit_kinds_test
