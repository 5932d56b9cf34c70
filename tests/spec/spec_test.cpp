// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/spec.hpp"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "jounce/base/file.hpp"
#include "jounce/base/input_errors.hpp"
#include "jounce/design/make.hpp"

#include "support/errors.hpp"

namespace jounce::spec_test {
namespace {

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

/// The error that reading and making this text gives, or "".
std::string complaint(const std::string& text) {
  return test::error_of([&] { (void)make(parse_spec(text, "a.toml")); });
}

TEST(Spec, ReadsTheCamOfThePmc600Manual) {
  const Spec spec = read_spec(examples + "pmc600-cam/cam.toml");
  ASSERT_TRUE(spec.over_master());
  const auto& cam = std::get<CamSpec>(spec.subject);
  EXPECT_TRUE(cam.periodic);
  ASSERT_EQ(cam.segments.size(), 4U);
  EXPECT_EQ(cam.segments[1].name, "in step");
  EXPECT_EQ(cam.segments[2].end.geo_velocity, 0.01739120485);
  EXPECT_EQ(spec.units.x, "pulse");
  EXPECT_EQ(spec.limits.velocity, 3);
  EXPECT_EQ(make_master(spec).at(1e9).position, 1080);
}

TEST(Spec, MakesTheGoogolMoveFromItsSmoothingTime) {
  const Made made = make(read_spec(examples + "googol-move/move.toml"));
  EXPECT_DOUBLE_EQ(std::get<Trajectory>(*made.curve).end(), 1325) << "ms, as the spec counts";
  EXPECT_LT(made.sampled.error.position, 1e-9);
}

TEST(Spec, TakesUnitsInQuotes) {
  const Spec spec = read_spec(examples + "hmpl-pvt/pvt.toml");
  EXPECT_DOUBLE_EQ(std::get<Table>(spec.subject).columns().x[1], 2) << "2000 ms";
}

constexpr const char* cam = R"(jounce = 1
kind = "cam"
units = { master = "deg", position = "mm" }
start = { master = 0, slave = 0 }
[[segment]]
law = "quintic"
end = { master = 180, slave = 50 }
[limits]
geo_velocity = 1
)";

constexpr const char* move = R"(jounce = 1
kind = "move"
units = { position = "mm" }
[move]
profile = "s_curve"
to = 100
velocity = 10
acceleration = 50
jerk = 500
)";

constexpr const char* pvt = R"(jounce = 1
kind = "pvt"
units = { position = "mm" }
[table]
rule = "cubic_hermite"
[[knot]]
time = 0
position = 0
velocity = 0
[[knot]]
time = 1
position = 5
velocity = 0
)";

TEST(Spec, ReadsWhatTheSlaveMayDoOverTime) {
  const Spec spec = parse_spec(
      std::string(cam) + "[limits.slave]\nvelocity = \"0.4 m/s\"\nacceleration = 6000\n", "a");
  EXPECT_EQ(spec.limits.velocity, 1) << "per deg, as before";
  EXPECT_DOUBLE_EQ(*spec.slave.velocity, 400);
  EXPECT_EQ(spec.slave.acceleration, 6000);
  EXPECT_FALSE(spec.slave.jerk);
  EXPECT_EQ(complaint(std::string(cam) + "[limits.slave]\njerk = -1\n"),
            "a.toml:11:8: limits.slave.jerk = -1 mm/s^3: must be greater than 0; leave it out for "
            "no limit");
  EXPECT_NE(complaint(std::string(move) + "[limits.slave]\njerk = 1\n"), "") << "a cam's key";
}

TEST(Spec, TheBasesOfTheErrorTestsAreGood) {
  for (const char* text : {cam, move, pvt}) EXPECT_EQ(complaint(text), "") << text;
}

struct Bad {
  const char* base;
  const char* what;
  const char* with;
  const char* message;
};

/// ctest names a case by what it expects, not by where its bytes lie.
void PrintTo(const Bad& bad, std::ostream* out) {
  *out << bad.message;
}

class BadSpec : public ::testing::TestWithParam<Bad> {};

