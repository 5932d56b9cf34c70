// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/cam/design/design.hpp"
#include "jounce/profiles/curve/extrema.hpp"
#include "jounce/spec/spec.hpp"

#include "edit/src/change.hpp"
#include "support/errors.hpp"

namespace jounce::cam_change_test {
namespace {

using ::testing::HasSubstr;

const std::string feeder = R"(jounce = 1
kind = "cam"
periodic = true
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }  # home
[[segment]]
name = "rise"
law = "modified_sine"
end = { master = 120, slave = 50 }
[[segment]]
law = "dwell"
end = { master = 200, slave = 50 }
[[segment]]
law = "quintic"
end = { master = 360, slave = 0 }
)";

CamSpec cam_of(const std::string& text) {
  return std::get<CamSpec>(parse_spec(text, "a.toml").subject);
}

std::string changed(const std::string& text, const std::string& change) {
  return edit_detail::changed("a.toml", text, change).text;
}

std::string refused(const std::string& change, const std::string& text = feeder) {
  return test::error_of([&] { (void)changed(text, change); });
}

TEST(CamChange, ADwellMovesWithItsKnot) {
  const CamSpec cam = cam_of(changed(feeder, R"({"do":"move","knot":1,"master":130,"slave":60})"));
  EXPECT_EQ(cam.segments[0].end.master, 130);
  EXPECT_EQ(cam.segments[0].end.slave, 60);
  EXPECT_EQ(cam.segments[1].end.slave, 60);
  EXPECT_EQ(cam.segments[2].end.slave, 0);
}

const std::string through_points = R"(jounce = 1
kind = "cam"
periodic = true
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
[[segment]]
law = "quintic_spline"
points = [ { master = 90, slave = 20 }, { master = 180, slave = 30 } ]  # measured
end = { master = 360, slave = 0 }
[switches]
of = "master"
[[switch]]
track = 2
first_on_position = 350
last_on_position = 20
)";

TEST(CamChange, APointMovesAndItsCommentStays) {
  EXPECT_THAT(
      changed(through_points, R"({"do":"point","segment":1,"point":2,"master":185,"slave":31.5})"),
      HasSubstr("{ master = 185, slave = 31.5 } ]  # measured"));
  EXPECT_THAT(
      refused(R"({"do":"point","segment":1,"point":3,"master":185,"slave":31.5})", through_points),
      HasSubstr("point"));
  EXPECT_THAT(refused(R"({"do":"point","segment":1,"point":1,"master":1,"slave":1})"),
              HasSubstr("has no points"));
}

TEST(CamChange, ASwitchMoves) {
  EXPECT_THAT(changed(through_points, R"({"do":"switch","switch":1,"first":340,"last":25})"),
              HasSubstr("first_on_position = 340\nlast_on_position = 25"));
  EXPECT_THAT(refused(R"({"do":"switch","switch":1,"first":340,"last":25})"), HasSubstr("switch"));
}

TEST(CamChange, BothEndsOfAPeriodMoveTogether) {
  const CamSpec cam = cam_of(changed(feeder, R"({"do":"set","knot":3,"key":"slave","value":5})"));
  EXPECT_EQ(cam.start.slave, 5);
  EXPECT_EQ(cam.segments[2].end.slave, 5);
}

TEST(CamChange, KeepsTheSpeedOfALine) {
  const std::string line = R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
[[segment]]
law = "quintic"
end = { master = 100, slave = 50, geo_velocity = 1 }
[[segment]]
law = "line"
end = { master = 150, slave = 100, geo_velocity = 1 }
[[segment]]
law = "quintic"
end = { master = 300, slave = 150 }
)";
  const CamSpec cam = cam_of(changed(line, R"({"do":"move","knot":2,"master":150,"slave":110})"));
  EXPECT_EQ(cam.segments[0].end.geo_velocity, 1.2);
  EXPECT_EQ(cam.segments[1].end.geo_velocity, 1.2);
  EXPECT_NO_THROW((void)design(cam));
}

TEST(CamChange, ADerivativeIsSetAndRemoved) {
  const std::string with =
      changed(feeder, R"({"do":"set","knot":3,"key":"geo_velocity","value":-0.5})");
  EXPECT_EQ(cam_of(with).segments[2].end.geo_velocity, -0.5);
  EXPECT_EQ(changed(with, R"({"do":"set","knot":3,"key":"geo_velocity","value":null})"), feeder);
  EXPECT_EQ(changed(with, R"({"do":"set","knot":0,"key":"geo_velocity","value":null})"), feeder)
      << "both ends of a period are one knot";
}

