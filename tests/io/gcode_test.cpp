// SPDX-License-Identifier: Apache-2.0
#include "jounce/io/gcode.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

namespace jounce::gcode_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

GcodeMachine machine() {
  return {.axes = {{"x", "mm"}, {"y", "mm"}, {"z", "mm"}, {"c", "deg"}}, .path_axes = 3};
}

GcodeProgram parsed(const std::string& text, const GcodeMachine& of = machine()) {
  return parse_gcode(text, "part.ngc", of);
}

std::string complaint(const std::string& text, const GcodeMachine& of = machine()) {
  try {
    (void)parsed(text, of);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

Point end_of(const std::string& text) {
  return parsed(text).program.position();
}

TEST(Gcode, ReadsLinesWithTheirFeedCornerAndSourceLine) {
  const GcodeProgram made = parsed(
      "%\n(a part) ; of two lines\nN10 G21 G90 G64 P0.05\nN20 g1 x100 F6000\n\nY 50 ; up\nG61 "
      "X0\n");
  const Program& program = made.program;
  ASSERT_EQ(program.commands().size(), 3U);
  EXPECT_EQ(program.commands()[0].line, 4);
  EXPECT_EQ(program.commands()[1].line, 6);
  EXPECT_THAT(program.position(), ElementsAre(0, 50, 0, 0, 0, 0, 0, 0, 0));
  const PathSettings& first = program.settings()[program.commands()[0].settings];
  EXPECT_DOUBLE_EQ(first.velocity, 100);  // mm/s
  EXPECT_EQ(first.corner, Corner::deviation);
  EXPECT_DOUBLE_EQ(first.value, 0.05);
  EXPECT_EQ(program.settings()[program.commands()[2].settings].corner, Corner::stop);
}

TEST(Gcode, EndsAtASecondPercentSign) {
  EXPECT_EQ(parsed("%\nG1 X10 F100\n%\nX99\n").program.position()[0], 10);
  EXPECT_EQ(parsed("G1 X10 F100\n%\nX99\n").program.position()[0], 10);
  EXPECT_EQ(parsed("\n(title)\n%\nG1 X10 F100\n").program.position()[0], 10);
  EXPECT_NE(complaint("%\nG1 X10 F100\n% X99\n"), "none");
}

TEST(Gcode, TakesNoNoticeOfTheNumberOfTheProgram) {
  for (const char* head : {"%\nO1234\n", "%\nO1234 (PLATE)\n", "o0001\n", "%1000\n", "% (PLATE)\n"})
    EXPECT_EQ(parsed(std::string(head) + "G1 X10 F100\nM30\n%\n").program.commands().size(), 1U)
        << head;
  EXPECT_THAT(complaint("O1\nO2\n"),
              HasSubstr("part.ngc:2:1: O2: is the number of a subprogram, which is not supported"));
  EXPECT_THAT(complaint("G1 X10 F100\nO1\n"), HasSubstr("part.ngc:2:1: O1: is the number of"));
  EXPECT_THAT(complaint("O1 G1 X10 F100\n"),
              HasSubstr("subprograms, loops and conditions are not"));
  EXPECT_THAT(complaint("%X1\n"), HasSubstr("part.ngc:1:2: \"X1\": must not follow %"));
}

TEST(Gcode, StopsAtTangentJointsByG61Point1Only) {
  const Program program =
      parsed("G61 G1 X1 F60\nX2\nG61.1 X3\nX4\nG61 X5\nG61.1 X6\nG64 P0.1 X7\n").program;
  std::vector<Junction> junctions;
  for (const Program::Command& c : program.commands())
    junctions.push_back(program.settings()[c.settings].junction);
  constexpr Junction passed = Junction::look_ahead;
  constexpr Junction rest = Junction::buffered;
  EXPECT_THAT(junctions, ElementsAre(passed, passed, rest, rest, passed, rest, passed));
}

TEST(Gcode, CountsInInchesFromG20On) {
  const Program program = parsed("G20 G64 P0.002\nG1 X1 C90 F60\nG21 Y25.4\n").program;
  EXPECT_THAT(program.position(), ElementsAre(25.4, 25.4, 0, 90, 0, 0, 0, 0, 0));
  const PathSettings& first = program.settings()[program.commands()[0].settings];
  EXPECT_DOUBLE_EQ(first.velocity, 25.4);
  EXPECT_DOUBLE_EQ(first.value, 0.0508);
}

TEST(Gcode, AddsIncrementsAndOffsets) {
  GcodeMachine with = machine();
  with.frames[0] = Frame{.offset = {10, 20, 0}};
  with.frames[2] = Frame{.offset = {-5, 0, 0}};
  EXPECT_THAT(parsed("G0 X1 Y1\nG91 X2\nG90 G56 Y7\n", with).program.position(),
              ElementsAre(13, 7, 0, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT(complaint("G0 X1\nG55 Y1\n", with), HasSubstr("part.ngc:2:1: G55: needs an offset"));
  EXPECT_EQ(end_of("G54 G0 X1")[0], 1);
}

TEST(Gcode, TurnsClockwiseByG2AndCounterclockwiseByG3) {
  const Program program =
      parsed("F600\nG2 X10 Y0 I5\nG3 X10 Y10 R5\nG3 X10 Y-10 Z4 R-10.5\n").program;
  ASSERT_EQ(program.arcs().size(), 3U);
  // G2 from the left to the right of its center passes above it; G3 from below to above passes on the right.
  EXPECT_NEAR(point_at(program.arcs()[0], std::numbers::pi / 2)[1], 5, 1e-12);
  EXPECT_NEAR(point_at(program.arcs()[1], std::numbers::pi / 2)[0], 15, 1e-12);
  EXPECT_GT(program.arcs()[2].sweep, std::numbers::pi);
  EXPECT_DOUBLE_EQ(program.arcs()[2].drift[2], 4);
}

TEST(Gcode, TakesARadiusThatIsRoundedDownForAHalfCircle) {
  const Arc arc =
      parsed("F600\nG2 X7 Y7 R4.94974\n").program.arcs()[0];  // half the chord: 4.949747...
  EXPECT_NEAR(arc.sweep, std::numbers::pi, 1e-9);
  EXPECT_THAT(complaint("F600\nG2 X7 Y7 R4.9\n"),
              HasSubstr("must be at least 4.94975 mm, half the distance from the start"));
}

TEST(Gcode, TakesTheCenterInTheSelectedPlane) {
  // G18: from Z to X; counterclockwise from +X by a quarter is -Z.
  const Arc arc = parsed("F600\nG0 X10\nG18 G3 X0 Z-10 I-10 K0\n").program.arcs()[0];
  EXPECT_NEAR(arc.sweep, std::numbers::pi / 2, 1e-12);
  const Arc absolute = parsed("F600\nG0 X10 Y3\nG90.1 G3 X-10 Y3 I0 J3\n").program.arcs()[0];
  EXPECT_NEAR(absolute.radius, 10, 1e-12);
  EXPECT_NEAR(parsed("F600 G2 I3\n").program.arcs()[0].sweep, 2 * std::numbers::pi, 1e-12);
  EXPECT_THAT(complaint("F600 G2 X1 K1\n"), HasSubstr("part.ngc:1:12: K1: is outside the plane"));
}

TEST(Gcode, HasTwoFeedsAndTwoAccelerations) {
  GcodeMachine seconds = machine();
  seconds.feed_time = 1;
  const Program program =
      parsed("F30000 E300000 FF50000 EF500000\nG0 X50000\nG1 X0\n", seconds).program;
  const PathSettings& rapid = program.settings()[program.commands()[0].settings];
  const PathSettings& feed = program.settings()[program.commands()[1].settings];
  EXPECT_EQ(rapid.velocity, 50000);
  EXPECT_EQ(rapid.acceleration, 500000);
  EXPECT_EQ(feed.velocity, 30000);
  EXPECT_EQ(feed.deceleration, 300000);
}

TEST(Gcode, CountsInTheUnitOfTimeOfTheProgram) {
  GcodeMachine ms = machine();
  ms.second = 1000;
  const Program program = parsed("G1 X1 F60 E2000\nG4 P0.5\n", ms).program;
  EXPECT_DOUBLE_EQ(program.settings()[0].velocity, 0.001);      // mm/ms
  EXPECT_DOUBLE_EQ(program.settings()[0].acceleration, 0.002);  // mm/ms^2
  EXPECT_DOUBLE_EQ(program.numbers()[program.commands()[1].data], 500);
}

TEST(Gcode, CountsFInTheUnitOfAFollowerThatMovesAlone) {
  const Program program = parsed("G20 F60\nG1 C180\nX1\n").program;
  EXPECT_DOUBLE_EQ(program.settings()[program.commands()[0].settings].velocity, 1);     // deg/s
  EXPECT_DOUBLE_EQ(program.settings()[program.commands()[1].settings].velocity, 25.4);  // mm/s
}

TEST(Gcode, KeepsOtherWordsAsEvents) {
  const GcodeProgram made =
      parsed("T1 M6\nS12000 M3\nG0 X1 H3\nM8\nM1\nG0 X2\nM30\nthis is not read\n");
  std::vector<std::string> words;
  std::vector<int> lines;
  for (const GcodeEvent& event : made.events) {
    words.push_back(event.word);
    lines.push_back(event.line);
  }
  EXPECT_THAT(words, ElementsAre("T1", "M6", "S12000", "M3", "H3", "M8", "M1", "M30"));
  EXPECT_THAT(lines, ElementsAre(1, 1, 2, 2, 3, 4, 5, 7));
  ASSERT_EQ(made.program.commands().size(), 3U);
  EXPECT_EQ(made.program.commands()[1].kind, Program::Kind::dwell);  // M1 rests
}

TEST(Gcode, EventsHaveTheirPlaceAmongTheCommands) {
  const GcodeProgram made = parsed("M6\nG0 X1 H3\nX2 M0 H-3\nM8\nX3 M1\nM30\n");
  std::vector<std::string> places;
  for (const GcodeEvent& event : made.events)
    places.push_back(event.word + " " + std::to_string(event.command));
  // M0 and M1 apply at the end of their block, after their rest: a command of its own.
  EXPECT_THAT(places, ElementsAre("M6 0", "H3 0", "H-3 1", "M0 3", "M8 3", "M1 5", "M30 5"));
  EXPECT_EQ(made.events[2].number, -3);
  EXPECT_THAT(complaint("G1 X1 F60 H0\n"), HasSubstr("H0: must be the number of an output"));
  EXPECT_THAT(complaint("G1 X1 F60 M-1\n"), HasSubstr("M-1: must be a whole number"));
}

TEST(Gcode, LeavesOutMovesThatMoveNothing) {
  EXPECT_EQ(parsed("G0 X0 Y0\nG1 X1 F60\nX1\n").program.commands().size(), 1U);
}

TEST(Gcode, RejectsEverythingElseWithItsPlace) {
  EXPECT_THAT(complaint("G1 X1 F60\nG5 X2\n"),
              HasSubstr("part.ngc:2:1: G5: a spline is not supported"));
  EXPECT_THAT(complaint("N1 G1\nG1 X1 N2\n"),
              HasSubstr("part.ngc:2:7: N2: must be the first word"));
  EXPECT_THAT(complaint("G1 X1\n"), HasSubstr("part.ngc:1:1: F: is missing"));
  EXPECT_THAT(complaint("X1\n"),
              HasSubstr("part.ngc:1:1: X1: needs a motion: write G0, G1, G2 or G3 before it"));
  EXPECT_THAT(complaint("G1 X1 X2 F6\n"),
              HasSubstr("part.ngc:1:7: X2: is the second X of this block"));
  EXPECT_THAT(complaint("G0 G1 X2\n"), HasSubstr("part.ngc:1:4: G1: contradicts"));
  EXPECT_THAT(complaint("G1 X#1\n"), HasSubstr("part.ngc:1:4: \"X#\": needs a number after X"));
  EXPECT_THAT(complaint("G1 X1.2.3\n"), HasSubstr("part.ngc:1:8: \".\": is not a G-code word"));
  EXPECT_THAT(complaint("G1 A5\n"),
              HasSubstr("part.ngc:1:4: A5: moves an axis that the machine does not have"));
  EXPECT_THAT(complaint("G1 X1 (open\n"),
              HasSubstr("part.ngc:1:7: \"(open\": is a comment without its closing )"));
  EXPECT_THAT(
      complaint("G1 X5 P1\n"),
      HasSubstr("part.ngc:1:7: P1: does not apply to this block: P is the time of a dwell"));
  EXPECT_THAT(complaint("M98 P100\n"),
              HasSubstr("part.ngc:1:1: M98: subprograms are not supported: have the CAM program"));
  EXPECT_THAT(complaint("o100 sub\n"),
              HasSubstr("part.ngc:1:1: \"o100 sub\": subprograms, loops and conditions are not"));
  EXPECT_THAT(complaint("G1 X10 Y1O F100\n"),
              HasSubstr("part.ngc:1:10: \"O\": follows a number: is this letter a 0?"));
  EXPECT_THAT(complaint("G1 X F100\n"),
              HasSubstr("part.ngc:1:4: \"X\": needs a number after X, such as X10"));
  EXPECT_THAT(complaint("G1 X10,5 F100\n"),
              HasSubstr("part.ngc:1:7: \"X10,5\": a number has a decimal point: write X10.5"));
  EXPECT_THAT(complaint("G4 P-1\n"), HasSubstr("part.ngc:1:4: P-1: must not be negative"));
  EXPECT_THAT(complaint("G4 X1\n"), HasSubstr("part.ngc:1:1: G4: needs P"));
  EXPECT_THAT(complaint("G4 G64 P1\n"), HasSubstr("part.ngc:1:1: G64: must not be in the block"));
  EXPECT_THAT(complaint("G64\n"), HasSubstr("part.ngc:1:1: G64: needs the greatest deviation"));
  EXPECT_THAT(complaint("F0\n"), HasSubstr("part.ngc:1:1: F0: must be greater than 0"));
  EXPECT_THAT(complaint("F60 G2 X1\n"),
              HasSubstr("part.ngc:1:8: X1: needs the center (I J K) or the radius (R)"));
  EXPECT_THAT(complaint("F60 G1 X1 I1\n"), HasSubstr("part.ngc:1:11: I1: applies to an arc"));
  EXPECT_THAT(complaint("F60 G2 X1 I1 R1\n"),
              HasSubstr("part.ngc:1:14: R1: cannot be combined with I, J, K"));
  EXPECT_THAT(
      complaint("F60 G2 X10 R1\n"),
      HasSubstr("part.ngc:1:12: R1: must be at least 5 mm, half the distance from the start (0, 0) "
                "to the end (10, 0)"));
  EXPECT_THAT(complaint("F60 G2 X10 I2\n"),
              HasSubstr("part.ngc:1:12: I2: is 2 mm from the start and 8 mm from the end"));
  EXPECT_THAT(complaint("G20\nF60 G2 X10 I2\n"),
              HasSubstr("part.ngc:2:12: I2: is 2 in from the start and 8 in from the end"));
  EXPECT_THAT(complaint("G1 X1e5 F60\n"), HasSubstr("part.ngc:1:6: \"E\": follows a number"));
  EXPECT_THAT(complaint("WHILE\n"), HasSubstr("part.ngc:1:1: \"WHILE\": is not a G-code word"));
  EXPECT_THAT(complaint("#1 = 3\n"), HasSubstr("part.ngc:1:1: \"#\": variables (#1) and"));
  EXPECT_THAT(complaint("/G1 X1\n"), HasSubstr("part.ngc:1:1: \"/\": skips a block"));
  EXPECT_THAT(complaint("G1 X1,000.5 F9\n"),
              HasSubstr("part.ngc:1:6: \",\": must not divide a number"));
  EXPECT_THAT(complaint("G1 X" + std::string(400, '9') + "\n"), HasSubstr("part.ngc:1:4"));
  EXPECT_THAT(complaint("G1 X1\xff\n"), HasSubstr("part.ngc:1:6: \"?\": is not a G-code word"));
}

TEST(Gcode, NamesTheMeaningOfUnsupportedWords) {
  EXPECT_EQ(complaint("G21 G90\nG41 D1\n"),
            "part.ngc:2:1: G41: cutter radius compensation is not supported: have the CAM program "
            "write the compensated path");
  for (const auto& [word, meaning] : {std::pair{"G43", "tool length compensation"},
                                      {"G53", "machine coordinates"},
                                      {"G81", "a drilling cycle"},
                                      {"G92.1", "a shift of the coordinates"},
                                      {"G95", "a feed per revolution"},
                                      {"G7", "is not supported: use G0 to G4"}})
    EXPECT_THAT(complaint(word), HasSubstr(meaning)) << word;
  EXPECT_THAT(complaint("G1 X1 D3\n"), HasSubstr("part.ngc:1:7: D3: a tool number"));
}

TEST(Gcode, RejectsAnEndBeyondThePositionLimitsOfAnAxis) {
  GcodeMachine limited = machine();
  limited.axes[2].position_min = -100;
  limited.axes[2].position_max = 50;
  EXPECT_EQ(complaint("G0 X1 Z-200\n", limited),
            "part.ngc:1:7: Z-200: moves axis z to -200 mm, below its position_min, -100 mm: change "
            "the program or its offset");
  EXPECT_THAT(complaint("G91 G0 Z30\nZ30\n", limited),
              HasSubstr("part.ngc:2:1: Z30: moves axis z to 60 mm, above its position_max, 50 mm"));
  EXPECT_EQ(complaint("G0 X9999 Z-100\nZ50\n", limited), "none");
}

TEST(Gcode, APositionLimitHoldsInTheMachineBehindTheFrame) {
  GcodeMachine limited = machine();
  limited.axes[1].position_max = 50;
  limited.axes[2].position_max = 50;
  limited.frames[0] = turned_frame({100, 0, 5}, 90);
  EXPECT_THAT(complaint("G0 X50 Y900 Z45\nX60\n", limited),
              HasSubstr("part.ngc:2:1: X60: moves axis y to 60 mm, above its position_max, 50 mm"));
  EXPECT_THAT(complaint("G0 Z46\n", limited), HasSubstr("Z46: moves axis z to 51 mm"));
  limited.frames[0] = Frame{.offset = {0, 0, -10}};
  EXPECT_EQ(complaint("G0 X900 Z60\nG91 Z-5\n", limited), "none");
  EXPECT_THAT(complaint("G0 Z61\n", limited), HasSubstr("Z61: moves axis z to 51 mm"));
}

TEST(Gcode, NeedsALengthForG20AndLettersForItsAxes) {
  GcodeMachine pulses{.axes = {{"X", "pulse"}}};
  EXPECT_THAT(complaint("G21\n", pulses), HasSubstr("part.ngc:1:1: G21: needs axes"));
  pulses.axes[0].name = "gantry";
  EXPECT_THAT(complaint("G0\n", pulses), HasSubstr("axis[1].name"));
}

TEST(Gcode, IsRecognizedByItsFirstWord) {
  for (const char* text : {"%\nG0", "(part)", "N10 G1", "\n\n g21", "G1X2"})
    EXPECT_TRUE(begins_as_gcode(text)) << text;
  for (const char* text : {"jounce = 1", "", "time,position\n", "# G1", "[path]"})
    EXPECT_FALSE(begins_as_gcode(text)) << text;
}

TEST(Gcode, AFrameTurnsLinesArcsAndRelativeMoves) {
  GcodeMachine with = machine();
  with.frames[0] = turned_frame({100, 0, 5}, 90);
  with.frames[1] = Frame{.offset = {1, 2, 3}};
  const Program lines = parsed("G1 X10 Y2 Z1 F600\nG91 X5\nG90 Y0\n", with).program;
  ASSERT_EQ(lines.commands().size(), 3U);
  EXPECT_THAT(lines.position(), ElementsAre(100, 15, 6, 0, 0, 0, 0, 0, 0));
  // A quarter turn counterclockwise from the part's (10, 0) to (0, 10): center the part's origin.
  const Program arc = parsed("G1 X10 Y0 F600\nG3 X0 Y10 I-10 J0\n", with).program;
  ASSERT_EQ(arc.arcs().size(), 1U);
  EXPECT_NEAR(arc.arcs()[0].center[0], 100, 1e-12);
  EXPECT_NEAR(arc.arcs()[0].center[1], 0, 1e-12);
  EXPECT_NEAR(arc.arcs()[0].sweep, std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(arc.position()[0], 90, 1e-12);
  EXPECT_NEAR(arc.position()[1], 0, 1e-12);
  // Another frame begins where the machine is.
  const Program both = parsed("G1 X10 Y0 Z0 F600\nG55 X4\n", with).program;
  EXPECT_THAT(both.position(), ElementsAre(5, 10, 5, 0, 0, 0, 0, 0, 0));
  // A word of the follower leaves the others where they are.
  const Program follower = parsed("G1 X3 Y4 F600\nC90\n", with).program;
  EXPECT_EQ(follower.position()[0], follower.numbers()[0]);
  EXPECT_EQ(follower.position()[3], 90);
}

TEST(Gcode, ARotaryAxisTakesTheShortestWayInG90) {
  GcodeMachine rotary = machine();
  rotary.axes[3].modulo = 360;
  EXPECT_EQ(parsed("G1 C350 F600\nC10\n", rotary).program.position()[3], 10);
  EXPECT_EQ(parsed("G1 C100 F600\nC200\nC350\n", rotary).program.position()[3], 350);
  EXPECT_EQ(parsed("G1 C100 F600\nC200\nC350\nC10\n", rotary).program.position()[3], 370);
  EXPECT_EQ(parsed("G91 G1 C720 F600\n", rotary).program.position()[3], 720);
}

}  // namespace
}  // namespace jounce::gcode_test
