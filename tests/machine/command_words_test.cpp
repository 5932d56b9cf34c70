// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/detail/command_words.hpp"

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/base/input_errors.hpp"

#include "support/errors.hpp"

namespace jounce::command_words_test {
namespace {

using testing::Contains;
using testing::HasSubstr;

const Units mm{"deg", "mm"};

TEST(CommandWords, AMoveHasItsValuesInTheUnitsOfTheAxis) {
  const CommandWords words{.what = "move",
                           .options = {{"to", "12cm"}, {"velocity", "0.2 m/s"}, {"blend", "next"}}};
  require_taken(words);
  const auto move = std::get<command::MoveAbsolute>(command_of(words, mm));
  EXPECT_DOUBLE_EQ(move.position, 120);
  EXPECT_DOUBLE_EQ(move.dynamics.velocity, 200);
  EXPECT_EQ(move.buffer, BufferMode::blending_next);
}

TEST(CommandWords, TheFirstOptionSelectsTheCommand) {
  EXPECT_EQ(kind_of(command_of({.what = "move", .options = {{"by", "5"}}}, mm)),
            CommandKind::move_relative);
  EXPECT_EQ(kind_of(command_of({.what = "inch", .value = "5"}, mm)), CommandKind::move_relative);
  EXPECT_EQ(kind_of(command_of({.what = "enable"}, mm)), CommandKind::enable);
  EXPECT_EQ(test::key_of([] {
              command_of({.what = "move", .options = {{"to", "5"}, {"by", "5"}}}, mm);
            }),
            "--by");
  EXPECT_THAT(test::rule_of([] { command_of({.what = "move"}, mm); }),
              HasSubstr("needs one of --to, --by"));
}

TEST(CommandWords, ACutHasAtMostOneNumber) {
  const Units units{"m", "mm"};
  CommandWords words{.what = "cut", .value = "", .options = {{"position", "9.5m"}}, .flags = {}};
  const auto cut = std::get<command::Cut>(command_of(words, units));
  EXPECT_EQ(cut.position, 9.5);
  EXPECT_TRUE(std::isnan(cut.length) && std::isnan(cut.waste));
  words.options["waste"] = "1m";
  EXPECT_EQ(test::error_of([&] { (void)command_of(words, units); }),
            "--waste = 1m: cannot be combined with --position: give at most one of --length, "
            "--position, --waste");
}

// The tool of a SCARA with three arms: x and y in mm, the direction c of the last arm in deg.
TEST(CommandWords, EachCoordinateOfAGroupHasItsUnit) {
  const std::vector<std::string> axes{"x", "y", "c"};
  const std::vector<std::string> units{"mm", "mm", "deg"};
  CommandWords words{.what = "move-linear"};
  set_values(words, {"c=0.5rev", "x=1cm"});
  ASSERT_TRUE(has_coordinates(words));
  const auto line = std::get<command::MoveLinearAbsolute>(command_of(words, mm, axes, units));
  EXPECT_DOUBLE_EQ(line.to[0], 10);
  EXPECT_TRUE(std::isnan(line.to[1]));
  EXPECT_DOUBLE_EQ(line.to[2], 180);

  CommandWords wrong{.what = "move-linear"};
  set_values(wrong, {"c=10mm"});
  EXPECT_EQ(test::error_of([&] { (void)command_of(wrong, mm, axes, units); }),
            "c = 10mm: mm is not a unit of this quantity: give the value in deg");
  const CommandWords listed{.what = "move-linear", .options = {{"to", "1cm,,10deg"}}};
  EXPECT_TRUE(has_coordinates(listed));
  EXPECT_DOUBLE_EQ(std::get<command::MoveLinearAbsolute>(command_of(listed, mm, {}, units)).to[2],
                   10);
  EXPECT_FALSE(has_coordinates({.what = "move", .options = {{"to", "10"}}}));
}

// The rates of a move of followers alone, and of limits of one axis, have the unit of this axis.
TEST(CommandWords, TheRatesOfAFollowerHaveItsUnit) {
  const std::vector<std::string> axes{"x", "y", "c"};
  const std::vector<std::string> units{"mm", "mm", "deg"};
  const auto velocity = [&](const std::vector<std::string>& values, const std::string& text) {
    CommandWords words{.what = "move-linear", .options = {{"velocity", text}}};
    set_values(words, values);
    return std::get<command::MoveLinearAbsolute>(command_of(words, mm, axes, units))
        .path.along.velocity;
  };
  EXPECT_DOUBLE_EQ(velocity({"c=90"}, "0.5rev/s"), 180);
  EXPECT_DOUBLE_EQ(velocity({"c=90", "x=1"}, "5cm/s"), 50);
  EXPECT_EQ(test::error_of([&] { (void)velocity({"c=90"}, "45mm/s"); }),
            "--velocity = 45mm/s: mm/s is not a unit of this quantity: give the value in deg/s");
  EXPECT_THAT(test::error_of([&] {
                (void)velocity({"c=90", "x=1"}, "45deg/s");
              }),
              HasSubstr("give the value in mm/s"));
  const CommandWords by{.what = "move-linear",
                        .options = {{"by", "c=90"}, {"velocity", "45deg/s"}}};
  EXPECT_DOUBLE_EQ(
      std::get<command::MoveLinearRelative>(command_of(by, mm, axes, units)).path.along.velocity,
      45);
  CommandWords jog{.what = "jog", .value = "0.5rev/s", .options = {{"along", ",,1"}}};
  set_values(jog, {jog.value});
  EXPECT_DOUBLE_EQ(std::get<command::GroupJog>(command_of(jog, mm, axes, units)).dynamics.velocity,
                   180);
  CommandWords circle{.what = "move-circular",
                      .options = {{"center", "x=5,y=0"}, {"velocity", "2cm/s"}}};
  set_values(circle, {"c=90"});
  EXPECT_DOUBLE_EQ(std::get<command::MoveCircularAbsolute>(command_of(circle, mm, axes, units))
                       .path.along.velocity,
                   20)
      << "a whole circle turns c, and its velocity is that in the plane";
  for (const char* const axis : {"c", "3"}) {
    const CommandWords limits{.what = "set-limits",
                              .options = {{"axis", axis}, {"velocity", "1rev/s"}}};
    EXPECT_TRUE(has_coordinates(limits)) << "the units of the axes are needed";
    const auto set = std::get<command::GroupSetLimits>(command_of(limits, mm, axes, units));
    EXPECT_EQ(set.axis, 3);
    EXPECT_DOUBLE_EQ(set.dynamics.velocity, 360);
  }
}

TEST(CommandWords, AMoveOfAGroupHasCoordinates) {
  const CommandWords words{.what = "move-linear",
                           .options = {{"to", "1cm,,5"},
                                       {"velocity", "0.1 m/s"},
                                       {"blend", "look-ahead"},
                                       {"deviation", "50 um"}}};
  require_taken(words);
  const auto line = std::get<command::MoveLinearAbsolute>(command_of(words, mm));
  EXPECT_DOUBLE_EQ(line.to[0], 10);
  EXPECT_TRUE(std::isnan(line.to[1]));
  EXPECT_EQ(line.to[2], 5);
  EXPECT_TRUE(std::isnan(line.to[3]));
  EXPECT_DOUBLE_EQ(line.path.along.velocity, 100);
  EXPECT_EQ(line.path.buffer, PathBuffer::look_ahead);
  EXPECT_DOUBLE_EQ(line.path.deviation, 0.05);

  const auto arc = std::get<command::MoveCircularRelative>(
      command_of({.what = "move-circular",
                  .options = {{"by", "10,0"}, {"center", "5,0"}, {"turns", "2"}},
                  .flags = {{"clockwise", true}, {"buffered", true}}},
                 mm));
  EXPECT_EQ(arc.center[0], 5);
  EXPECT_TRUE(std::isnan(arc.via[0]));
  EXPECT_EQ(arc.turns, 2);
  EXPECT_TRUE(arc.clockwise);
  EXPECT_EQ(arc.path.buffer, PathBuffer::buffered);

  EXPECT_EQ(
      std::get<command::GroupWait>(command_of({.what = "wait", .value = "500 ms"}, mm)).duration,
      0.5);
  const auto jog =
      std::get<command::GroupJog>(command_of({.what = "jog",
                                              .options = {{"along", "0,-1"}, {"velocity", "5"}},
                                              .flags = {{"hold-to-run", true}}},
                                             mm));
  EXPECT_EQ(jog.along[1], -1);
  EXPECT_TRUE(holds_to_run(jog));
}

TEST(CommandWords, AUnitAfterASpaceIsNamed) {
  for (const std::vector<std::string>& values :
       {std::vector<std::string>{"50", "mm/s"}, {"mm/s"}, {"x=10", "mm/s"}}) {
    CommandWords words{.what = "jog"};
    EXPECT_THAT(
        test::error_of([&] { set_values(words, values); }),
        HasSubstr("VALUE = mm/s: is a unit: write it right after its number, such as 50mm/s"));
  }
}

TEST(CommandWords, AValueOfAWordWithoutOneNamesItsOption) {
  const auto rule = [](const std::string& what) {
    return test::error_of([&] { require_taken({.what = what, .value = "5"}); });
  };
  EXPECT_EQ(rule("acknowledge"),
            "VALUE = 5: does not apply to acknowledge: did you mean --m-word 5?");
  EXPECT_EQ(rule("single-step"), "VALUE = 5: does not apply to single-step: did you mean --on?");
  EXPECT_EQ(rule("move-linear"), "VALUE = 5: needs the name of an axis, such as x=5");
  EXPECT_EQ(rule("phasing"),
            "VALUE = 5: does not apply to phasing: did you mean --to 5 or --by 5?");
  EXPECT_EQ(rule("repeat"), "VALUE = 5: does not apply to repeat: did you mean --to 5?");
}

TEST(CommandWords, AllWrongOptionsAreReported) {
  const auto errors = [](const CommandWords& words) {
    try {
      require_taken(words);
      (void)command_of(words, mm);
    } catch (const InputError& error) {
      return all_sentences(error, "");
    }
    return std::string();
  };
  const std::map<std::string, std::string> units{
      {"master-sync", "3s"}, {"slave-sync", "9"}, {"start-distance", "5kg"}};
  EXPECT_EQ(errors({.what = "gear-in-pos", .value = "1:0", .options = units}),
            "VALUE = 1:0: the denominator must not be 0\n"
            "--master-sync = 3s: s is not a unit of this quantity: give the value in deg\n"
            "--start-distance = 5kg: kg is not a unit of this quantity: give the value in deg");
  EXPECT_EQ(
      errors({.what = "gear-out", .options = {{"offset", "10"}, {"to", "5"}}}),
      "--offset = 10: does not apply to gear-out, which takes no value; its only own option is "
      "--at\n"
      "--to = 5: does not apply to gear-out, which takes no value; its only own option is --at");
}

TEST(CommandWords, AnOrderWithCoordinatesNamesThatOfAnAxis) {
  const auto rule = [](const std::string& what, const std::map<std::string, std::string>& options) {
    return rule_of_axis("x", {.what = what, .options = options});
  };
  EXPECT_THAT(rule("set-position", {{"to", "x=4"}}), HasSubstr("`jounce order x set-position 4`"));
  EXPECT_THAT(rule("move-direct", {{"to", "y=5,x=10mm"}}),
              HasSubstr("`jounce order x move --to 10mm`"));
  EXPECT_THAT(rule("move-linear", {{"by", "a=3"}}), HasSubstr("`jounce order x move --by 3`"));
  EXPECT_THAT(rule("move-linear", {{"to", "a=3,b=4"}}),
              HasSubstr("`jounce order x move --to POSITION`"));
  EXPECT_THAT(rule("jog", {{"along", "x=1"}, {"velocity", "20"}}),
              HasSubstr("`jounce order x jog 20`"));
  EXPECT_EQ(rule("set-limits", {}), "is a single axis, without coordinates: name a group");
}

TEST(CommandWords, LimitsTakeTheNameOfAnAxis) {
  const CommandWords words{.what = "set-limits", .options = {{"axis", "y"}, {"velocity", "5"}}};
  EXPECT_TRUE(names_axes(words));
  EXPECT_EQ(std::get<command::GroupSetLimits>(command_of(words, mm, {"x", "y"})).axis, 2);
  EXPECT_FALSE(names_axes({.what = "set-limits", .options = {{"axis", "2"}}}));
  EXPECT_THAT(test::error_of([&] {
                (void)command_of(words, mm, {"x", "z"});
              }),
              HasSubstr("--axis = y: names y, but the axes of the group are x, z"));
}

TEST(CommandWords, CoordinatesHaveTheNamesOfTheAxes) {
  const std::vector<std::string> axes{"x", "y", "z"};
  const auto words = [](const std::string& what, const std::vector<std::string>& values,
                        std::map<std::string, std::string> options = {}) {
    CommandWords made{.what = what, .options = std::move(options)};
    set_values(made, values);
    require_taken(made);
    return made;
  };
  const CommandWords named = words("move-linear", {"y=1cm", "x=-5mm"}, {{"velocity", "80"}});
  EXPECT_TRUE(names_axes(named));
  const auto line = std::get<command::MoveLinearAbsolute>(command_of(named, mm, axes));
  EXPECT_EQ(line.to[0], -5);
  EXPECT_EQ(line.to[1], 10);
  EXPECT_TRUE(std::isnan(line.to[2])) << "an axis without a name stays";
  const auto arc = std::get<command::MoveCircularAbsolute>(
      command_of(words("move-circular", {"x=40", "y=30"}, {{"center", "y=20,x=40"}}), mm, axes));
  EXPECT_EQ(arc.to[1], 30);
  EXPECT_EQ(arc.center[0], 40);
  EXPECT_EQ(arc.center[1], 20);
  const auto by = std::get<command::MoveDirectRelative>(
      command_of(words("move-direct", {}, {{"by", "z=2"}}), mm, axes));
  EXPECT_TRUE(std::isnan(by.to[0]));
  EXPECT_EQ(by.to[2], 2);
  const auto jog = std::get<command::GroupJog>(command_of(words("jog", {"y=-1"}), mm, axes));
  EXPECT_EQ(jog.along[1], -1);
  const auto frame = std::get<command::SetCoordinateTransform>(
      command_of(words("set-coordinate-transform", {"x=120"}, {{"rotation", "30"}}), mm, axes));
  EXPECT_EQ(frame.offset[0], 120);
  EXPECT_EQ(frame.rotation, 30);
  const auto turned = std::get<command::SetCoordinateTransform>(command_of(
      words("set-coordinate-transform", {}, {{"rotation", "0.5 rev"}, {"zyz", "30deg,90,0.25rev"}}),
      mm, axes, {"mm", "mm", "mm"}));
  EXPECT_DOUBLE_EQ(turned.rotation, 180);
  EXPECT_EQ(turned.zyz[0], 30);
  EXPECT_EQ(turned.zyz[1], 90);
  EXPECT_DOUBLE_EQ(turned.zyz[2], 90);
  EXPECT_FALSE(names_axes(words("wait", {"0.5"})));
  const auto along = std::get<command::GroupJog>(
      command_of(words("jog", {"20mm/s"}, {{"along", "1,0,0"}}), mm, axes));
  EXPECT_EQ(along.dynamics.velocity, 20);
  const auto back =
      std::get<command::MoveVelocity>(command_of(words("jog", {"--", "-20mm/s"}), mm));
  EXPECT_EQ(back.velocity, -20);

  const auto wrong = [&](const std::string& what, const std::vector<std::string>& values,
                         const std::map<std::string, std::string>& options = {}) {
    return test::error_of([&] { (void)command_of(words(what, values, options), mm, axes); });
  };
  EXPECT_THAT(wrong("move-circular", {"x=1", "y=1"}, {{"radius", "many"}}),
              testing::StartsWith("--radius = many: "));
  EXPECT_THAT(wrong("move-circular", {"x=1", "y=1"}, {{"center", "1,many"}}),
              testing::StartsWith("--center: y = many: "));
  EXPECT_THAT(wrong("move-circular", {"x=many", "y=1"}, {{"radius", "1"}}),
              testing::StartsWith("x = many: "));
  EXPECT_THAT(wrong("set-coordinate-transform", {}, {{"zyz", "1,5 mm"}}),
              testing::AllOf(testing::StartsWith("--zyz = 5 mm: "), testing::HasSubstr("in deg")));
  EXPECT_EQ(wrong("move-linear", {"u=1"}),
            "VALUE = u=1: names u, but the axes of the group are x, y, z");
  EXPECT_EQ(wrong("move-linear", {"x=1", "x=2"}), "VALUE = x=1,x=2: names an axis twice");
  EXPECT_EQ(wrong("move-linear", {"=2"}),
            "VALUE = =2: names no axis, but the axes of the group are x, y, z");
  EXPECT_EQ(wrong("move-linear", {"x="}), "VALUE = x=: has a name without a coordinate");
  EXPECT_EQ(wrong("move-linear", {}, {{"to", "x=1,2"}}),
            "--to = x=1,2: has coordinates with and without a name: name all of them, or none");
  EXPECT_EQ(wrong("move-linear", {"x=1"}, {{"to", "5"}}),
            "VALUE = x=1: cannot be combined with --to: give one of the two");
  EXPECT_EQ(wrong("move-linear", {"x=1"}, {{"by", "5"}}),
            "VALUE = x=1: cannot be combined with --by: use --by x=1");
  EXPECT_EQ(wrong("wait", {"1", "2"}), "VALUE = 1: is one of several values: give one value");
  EXPECT_EQ(wrong("move-linear", {"1", "2"}),
            "VALUE = 1: is one of several values: give coordinates such as x=10 y=5");
  EXPECT_EQ(wrong("enable", {"1", "2"}),
            "VALUE = 1: does not apply to enable, which takes no VALUE");
  EXPECT_EQ(wrong("jog", {"-250mm/s", "--url", "unix:///tmp/bus"}),
            "VALUE = --url: is an option after --, where all words are values: write it before --. "
            "A negative number needs no --");
  EXPECT_EQ(wrong("halt", {"x=1"}),
            "VALUE = x=1: has names of axes, but halt has no coordinates: omit them");
  EXPECT_EQ(wrong("move-circular", {"x=1"}, {{"center", "z=3"}}),
            "--center = ,,3: has 3 coordinates, and must have at most 2");
}

TEST(CommandWords, APhaseShiftIsInTheUnitsOfTheMaster) {
  const auto shift = std::get<command::PhasingRelative>(command_of(
      {.what = "phasing", .options = {{"by", "0.5 rev"}, {"velocity", "10 rev/s"}}}, mm));
  EXPECT_DOUBLE_EQ(shift.shift, 180);
  EXPECT_DOUBLE_EQ(shift.dynamics.velocity, 3600);
  EXPECT_TRUE(std::isnan(shift.dynamics.jerk));
}

TEST(CommandWords, CommandsThatChangeAMotion) {
  const auto both = std::get<command::CombineAxes>(
      command_of({.what = "combine", .value = "3:2", .options = {{"second", "-1"}}}, mm));
  EXPECT_EQ(both.numerator, 3);
  EXPECT_EQ(both.denominator, 2);
  EXPECT_EQ(both.second_numerator, -1);
  EXPECT_EQ(both.second_denominator, 1);
  const auto strokes = std::get<command::MoveRepetitive>(command_of(
      {.what = "repeat", .options = {{"to", "4"}, {"wait", "200 ms"}, {"strokes", "3"}}}, mm));
  EXPECT_DOUBLE_EQ(strokes.wait, 0.2);
  EXPECT_EQ(strokes.strokes, 3);
  const auto change = std::get<command::ChangeVelocity>(
      command_of({.what = "change-velocity",
                  .value = "50",
                  .options = {{"past", "10cm"}, {"direction", "negative"}}},
                 mm));
  EXPECT_DOUBLE_EQ(change.position, 100);
  EXPECT_EQ(change.direction, Direction::negative);
  EXPECT_EQ(test::error_of([] {
              command_of({.what = "combine", .value = "3", .options = {{"second", "1:0"}}}, mm);
            }),
            "--second = 1:0: the denominator of the second master must not be 0");
  EXPECT_EQ(test::error_of([] { command_of({.what = "gear-in", .value = "1:0"}, mm); }),
            "VALUE = 1:0: the denominator must not be 0");
  EXPECT_EQ(test::error_of([] { command_of({.what = "combine", .value = "1:1"}, mm); }),
            "--second: is missing: give a ratio, such as --second 3:2");
  EXPECT_THAT(
      test::error_of([] {
        command_of(
            {.what = "change-velocity", .value = "5", .options = {{"direction", "positive"}}}, mm);
      }),
      HasSubstr("has no effect without --past"));
  EXPECT_THAT(test::error_of([] {
                command_of({.what = "repeat", .options = {{"to", "5"}, {"wait", "-1"}}}, mm);
              }),
              HasSubstr("must be 0 or more"));
}

TEST(CommandWords, APieceHasAPositiveLength) {
  for (const char* const option : {"length", "waste"})
    EXPECT_EQ(test::error_of([&] {
                command_of({.what = "cut", .options = {{option, "-5"}}}, mm);
              }),
              "--" + std::string(option) + " = -5" + (mm.x.empty() ? "" : " " + mm.x) +
                  ": must be greater than 0");
}

TEST(CommandWords, AWrongCoordinateIsNamed) {
  const auto rule = [](const char* what, std::map<std::string, std::string> options) {
    return test::rule_of([&] { command_of({.what = what, .options = options}, mm); });
  };
  EXPECT_THAT(rule("move-linear", {}), HasSubstr("needs one of --to, --by"));
  EXPECT_THAT(rule("move-linear", {{"to", "1,2,3,4,5,6,7,8,9,10"}}),
              HasSubstr("has 10 coordinates, and must have at most 9"));
  EXPECT_THAT(rule("move-linear", {{"to", "1,x"}}), HasSubstr("number"));
  EXPECT_THAT(rule("move-linear", {{"to", "1,nan"}}), HasSubstr("number"));
  EXPECT_THAT(rule("move-circular", {{"to", "1,2"}, {"turns", "0.5"}}),
              HasSubstr("must be a whole number"));
  EXPECT_THAT(rule("move-circular", {{"to", "1,2"}, {"turns", "1001"}}),
              HasSubstr("must be a whole number from 0 to 1000"));
  EXPECT_THAT(rule("move", {{"to", "5"}, {"blend", "look-ahead"}}),
              HasSubstr("applies to the moves of a group only"));
}

TEST(CommandWords, AWrongValueIsNamed) {
  EXPECT_EQ(test::key_of([] { command_of({.what = "override", .value = "300%"}, mm); }), "VALUE");
  EXPECT_EQ(test::key_of([] {
              command_of({.what = "move", .options = {{"to", "5kg"}}}, mm);
            }),
            "--to");
  EXPECT_EQ(test::key_of([] { require_taken({.what = "enable", .value = "5"}); }), "VALUE");
  EXPECT_EQ(test::rule_of([] {
              require_taken({.what = "enable", .options = {{"to", "5"}}});
            }),
            "does not apply to enable, which takes no value; its only own option is --at");
}

TEST(CommandWords, ADurationIsForAHeldJogOnly) {
  require_held({.what = "jog", .flags = {{"hold-to-run", true}}}, "2");
  EXPECT_EQ(test::error_of([] { require_held({.what = "jog"}, "2"); }),
            "--seconds = 2: applies to jog --hold-to-run only: add --hold-to-run");
  EXPECT_EQ(test::error_of([] { require_held({.what = "move"}, "2"); }),
            "--seconds = 2: applies to jog --hold-to-run only");
}

TEST(CommandWords, AMissingValueIsNamedWithAnExample) {
  EXPECT_EQ(test::rule_of([] { command_of({.what = "jog"}, mm); }),
            "VALUE is missing: give a velocity, such as 12.5mm/s");
  EXPECT_EQ(test::rule_of([] { command_of({.what = "gear-in"}, mm); }),
            "VALUE is missing: give a ratio, such as 3:2");
  EXPECT_EQ(test::rule_of([] { command_of({.what = "combine"}, mm); }),
            "VALUE is missing: give two ratios, such as combine 3:2 --second 1:2");
  EXPECT_EQ(test::rule_of([] { command_of({.what = "override"}, mm); }),
            "VALUE is missing: give a factor, such as 50%");
}

TEST(CommandWords, ATouchProbeHasItsInputEdgeAndWindow) {
  const auto probe = [](const std::string& input, std::map<std::string, std::string> options) {
    const CommandWords words{.what = "touch-probe", .value = input, .options = std::move(options)};
    require_taken(words);
    return std::get<command::TouchProbe>(command_of(words, mm));
  };
  const command::TouchProbe single = probe("2", {});
  EXPECT_EQ(single.input, 2);
  EXPECT_EQ(single.edge, ProbeEdge::rising);
  EXPECT_EQ(single.count, 1);
  EXPECT_TRUE(std::isnan(single.first_position));
  const command::TouchProbe all =
      probe("home", {{"edge", "both"}, {"count", "0"}, {"last-position", "5cm"}});
  EXPECT_EQ(all.input, home_switch_input);
  EXPECT_EQ(all.edge, ProbeEdge::both);
  EXPECT_EQ(all.count, 0);
  EXPECT_EQ(all.last_position, 50);
  EXPECT_EQ(probe("index", {}).input, index_input);
  EXPECT_EQ(test::rule_of([&] { probe("", {}); }),
            "is missing: give a trigger input: 1 to 4, home or index");
  EXPECT_EQ(test::rule_of([&] { probe("7", {}); }),
            "must be a trigger input: 1 to 4, home or index");
  EXPECT_EQ(test::key_of([&] { probe("1", {{"edge", "up"}}); }), "--edge");
  EXPECT_EQ(test::key_of([&] { probe("1", {{"count", "-1"}}); }), "--count");
  EXPECT_EQ(test::key_of([&] { probe("1", {{"velocity", "5"}}); }), "--velocity");
}

TEST(CommandWords, EachOptionIsListedOnce) {
  EXPECT_THAT(command_words(), Contains("gear-in"));
  std::map<std::string, int> count;
  for (const CommandOption& option : command_options()) ++count[option.name];
  EXPECT_EQ(command_options().front().name, "to");
  for (const auto& [name, times] : count) EXPECT_EQ(times, 1) << name;
}

TEST(CommandWords, WordsOfAnotherVerbAreNamed) {
  EXPECT_EQ(meant_command("feeder", "stop"),
            "is a verb of its own: did you mean jounce stop feeder?");
  EXPECT_EQ(meant_command("feeder", "abort"),
            "is an option of a verb: did you mean jounce stop feeder --abort?");
  EXPECT_EQ(meant_command("enable", "feeder"),
            "is not a command: did you mean jounce order feeder enable?");
  EXPECT_EQ(meant_command("feeder", "jump"),
            "is not a command: `jounce order --help` lists all, such as move, jog and home");
  EXPECT_EQ(meant_command("feeder", "mov"), "") << "one_of() names the near word";
}

}  // namespace
}  // namespace jounce::command_words_test