TEST_P(BadSpec, GetsOneMessageWithPlaceKeyValueAndRule) {
  const auto& [base, what, with, message] = GetParam();
  EXPECT_EQ(complaint(replaced(base, what, with)), message);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadSpec,
    ::testing::Values(
        Bad{cam, "jounce = 1", "jounce = 2",
            "a.toml:1:10: jounce = 2: must be 1, the format version that this program reads"},
        Bad{cam, "jounce = 1\n", "",
            "a.toml: jounce: is missing: a spec begins with `jounce = 1`, the version of its "
            "format"},
        Bad{cam, "kind = \"cam\"", "kind = \"cma\"",
            "a.toml:2:8: kind = \"cma\": is unknown: did you mean \"cam\"?"},
        Bad{cam, "\"deg\"", "\"degrees\"",
            "a.toml:3:20: units.master = \"degrees\": is not a unit of a master: give an angle "
            "(deg rad rev), a length (m mm um cm in ft yd), pulse, count or inc, or a time (s ms) "
            "for a "
            "virtual master"},
        Bad{cam, "position = \"mm\"", "position = 3",
            "a.toml:3:38: units.position = 3: must be a string in quotes"},
        Bad{cam, "slave = 50", "slave = \"50 deg\"",
            "a.toml:7:31: segment[1].end.slave = \"50 deg\": deg is not a unit of this quantity: "
            "give the value in mm"},
        Bad{cam, "slave = 50", "slave = nan",
            "a.toml:7:31: segment[1].end.slave = nan: must be a finite number"},
        Bad{cam, "slave = 50", "slave = -inf",
            "a.toml:7:31: segment[1].end.slave = -inf: must be a finite number"},
        Bad{cam, "slave = 50", "slave = true",
            "a.toml:7:31: segment[1].end.slave = true: must be a number in mm, or a quantity such "
            "as \"12.5 mm\""},
        Bad{cam, "slave = 50", "slave = 2024-01-01",
            "a.toml:7:31: segment[1].end.slave = 2024-01-01: must be a number in mm, or a quantity "
            "such as \"12.5 mm\""},
        Bad{cam, ", slave = 50", "",
            "a.toml:7:7: segment[1].end.slave: is missing: add slave = NUMBER, in mm"},
        Bad{cam, "master = 180", "master = 0",
            "a.toml:7:18: segment[1].end.master = 0 deg: must be greater than 0, the previous "
            "knot"},
        Bad{cam, "master = 180", "master = -5",
            "a.toml:7:18: segment[1].end.master = -5 deg: must be greater than 0, the previous "
            "knot"},
        Bad{cam, "\"quintic\"", "\"modified_sin\"",
            "a.toml:6:7: segment[1].law = \"modified_sin\": is unknown: did you mean "
            "\"modified_sine\"?"},
        Bad{cam, "\"quintic\"", "\"dwell\"",
            "a.toml:7:31: segment[1].end.slave = 50 mm: must be 0, the position where this dwell "
            "starts: change one of the two, or the law"},
        Bad{cam, "geo_velocity = 1", "geo_velocty = 1",
            "a.toml:9:1: limits.geo_velocty = 1: is not a key here: did you mean "
            "geo_velocity?"},
        Bad{cam, "geo_velocity = 1", "geo_velocity = 0",
            "a.toml:9:16: limits.geo_velocity = 0 mm/deg: must be greater than 0; leave it out for "
            "no "
            "limit"},
        Bad{cam, "geo_velocity = 1", "velocity = 1",
            "a.toml:9:12: limits.velocity = 1: is a limit over time: give it in [limits.slave]"},
        Bad{cam, "[limits]", "[limits",
            "a.toml:8:8: [limits: needs a closing ] at the end of the section header"},
        Bad{cam, "law = \"quintic\"", "law = \"quintic\"\nlaw = \"line\"",
            "a.toml:7:7: law = \"line\": is given twice: remove one of the two"},
        Bad{move, "velocity = 10", "velocity = 0",
            "a.toml:7:12: move.velocity = 0 mm/s: must be greater than 0"},
        Bad{move, "velocity = 10", "velocity = 1e400",
            "a.toml:7:17: velocity = 1e400: must be less than 1.8e308 in magnitude"},
        Bad{move, "to = 100", "to = 0",
            "a.toml:6:6: move.to = 0 mm: must differ from `from` = 0: there is no move"},
        Bad{move, "to = 100", "to = \"1e999 m\"",
            "a.toml:6:6: move.to = \"1e999 m\": must be a finite number, with or without a unit, "
            "such as \"12.5 mm\""},
        Bad{move, "to = 100", "from = -1e308\nto = 1e308",
            "a.toml:4:1: move.to - from = inf: must be a finite number"},
        Bad{move, "jerk = 500", "",
            "a.toml:4:1: move.jerk: is missing: add jerk = NUMBER, or smoothing = \"50 ms\", the "
            "rise time of the acceleration"},
        Bad{move, "jerk = 500", "smoothing = 0",
            "a.toml:9:13: move.smoothing = 0 s: must be greater than 0"},
        Bad{move, "\"s_curve\"", "\"trapezoid\"",
            "a.toml:9:1: move.jerk = 500: is not a key of profile = \"trapezoid\"; possible keys: "
            "acceleration, "
            "deceleration, from, period, profile, to, velocity"},
        Bad{pvt, "time = 1\n", "time = 0\n",
            "a.toml:11:8: knot[2].time = 0 s: must be greater than 0, the previous knot"},
        Bad{pvt, "velocity = 0\n[[knot]]\ntime = 1\nposition = 5\nvelocity = 0\n", "velocity = 0\n",
            "a.toml: knots = 1: must be at least 2"},
        Bad{pvt, "\"cubic_hermite\"", "\"quintic_hermite\"",
            "a.toml:6:1: knot[1].acceleration: is missing: add acceleration to each knot, or a "
            "rule "
            "at the top, such as velocities = \"clamped\""},
        Bad{pvt, "[[knot]]\ntime = 0", "[[knots]]\ntime = 0",
            "a.toml:6:3: [[knots]]: is not a section here: did you mean [[knot]]?"}));

