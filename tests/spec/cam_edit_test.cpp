// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/detail/cam_edit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::cam_edit_test {
namespace {

using ::testing::HasSubstr;

constexpr const char* text = R"(jounce = 1   # the format
kind = "cam"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }

# About the rise.
[[segment]]  # é: two bytes, one column
name = "rise"
law = "modified_sine"
end = { master = "0.25 rev", slave = 50 } # keep me

# About the return.
[[segment]]
law = "quintic"
[segment.end]
master = 360
slave = "5 cm"    # in cm

# About the limits.
[limits]
geo_velocity = 1
)";

const CamSpec& cam_of(const Spec& spec) {
  return std::get<CamSpec>(spec.subject);
}

/// The text after a change of its cam.
template <class Change>
std::string changed(const std::string& of, Change change) {
  const Spec spec = parse_spec(of, "a.toml");
  CamSpec cam = cam_of(spec);
  change(cam);
  return with_cam(spec, cam);
}

/// The text with one replacement.
std::string replaced(std::string of, const std::string& what, const std::string& with) {
  const auto at = of.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return of.replace(at, what.size(), with);
}

TEST(WithCam, LeavesAnUnchangedTextAlone) {
  EXPECT_EQ(changed(text, [](CamSpec&) {}), text);
}

TEST(WithCam, ChangesOneNumberInItsUnit) {
  EXPECT_EQ(changed(text, [](CamSpec& cam) { cam.segments[0].end.master = 99; }),
            replaced(text, "0.25 rev", "0.275 rev"));
  EXPECT_EQ(changed(text, [](CamSpec& cam) { cam.segments[1].end.slave = 12; }),
            replaced(text, "\"5 cm\"", "\"1.2 cm\""));
  EXPECT_EQ(changed(text, [](CamSpec& cam) { cam.segments[0].end.slave = 0.1 + 0.2; }),
            replaced(text, "slave = 50", "slave = 0.3"));
}

TEST(WithCam, AddsAndRemovesDerivatives) {
  const std::string with = changed(text, [](CamSpec& cam) {
    cam.segments[0].end.geo_velocity = 1.5;
    cam.segments[0].end.geo_acceleration = -0.25;
  });
  EXPECT_EQ(with, replaced(text, "slave = 50 }",
                           "slave = 50, geo_velocity = 1.5, geo_acceleration = -0.25 }"));
  EXPECT_EQ(changed(with,
                    [](CamSpec& cam) {
                      cam.segments[0].end.geo_velocity.reset();
                      cam.segments[0].end.geo_acceleration.reset();
                    }),
            text);
}

TEST(WithCam, ChangesLawFormAndName) {
  const std::string with = changed(text, [](CamSpec& cam) {
    cam.segments[0].law = Law::scca;
    cam.segments[0].form = {.straight = 0.1, .shares = {{0.25, 0.5, 0.25}}};
    cam.segments[0].name.clear();
    cam.segments[1].name = "a \"name\"";
  });
  const CamSpec cam = cam_of(parse_spec(with, "a.toml"));
  EXPECT_EQ(cam.segments[0].law, Law::scca);
  EXPECT_EQ(cam.segments[0].form.straight, 0.1);
  EXPECT_EQ(cam.segments[0].form.shares, (std::array{0.25, 0.5, 0.25}));
  EXPECT_EQ(cam.segments[0].name, "");
  EXPECT_EQ(cam.segments[1].name, "a \"name\"");
  EXPECT_THAT(with, HasSubstr("# About the return.\n[[segment]]\nlaw = \"quintic\"\n"));
}

constexpr const char* with_speeds = R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0, velocity = "0.1 m/s" }
[[segment]]
law = "line"
end = { master = 180, velocity = 100 }
[[segment]]
law = "quintic"
end = { master = 360, slave = 0 }
[master]
velocity = 90
)";

TEST(WithCam, KeepsDerivativesOverTime) {
  EXPECT_EQ(changed(with_speeds, [](CamSpec& cam) { cam.start.geo_velocity = 2; }),
            replaced(with_speeds, "0.1 m/s", "0.18 m/s"));
}

TEST(WithCam, ChangesTheSpeedOfALineThatGivesNoPosition) {
  // 100 mm/s at 90 deg/s: 200 mm at 180 deg. 180 mm at the same place: 90 mm/s.
  ASSERT_EQ(cam_of(parse_spec(with_speeds, "a.toml")).segments[0].end.slave, 200);
  EXPECT_EQ(changed(with_speeds, [](CamSpec& cam) { cam.segments[0].end.slave = 180; }),
            replaced(with_speeds, "velocity = 100", "velocity = 90"));
  EXPECT_EQ(changed(with_speeds,
                    [](CamSpec& cam) {
                      cam.segments[0].end.master = 90;
                      cam.segments[0].end.slave = 100;
                    }),
            replaced(with_speeds, "master = 180", "master = 90"));
}

TEST(WithCam, ChangesPointsOfTheText) {
  const std::string spline =
      replaced(text, "law = \"quintic\"\n",
               "law = \"quintic_spline\"\npoints = [ { master = 120, slave = "
               "45 }, { master = 200, slave = 20 } ]  # measured\n");
  EXPECT_EQ(changed(spline, [](CamSpec& cam) { cam.segments[1].points[1].slave = 21.5; }),
            replaced(spline, "slave = 20 }", "slave = 21.5 }"));
}