TEST(CamChange, AnotherLawKeepsTheFormThatItAccepts) {
  const std::string with =
      changed(changed(feeder, R"({"do":"form","segment":1,"key":"inflection","value":0.4})"),
              R"({"do":"law","segment":1,"law":"345"})");
  EXPECT_EQ(cam_of(with).segments[0].form.inflection, 0.4);
  const CamSegment quintic =
      cam_of(changed(with, R"({"do":"law","segment":1,"law":"quintic"})")).segments[0];
  EXPECT_EQ(quintic.form.inflection, std::nullopt);
  const CamSpec scca = cam_of(changed(feeder, R"({"do":"law","segment":1,"law":"scca"})"));
  EXPECT_NO_THROW((void)design(scca)) << "it gets the shares that it requires";
}

TEST(CamChange, ASegmentBecomesADwell) {
  const CamSpec cam = cam_of(changed(feeder, R"({"do":"law","segment":1,"law":"dwell"})"));
  EXPECT_EQ(cam.segments[0].end.slave, 0);
  EXPECT_EQ(cam.segments[1].end.slave, 0);
  EXPECT_NO_THROW((void)design(cam));
}

// A quintic is the polynomial of degree 5 of its ends: both halves are that polynomial.
TEST(CamChange, ASplitQuinticKeepsItsShape) {
  const Cam before = design(cam_of(feeder)).cam;
  const CamSpec cam = cam_of(changed(feeder, R"({"do":"split","master":250})"));
  ASSERT_EQ(cam.segments.size(), 4U);
  EXPECT_EQ(cam.segments[2].end.master, 250);
  const Cam after = design(cam).cam;
  for (int x = 0; x <= 360; ++x)
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(after.jet(x)[k], before.jet(x)[k], 1e-9) << x << ' ' << k;
}

TEST(CamChange, ASplitLawFromRestBecomesTwoQuintics) {
  const CamSpec cam = cam_of(changed(feeder, R"({"do":"split","master":60})"));
  EXPECT_EQ(cam.segments[0].law, Law::quintic);
  EXPECT_EQ(cam.segments[1].law, Law::quintic);
  EXPECT_EQ(cam.segments[0].name, "");
  EXPECT_EQ(cam.segments[1].name, "rise");
  EXPECT_NEAR(cam.segments[0].end.slave, 25, 1e-9);                         // by symmetry
  EXPECT_NEAR(*cam.segments[0].end.geo_velocity, 1.7596 * 50 / 120, 1e-4);  // Cv of the law
  EXPECT_NO_THROW((void)design(cam));
}

TEST(CamChange, ASplitDwellRests) {
  const CamSpec cam = cam_of(changed(feeder, R"({"do":"split","master":150})"));
  EXPECT_EQ(cam.segments[1].law, Law::dwell);
  EXPECT_EQ(cam.segments[2].law, Law::dwell);
  EXPECT_EQ(cam.segments[1].end.geo_velocity, std::nullopt);
}

TEST(CamChange, MergeKeepsTheFirstLaw) {
  const CamSpec cam = cam_of(changed(feeder, R"({"do":"merge","segment":1})"));
  ASSERT_EQ(cam.segments.size(), 2U);
  EXPECT_EQ(cam.segments[0].law, Law::modified_sine);
  EXPECT_EQ(cam.segments[0].end.master, 200);
}

TEST(CamChange, DeleteLetsTheNeighborTakeTheRange) {
  const CamSpec middle = cam_of(changed(feeder, R"({"do":"delete","segment":2})"));
  ASSERT_EQ(middle.segments.size(), 2U);
  EXPECT_EQ(middle.segments[1].law, Law::quintic);
  EXPECT_EQ(middle.segments[0].end.master, 120);
  const CamSpec last = cam_of(changed(feeder, R"({"do":"delete","segment":3})"));
  ASSERT_EQ(last.segments.size(), 2U);
  EXPECT_EQ(last.segments[1].law, Law::dwell);
  EXPECT_EQ(last.segments[1].end.master, 360);
}

TEST(CamChange, AppendAddsADwell) {
  const CamSpec cam = cam_of(changed(feeder, R"({"do":"append"})"));
  ASSERT_EQ(cam.segments.size(), 4U);
  EXPECT_EQ(cam.segments[3].law, Law::dwell);
  EXPECT_EQ(cam.segments[3].end.master, 396);
  EXPECT_NO_THROW((void)design(cam));
}