TEST(BadSpecs, EmptyFilesAreReported) {
  EXPECT_EQ(complaint(""), "a.toml:1: the file is empty: `jounce new` writes a spec to start with");
  EXPECT_EQ(complaint(" \n\t\n"),
            "a.toml:1: the file is empty: `jounce new` writes a spec to start with");
}

TEST(BadSpecs, PointsInPlaceOfASpecAreNamed) {
  EXPECT_EQ(complaint("master,slave\n0,0\n1,5\n2,3\n"),
            "a.toml:1: has points only, without the header of a Jounce table: write a spec of kind "
            "\"cam\" with points = \"a.toml\", or fit a cam to the points with `jounce fit`");
  EXPECT_EQ(complaint("time,position\n0,0\n1,5\n"),
            "a.toml:1: has points only, without the header of a Jounce table: write a spec of kind "
            "\"pvt\" with points = \"a.toml\"");
  EXPECT_EQ(complaint("time,position [mm],position [mm]\n0,0,1\n"),
            "a.toml:1: position: is the name of two columns: remove one");
}

// Reading ends at the thousandth error. Otherwise, this test takes many minutes.
TEST(BadSpecs, VeryManyErrorsEndTheReading) {
  std::string text = "jounce = 1\nkind = \"cam\"\n";
  for (int i = 0; i < 100'000; ++i) text += "[[segment]]\n";
  try {
    (void)parse_spec(text, "many.toml");
    ADD_FAILURE();
  } catch (const InputErrors& errors) {
    ASSERT_EQ(errors.all().size(), 1000U);
    EXPECT_EQ(errors.all().back().document(), "many.toml");
    EXPECT_LT(errors.all().back().line(), 1100);
  }
}

TEST(BadSpecs, AVersionInQuotesIsNamed) {
  EXPECT_EQ(complaint("jounce = \"1\"\nkind = \"move\"\n"),
            "a.toml:1:10: jounce = \"1\": must be a whole number, without quotes");
}

TEST(BadSpecs, AFileThatCannotBeReadHasThePlaceThatNamesIt) {
  EXPECT_EQ(complaint("jounce = 1\nkind = \"pvt\"\nunits = { position = \"mm\" }\n"
                      "points = \"nothere.csv\"\n"),
            "a.toml:4:10: points = nothere.csv: cannot be read: No such file or directory");
}

// It overran the stack.
TEST(BadSpecs, AKeyOfVeryManyPartsIsRejected) {
  const auto refusal = [](const std::string& text) {
    return test::error_of([&] { (void)parse_spec(text, "a.toml"); });
  };
  std::string key;
  for (int i = 0; i < 50'000; ++i) key += "a.";
  const std::string why = "a.toml:2: key: must have at most 256 parts between dots";
  EXPECT_EQ(refusal("jounce = 1\n" + key + "b = 1\n"), why);
  EXPECT_EQ(refusal("jounce = 1\n[" + key + "b]\n"), why);
  EXPECT_EQ(refusal("jounce = 1\nx = { " + key + "b = 1 }\n"), why);
  EXPECT_NE(refusal("jounce = 1\n# " + std::string(1000, '.') + "\n"), why);
  std::string list;
  for (int i = 0; i < 1000; ++i) list += "0.5, ";
  EXPECT_NE(refusal("jounce = 1\nx = [\n" + list + "]\n"), why);
}

TEST(BadSpecs, EveryTruncationOfASpecIsRejectedOrStillASpec) {
  const std::string text = read_file(examples + "pmc600-cam/cam.toml");
  for (std::size_t length = 0; length < text.size(); ++length) {
    const std::string message = complaint(text.substr(0, length));  // throws nothing but InputError
    if (!message.empty()) {
      EXPECT_TRUE(message.starts_with("a.toml")) << message;
    }
  }
}

// ---- cam switches ------------------------------------------------------------------------------

constexpr const char* axis_with_switches = R"(jounce = 1
kind = "axis"
units = { position = "mm", master = "deg" }
[axis]
[limits]
velocity = 1
acceleration = 1
[switches]
of = "master"
period = "1 rev"
[[switch]]
track = 2
first_on_position = 350
last_on_position = 10
axis_direction = "negative"
[[switch]]
track = 1
first_on_position = "0.5 rev"
duration = "25 ms"
[[track]]
track = 2
on_compensation = "-4 ms"
hysteresis = 0.5
inverted = true
)";

TEST(Spec, ReadsTheSwitchesOfAnAxis) {
  const AxisSwitches switches = parse_spec(axis_with_switches, "a.toml").switches;
  EXPECT_EQ(switches.of, SwitchesOf::master);
  EXPECT_DOUBLE_EQ(switches.table.period.value(), 360);
  ASSERT_EQ(switches.table.switches.size(), 2U);
  EXPECT_EQ(switches.table.switches[0].axis_direction, AxisDirection::negative);
  EXPECT_EQ(switches.table.switches[0].last_on_position, 10);
  EXPECT_EQ(switches.table.switches[1].mode, CamSwitchMode::time);
  EXPECT_DOUBLE_EQ(switches.table.switches[1].duration.value(), 0.025);
  EXPECT_DOUBLE_EQ(switches.table.switches[1].first_on_position, 180);
  const SwitchTrack track = switches.table.options(2);
  EXPECT_DOUBLE_EQ(track.on_compensation, -0.004);
  EXPECT_EQ(track.hysteresis, 0.5);
  EXPECT_TRUE(track.inverted);
}

TEST(Spec, ASwitchThatCannotBeMeantIsShownWhereItStands) {
  const auto of = [](const std::string& what, const std::string& with) {
    return complaint(replaced(axis_with_switches, what, with));
  };
  EXPECT_NE(of("last_on_position = 10", "last_on_position = 350").find("a.toml:14:"),
            std::string::npos);
  EXPECT_NE(of("track = 2", "track = 33").find("must be 1 to 32"), std::string::npos);
  EXPECT_NE(of("\"1 rev\"", "0").find("must be greater than 0"), std::string::npos);
  EXPECT_NE(of(", master = \"deg\"", "").find("needs units.master"), std::string::npos);
}

TEST(Spec, TheSwitchesOfAPeriodicCamHaveItsPeriod) {
  const std::string with_switch =
      std::string(cam) + "[[switch]]\ntrack = 1\nfirst_on_position = 1\nlast_on_position = 2\n";
  const Spec once = parse_spec(with_switch, "a.toml");
  EXPECT_EQ(once.switches.of, SwitchesOf::master);
  EXPECT_EQ(once.switches.table.period, std::nullopt);
  const Spec periodic =
      parse_spec(replaced(with_switch, "start =", "periodic = true\nstart ="), "a.toml");
  EXPECT_EQ(periodic.switches.table.period, 180);
}

TEST(Spec, ReadsWholeNumbersThatNoDoubleHolds) {
  const std::string text =
      "jounce = 1\nkind = \"move\"\nunits = { position = \"pulse\" }\n[move]\n"
      "profile = \"trapezoid\"\nto = 9007199254740993\nvelocity = 10000000000000001\n"
      "acceleration = 1000\n";
  const Spec spec = parse_spec(text, "big.toml");
  const auto& trapezoid = std::get<TrapezoidSpec>(std::get<MoveSpec>(spec.subject));
  EXPECT_EQ(trapezoid.to, 9007199254740992.0);
  EXPECT_EQ(trapezoid.velocity, 1e16);
}

}  // namespace
}  // namespace jounce::spec_test