TEST(WithSwitch, ChangesTheEdgesOfASwitch) {
  const std::string with =
      std::string(text) +
      "\n[switches]\nof = \"master\"\n[[switch]]\ntrack = 1\nfirst_on_position = 30  # "
      "glue\nlast_on_position = \"0.25 rev\"\n";
  const Spec spec = parse_spec(with, "a.toml");
  EXPECT_EQ(with_switch(spec, 0, 45, 90),
            replaced(with, "first_on_position = 30", "first_on_position = 45"));
  EXPECT_EQ(with_switch(spec, 0, 30, 180),
            replaced(with, "last_on_position = \"0.25 rev\"", "last_on_position = \"0.5 rev\""));
  EXPECT_THAT(test::why([&] { (void)with_switch(spec, 1, 0, 1); }), HasSubstr("must be 1 to 1"));
}

TEST(WithCam, RejectsAnotherNumberOfPoints) {
  EXPECT_THAT(test::why([] {
                (void)changed(text, [](CamSpec& cam) { cam.segments[1].points.resize(1); });
              }),
              HasSubstr("a.toml:13:1: segment[2].points: must keep the number of its points"));
}

// ---- segments -----------------------------------------------------------------------------------

const CamSegment dwell{Law::dwell, {90.5, 50}};

TEST(WithSegment, InsertsAboveTheCommentOfTheNext) {
  EXPECT_EQ(with_segment(text, 1, dwell),
            replaced(text, "# About the return.",
                     "[[segment]]\nlaw = \"dwell\"\nend = { master = 90.5, slave = 50 }\n\n"
                     "# About the return."));
}

TEST(WithSegment, AppendsBehindTheLast) {
  EXPECT_EQ(with_segment(text, 2, {Law::quintic, {400, 1, 0.5, 0}, "new"}),
            replaced(text, "# in cm\n",
                     "# in cm\n\n[[segment]]\nname = \"new\"\nlaw = \"quintic\"\nend = { master = "
                     "400, slave = 1, geo_velocity = 0.5, geo_acceleration = 0 }\n"));
}

TEST(WithSegment, EndsALineThatTheFileLeavesOpen) {
  const std::string open =
      replaced(text, "\n# About the limits.\n[limits]\ngeo_velocity = 1\n", "");
  const std::string last = open.substr(0, open.size() - 1);
  EXPECT_EQ(cam_of(parse_spec(with_segment(last, 2, dwell), "a.toml")).segments.size(), 3U);
}

TEST(WithSegment, KeepsLineEndsOfWindows) {
  std::string windows = text;
  for (std::size_t at = 0; (at = windows.find('\n', at)) != std::string::npos; at += 2)
    windows.insert(at, 1, '\r');
  const std::string with = with_segment(windows, 1, dwell);
  for (std::size_t at = 0; (at = with.find('\n', at)) != std::string::npos; ++at)
    ASSERT_EQ(with[at - 1], '\r') << at;
}

TEST(WithoutSegment, KeepsTheCommentsAbove) {
  EXPECT_EQ(without_segment(text, 0), replaced(text,
                                               "[[segment]]  # é: two bytes, one column\n"
                                               "name = \"rise\"\n"
                                               "law = \"modified_sine\"\n"
                                               "end = { master = \"0.25 rev\", slave = 50 } # keep "
                                               "me\n",
                                               ""));
  EXPECT_EQ(without_segment(text, 1), replaced(text,
                                               "[[segment]]\n"
                                               "law = \"quintic\"\n"
                                               "[segment.end]\n"
                                               "master = 360\n"
                                               "slave = \"5 cm\"    # in cm\n",
                                               ""));
}

TEST(WithoutSegment, IsTheInverseOfWithSegment) {
  for (const std::size_t at : {0U, 1U, 2U})
    EXPECT_EQ(without_segment(with_segment(text, at, dwell), at), text) << at;
}

constexpr const char* with_inline = R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
segment = [
  { law = "345", end = { master = 90, slave = 50 } },  # up
  { law = "345", end = { master = 360, slave = 0 } }
]
)";

TEST(InlineSegments, AreInsertedOnLinesOfTheirOwn) {
  const std::string entry = "{ law = \"dwell\", end = { master = 90.5, slave = 50 } }";
  EXPECT_EQ(with_segment(with_inline, 1, dwell),
            replaced(with_inline, "  { law = \"345\", end = { master = 360",
                     "  " + entry + ",\n  { law = \"345\", end = { master = 360"));
  const std::string appended = with_segment(with_inline, 2, dwell);
  EXPECT_EQ(appended,
            replaced(with_inline, "slave = 0 } }\n", "slave = 0 } },\n  " + entry + "\n"));
  EXPECT_EQ(without_segment(with_segment(with_inline, 1, dwell), 1), with_inline);
}

TEST(InlineSegments, AreRemovedWithTheirComma) {
  for (const std::size_t at : {0U, 1U}) {
    const CamSpec cam = cam_of(parse_spec(without_segment(with_inline, at), "a.toml"));
    ASSERT_EQ(cam.segments.size(), 1U);
    EXPECT_EQ(cam.segments[0].end.master, at == 0 ? 360 : 90);
  }
  const std::string one_line =
      replaced(with_inline, "[\n  { law = \"345\", end = { master = 90, slave = 50 } },  # up\n  ",
               "[{ law = \"345\", end = { master = 90, slave = 50 } }, ");
  EXPECT_EQ(cam_of(parse_spec(without_segment(one_line, 0), "a.toml")).segments.size(), 1U);
  EXPECT_EQ(cam_of(parse_spec(with_segment(one_line, 0, dwell), "a.toml")).segments.size(), 3U);
}

}  // namespace
}  // namespace jounce::cam_edit_test