TEST(CamChange, MirrorTwiceIsTheSame) {
  const std::string with = changed(feeder, R"({"do":"split","master":250})");
  for (const char* axis : {"slave", "master"}) {
    const std::string change = std::string(R"({"do":"mirror","axis":")") + axis + "\"}";
    const Cam before = design(cam_of(with)).cam;
    const std::string once = changed(with, change);
    const Cam mirrored = design(cam_of(once)).cam;
    for (const double x : {10.0, 60.0, 150.0, 250.0, 300.0}) {
      const bool slave = std::string(axis) == "slave";
      EXPECT_NEAR(mirrored.jet(x)[0], slave ? 50 - before.jet(x)[0] : before.jet(360 - x)[0], 1e-9);
    }
    const Cam again = design(cam_of(changed(once, change))).cam;
    for (const double x : {10.0, 60.0, 150.0, 250.0, 300.0})
      EXPECT_NEAR(again.jet(x)[1], before.jet(x)[1], 1e-9);
  }
}

TEST(CamChange, ShiftAndScaleKeepTheShape) {
  const std::string with = changed(feeder, R"({"do":"split","master":250})");
  const Cam before = design(cam_of(with)).cam;
  const Cam shifted =
      design(cam_of(changed(changed(with, R"({"do":"shift","axis":"slave","by":7})"),
                            R"({"do":"shift","axis":"master","by":-30})")))
          .cam;
  EXPECT_NEAR(shifted.jet(220)[0], before.jet(250)[0] + 7, 1e-9);
  const Cam scaled =
      design(cam_of(changed(changed(with, R"({"do":"scale","axis":"slave","by":-2})"),
                            R"({"do":"scale","axis":"master","by":0.5})")))
          .cam;
  EXPECT_NEAR(scaled.jet(125)[0], -2 * before.jet(250)[0], 1e-9);
  EXPECT_NEAR(scaled.jet(130)[2], -8 * before.jet(260)[2], 1e-9);
}

TEST(CamChange, EachChangeKeepsTheComments) {
  for (const char* change :
       {R"({"do":"split","master":250})", R"({"do":"append"})", R"({"do":"merge","segment":1})",
        R"({"do":"mirror","axis":"slave"})", R"({"do":"name","segment":1,"name":"up"})"})
    EXPECT_THAT(changed(feeder, change), HasSubstr("  # home\n")) << change;
}

TEST(CamChange, NamesWhatIsWrong) {
  EXPECT_EQ(refused("[]"), "change: must be a JSON object");
  EXPECT_EQ(refused(R"({"do":"jump"})"),
            "do = jump: must be one of numbers, insert, insert_in_plane, remove, move, set, law, "
            "form, name, split, append, merge, delete, mirror, shift, scale, point, switch");
  EXPECT_EQ(refused(R"({"do":"append","x":1})"), "x = 1: is not a key here: the keys are do");
  EXPECT_EQ(refused(R"({"do":"move","knot":4,"master":1,"slave":1})"), "knot = 4: must be 0 to 3");
  EXPECT_EQ(refused(R"({"do":"move","knot":1,"master":"1","slave":1})"),
            "master = \"1\": must be a number");
  EXPECT_EQ(refused(R"({"do":"merge","segment":3})"), "segment = 3: must be 1 to 2");
  EXPECT_EQ(refused(R"({"do":"split","master":120})"), "master = 120: is the position of a knot");
  EXPECT_EQ(refused(R"({"do":"split","master":361})"), "master = 361: must be inside the cam");
  EXPECT_EQ(refused(R"({"do":"scale","axis":"master","by":0})"), "by = 0: must be greater than 0");
  EXPECT_THAT(refused(R"({"do":"law","segment":1,"law":"modsine"})"), HasSubstr("law = modsine: "));
  EXPECT_THAT(refused(R"({"do":"append"})", "jounce = 1\nkind = \"cam\"\n"), HasSubstr("a.toml"));
  EXPECT_THAT(
      refused(R"({"do":"append"})",
              "jounce = 1\nkind = \"move\"\nunits = { position = \"mm\" }\n"
              "[move]\nprofile = \"s_curve\"\nto = 1\nvelocity = 1\nacceleration = 1\njerk = 1\n"),
      HasSubstr("must be \"cam\" for this change"));
}

}  // namespace
}  // namespace jounce::cam_change_test
