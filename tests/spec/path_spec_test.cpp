// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "jounce/base/file.hpp"
#include "jounce/base/input_errors.hpp"
#include "jounce/path/plan.hpp"
#include "jounce/profiles/error.hpp"
#include "jounce/profiles/limits/limits.hpp"
#include "jounce/spec/spec.hpp"

#include "support/temporary_folder.hpp"

namespace jounce::path_spec_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string head = R"(jounce = 1
kind = "path"
units = { position = "mm", time = "s" }
[[axis]]
name = "x"
limits = { velocity = 200, acceleration = 1000, jerk = 10000 }
[[axis]]
name = "y"
limits = { velocity = 200, acceleration = 1000, jerk = 10000 }
[[axis]]
name = "c"
unit = "deg"
follower = true
limits = { velocity = 360, acceleration = 1000, jerk = 10000 }
)";  // 14 lines

PathSpec read(const std::string& rest, const std::string& before = head) {
  return std::get<PathSpec>(parse_spec(before + rest, "path.toml").subject);
}

std::string complaint(const std::string& rest, const std::string& before = head) {
  try {
    (void)read(rest, before);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

std::string command(const std::string& keys) {
  return "[path]\nvelocity = 100\n[[command]]\n" + keys + "\n";
}

TEST(PathSpecFile, PlacesOfArcsNeedNoNumberForAFollower) {
  const auto numbers = [](const std::string& place) {
    const PathSpec path = read(place);
    return std::vector<double>(path.program.arcs()[0].center.begin(),
                               path.program.arcs()[0].center.begin() + 2);
  };
  const auto arc = [](const std::string& keys) { return command("type = \"arc\"\n" + keys); };
  const std::string about = "rotation = \"counterclockwise\"\nto = [0, 20, 90]\ncenter = ";
  EXPECT_EQ(numbers(arc(about + "[0, 10]")), numbers(arc(about + "[0, 10, 7]")));
  EXPECT_EQ(numbers(arc("to = [0, 20, 90]\nvia = [10, 10]")),
            numbers(arc("to = [0, 20, 90]\nvia = [10, 10, 7]")));
  EXPECT_THAT(complaint(arc(about + "[0]")),
              HasSubstr("must be a list of 3 numbers, one for each axis; the followers may be left "
                        "out"));
  EXPECT_THAT(complaint(arc("via = [10, 10]\nto = [0, 20]")),
              HasSubstr("to = [0, 20]: must be a list of 3 numbers, one for each axis"));
  const PathSpec started = read(
      "[path]\nvelocity = 100\nstart = [5, 6]\n[[command]]\ntype = \"line\"\nto = [1, 2, 3]\n");
  EXPECT_EQ(started.program.start(), (Point{5, 6, 0}));
}

TEST(PathSpecFile, ReadsAnOverride) {
  const PathSpec path = read(command("type = \"line\"\nto = [1, 2, 3]") +
                             "[[override]]\ntime = \"200 ms\"\nfactor = 0.5\n"
                             "[[override]]\ntime = 1\nfactor = 0\n");
  ASSERT_EQ(path.override_steps.size(), 2U);
  EXPECT_EQ(path.override_steps[0].time, 0.2);
  EXPECT_EQ(path.override_steps[0].factor, 0.5);
  EXPECT_EQ(path.override_steps[1].factor, 0);
  EXPECT_THAT(complaint(command("type = \"line\"\nto = [1, 2, 3]") + "[[override]]\ntime = 1\n"),
              HasSubstr("override[1].factor"));
}

TEST(PathSpecFile, ReadsZones) {
  const std::string path = command("type = \"line\"\nto = [1, 2, 3]");
  const auto zones = [&](const std::string& axes, const std::string& rest) {
    return path + "[compare]\nmode = \"zone_equal\"\naxes = " + axes + "\nband = [0.1, 0.2]\n" +
           rest;
  };
  const std::string good = "pulse = 0.01\npoint = [{ at = [1, 2], output = 17 }]\n";
  const Spec spec = parse_spec(head + zones("[\"x\", \"y\"]", good), "path.toml");
  const PlaneCompare& zone = spec.compare->plane.value();
  EXPECT_TRUE(zone.equal);
  EXPECT_EQ(zone.y_band, 0.2);
  EXPECT_EQ(zone.points.at(0).output, 17);
  EXPECT_THAT(complaint(zones("[\"x\", \"x\"]", good)), HasSubstr("two different axes"));
  EXPECT_THAT(complaint(zones("[\"x\", \"y\"]", "pulse = 0.01\n")), HasSubstr("point"));
  EXPECT_THAT(complaint(zones("[\"x\", \"y\"]", "pulse = 0.01\npoint = [{ output = 1 }]\n")),
              HasSubstr("at: is missing"));
  EXPECT_THAT(complaint(path + "[compare]\naxis = \"z\"\nmode = \"equal\"\nposition = 1\n"),
              HasSubstr("must be one of the axes of this spec: x, y, c or path"));
}

TEST(PathSpecFile, ReadsCommandsWithTheirLines) {
  const PathSpec path = read(R"([path]
velocity = 100
corner = { deviation = "50 um" }
start = [1, 2, 3]
limits = { acceleration = 500, jerk = 5000, normal_acceleration = 800 }
[[command]]
type = "line"
to = [100, 0, "0.5 rev"]
[[command]]
type = "dwell"
time = "200 ms"
[[command]]
type = "line"
to = [10, 5, -90]
relative = true
velocity = 50
corner = "stop"
junction = "buffered"
acceleration = 100
)");
  const Program& program = path.program;
  EXPECT_EQ(program.path_axes(), 2U);
  EXPECT_THAT(program.start(), ElementsAre(1, 2, 3, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT(program.position(), ElementsAre(110, 5, 90, 0, 0, 0, 0, 0, 0));
  ASSERT_EQ(program.commands().size(), 3U);
  EXPECT_EQ(program.commands()[0].line, 20);
  EXPECT_EQ(program.commands()[2].line, 26);
  EXPECT_EQ(path.source, "path.toml");
  const PathSettings& first = program.settings()[program.commands()[0].settings];
  EXPECT_EQ(first.corner, Corner::deviation);
  EXPECT_DOUBLE_EQ(first.value, 0.05);
  const PathSettings& last = program.settings()[program.commands()[2].settings];
  EXPECT_EQ(last.velocity, 50);
  EXPECT_EQ(last.corner, Corner::stop);
  EXPECT_EQ(last.junction, Junction::buffered);
  EXPECT_EQ(last.deceleration, 100);
  EXPECT_EQ(path.limits.path.deceleration, 500);
  EXPECT_EQ(path.limits.path.normal_acceleration, 800);
  EXPECT_EQ(path.limits.axes[2].velocity, 360);
}

TEST(PathSpecFile, ReadsEachDefinitionOfAnArc) {
  const auto arc = [](const std::string& keys) {
    return read(command("type = \"arc\"\n" + keys)).program.arcs()[0];
  };
  const double half = std::numbers::pi;
  EXPECT_NEAR(arc("via = [50, 50, 0]\nto = [100, 0, 0]").sweep, half, 1e-12);
  EXPECT_NEAR(
      arc("center = [50, 0, 0]\nto = [100, 0, 0]\nrotation = \"clockwise\"\nturns = 2").sweep,
      5 * half, 1e-12);
  EXPECT_NEAR(arc("radius = 50\nto = [100, 0, 8]\nrotation = \"counterclockwise\"").sweep, half,
              1e-12);
  EXPECT_NEAR(arc("center = [50, 0, 0]\nangle = -90").to[1], 50, 1e-12);
  EXPECT_NEAR(arc("center = [50, 0, 0]\nangle = \"0.25 rev\"\nrelative = true").to[1], -50, 1e-12);
  // In the plane y, x the senses change sides.
  EXPECT_NEAR(arc("center = [50, 0, 0]\nangle = 90\nplane = [\"y\", \"x\"]").to[1], 50, 1e-12);
}

TEST(PathSpecFile, ReportsNoErrorThatOnlyFollowsFromAnother) {
  for (const char* first : {"type = \"line\"\nto = [100, 0]", "type = \"line\""}) {
    const std::string text = head + command(first) +
                             "[[command]]\ntype = \"arc\"\ncenter = [50, 0, 0]\nto = [0, 30, 0]\n"
                             "rotation = \"clockwise\"\n";
    try {
      (void)parse_spec(text, "path.toml");
      FAIL() << "accepted";
    } catch (const InputError& error) {
      ASSERT_EQ(all_errors(error).size(), 1U) << first;
      EXPECT_EQ(error.key(), "command[1].to");
    }
  }
}

TEST(PathSpecFile, RejectsKeysThatItsCommandDoesNotUse) {
  EXPECT_THAT(
      complaint(command("type = \"arc\"\nvia = [1, 1, 0]\nto = [2, 0, 0]\nradius = 3")),
      HasSubstr("command[1].radius = 3: cannot be combined with another definition of the arc"));
  EXPECT_THAT(
      complaint(command("type = \"arc\"\ncenter = [1, 1, 0]\nangle = 90\nto = [2, 0, 0]")),
      HasSubstr("path.toml:21:6: command[1].to = [2, 0, 0]: cannot be combined with angle:"));
  EXPECT_THAT(complaint(command("type = \"dwell\"\ntime = 1\nvelocity = 3")),
              HasSubstr("command[1].velocity"));
  EXPECT_THAT(complaint(command("type = \"line\"\nto = [1, 2, 0]\nturns = 1")),
              HasSubstr("command[1].turns"));
  EXPECT_THAT(complaint("[path]\ncorner = { deviation = 1, distance = 2 }\n"),
              HasSubstr("path.toml:16:"));
  EXPECT_THAT(complaint("[path]\n[gcode]\nrapid = 3\n[[command]]\ntype = \"dwell\"\ntime = 1\n"),
              HasSubstr("gcode: cannot be combined with command"));
}

TEST(PathSpecFile, PlacesItsErrors) {
  EXPECT_THAT(complaint(command("type = \"line\"\nto = [1, 2]")),
              HasSubstr("path.toml:19:6: command[1].to = [1, 2]: must be a list of 3 numbers"));
  EXPECT_THAT(
      complaint(command("type = \"arc\"\nradius = 3\nto = [100, 0, 0]\nrotation = \"clockwise\"")),
      HasSubstr(
          "path.toml:19:10: command[1].radius = 3 mm: must be at least 50 mm, half the distance "
          "from the start (0, 0) to the end (100, 0)"));
  EXPECT_THAT(complaint(command("type = \"arc\"\ncenter = [60, 0, 0]\nto = [100, 0, 0]\nrotation = "
                                "\"clockwise\"")),
              HasSubstr("path.toml:19:10: command[1].center"));
  EXPECT_THAT(complaint("[path]\nvelocity = 0\n"),
              HasSubstr("path.toml:16:12: path.velocity = 0 mm/s: must be greater than 0"));
  EXPECT_THAT(complaint("[path]\n[[axis]]\nname = \"z\"\n"),
              HasSubstr("axis[4].follower: is missing"));
  const std::string two =
      "jounce = 1\nkind = \"path\"\nunits = { position = \"mm\" }\n[[axis]]\nname = \"x\"\n";
  EXPECT_THAT(complaint("[[axis]]\nname = \"c\"\nunit = \"deg\"\n[path]\n", two),
              HasSubstr("axis[2].unit = \"deg\": must be mm"));
  EXPECT_THAT(complaint("follower = true\n[path]\n", two),
              HasSubstr("must have at least one that is not a follower"));
}

TEST(PathSpecFile, IsAMachineWithoutCommands) {
  PathSpec path =
      read("[path]\nvelocity = 100\n[gcode]\nrapid = \"12 m/min\"\nG54 = [10, 0, 0]\n",
           "jounce = 1\nkind = \"path\"\nunits = { position = \"mm\" }\n[[axis]]\nname = "
           "\"x\"\n[[axis]]\nname = \"y\"\n[[axis]]\nname = \"z\"\n");
  EXPECT_TRUE(path.program.commands().empty());
  set_gcode(path, "G0 X5\nG1 X7 M8\n", "part.ngc");
  EXPECT_EQ(path.program.position()[0], 17);
  EXPECT_EQ(path.program.settings()[path.program.commands()[0].settings].velocity, 200);
  EXPECT_EQ(path.program.settings()[path.program.commands()[1].settings].velocity, 100);
  EXPECT_EQ(path.source, "part.ngc");
  EXPECT_EQ(path.events.size(), 1U);
  EXPECT_THROW(set_gcode(path, "G0 X5\n", "part.ngc"), InputError);
}

/// A spec with a file beside it.
class PathBesideFile : public test::WithFolder {
 protected:
  PathSpec with(const std::string& top, const std::string& name, const std::string& text) {
    write_file((folder_ / name).string(), text);
    write_file((folder_ / "spec.toml").string(),
               "jounce = 1\n" + top +
                   "kind = \"path\"\nunits = { position = \"mm\" }\npath = { velocity = 100 }\n"
                   "axis = [{ name = \"X\" }, { name = \"Y\" }]\n");
    return std::get<PathSpec>(read_spec((folder_ / "spec.toml").string()).subject);
  }

  std::string complaint(const std::string& top, const std::string& name, const std::string& text) {
    try {
      (void)with(top, name, text);
    } catch (const InputError& error) {
      const std::string what = error.what();
      return what.substr(what.rfind('/', what.find(": ")) + 1);
    }
    return "none";
  }
};

TEST_F(PathBesideFile, TakesPointsWithTheirFeeds) {
  const PathSpec path = with("points = \"p.csv\"\n", "p.csv",
                             "x [cm];y [mm];velocity [m/min]\n1;0;6\n2;0;3\n2;30;6\n");
  EXPECT_EQ(path.program.start()[0], 10);
  ASSERT_EQ(path.program.commands().size(), 2U);
  EXPECT_EQ(path.program.commands()[1].line, 4);
  EXPECT_DOUBLE_EQ(path.program.settings()[path.program.commands()[0].settings].velocity, 50);
  EXPECT_THAT(path.source, HasSubstr("p.csv"));
}

TEST_F(PathBesideFile, RejectsPointsThatDoNotFit) {
  const std::string top = "points = \"p.csv\"\n";
  EXPECT_EQ(complaint(top, "p.csv", "x,y,z\n1,2,3\n2,3,4\n"),
            "p.csv:1: z: is not a column of this table; possible columns: velocity, x, y: "
            "delete the column, or give it one of these names");
  EXPECT_THAT(complaint(top, "p.csv", "x,y\n1,2\n"), HasSubstr("p.csv:2: is the only point"));
  EXPECT_THAT(complaint(top, "p.csv", "x,velocity\n1,2\n2,3\n"),
              HasSubstr("p.csv:1: column \"y\": is missing"));
  EXPECT_THAT(complaint(top, "p.csv", "x,y,velocity\n1,2,1\n2,3,0\n"),
              HasSubstr("p.csv:3:5: velocity = 0 mm/s"));
}

TEST_F(PathBesideFile, TakesAGcodeProgram) {
  const PathSpec path = with("gcode = { file = \"part.ngc\" }\n", "part.ngc", "G1 X10 F600\nY10\n");
  EXPECT_EQ(path.program.commands().size(), 2U);
  EXPECT_THAT(complaint("gcode = { file = \"part.ngc\" }\n", "part.ngc", "G1 X10 F600\nQ10\n"),
              HasSubstr("part.ngc:2:1: Q10: a parameter of a cycle"));
}

const std::string robot = R"(jounce = 1
kind = "path"
units = { position = "mm", time = "s" }
[path]
velocity = 100
start = [300, 100]
[[axis]]
name = "x"
[[axis]]
name = "y"
[[command]]
type = "line"
to = [400, 0]
)";  // 13 lines

const std::string joints = R"([[joint]]
name = "a0"
limits = { velocity = 100 }
[[joint]]
name = "a1"
limits = { velocity = 200 }
)";

TEST(PathSpecFile, ReadsAScaraBehindItsAxes) {
  const Spec spec = parse_spec(
      robot + "[kinematics]\ntype = \"scara\"\narms = [300, 250]\nelbow = \"left\"\n" + joints,
      "path.toml");
  ASSERT_EQ(spec.axes.size(), 4U);
  EXPECT_EQ(spec.axes[2].units.position, "deg");
  const auto& path = std::get<PathSpec>(spec.subject);
  EXPECT_EQ(path.limits.axes.size(), 2U);
  ASSERT_TRUE(path.joints);
  EXPECT_EQ(path.joints->limits[1].velocity, 200);
  std::array<Jet, 2> at;
  ASSERT_EQ(path.joints->map->jets(std::array<Jet, 2>{Jet{250}, Jet{300}}, at), MapState::ok);
  EXPECT_NEAR(at[0][0], 90, 1e-9);
  EXPECT_NEAR(at[1][0], -90, 1e-9);
}

TEST(PathSpecFile, ReadsEachKindOfJoints) {
  const auto map_of = [](const std::string& text) { return read(text, "").joints->map; };
  EXPECT_NE(map_of(robot + "[kinematics]\ntype = \"corexy\"\n" + joints)->linear(), nullptr);
  const auto gantry =
      map_of(robot + "[kinematics]\ntype = \"gantry\"\n" +
             "[[joint]]\nname = \"y1\"\naxis = \"y\"\n[[joint]]\nname = \"y2\"\naxis = \"y\"\n" +
             "[[joint]]\nname = \"beam\"\naxis = \"x\"\n");
  EXPECT_EQ(gantry->joints(), 3U);
  std::string delta = robot;
  delta.replace(delta.find("start = [300, 100]"), 18, "start = [0, 0, 0]");
  delta.replace(delta.find("to = [400, 0]"), 13, "to = [10, 0, 5]");
  delta.replace(delta.find("[[command]]"), 0, "[[axis]]\nname = \"z\"\n");
  EXPECT_EQ(map_of(delta +
                   "[kinematics]\ntype = \"linear_delta\"\nouter_radius = 200\ninner_radius = "
                   "40\narm = 320\n" +
                   joints + "[[joint]]\nname = \"a2\"\n")
                ->joints(),
            3U);
}

TEST(PathSpecFile, RejectsJointsThatDoNotFitWithTheirKeys) {
  const std::string scara = "[kinematics]\ntype = \"scara\"\narms = [300, 250]\n";
  const auto refused = [](const std::string& text) { return complaint(text, ""); };
  EXPECT_THAT(refused(robot + joints),
              HasSubstr("joint: needs [kinematics]: add it, or remove [[joint]]"));
  EXPECT_THAT(refused(robot + scara), HasSubstr("joint: is missing: add [[joint]] for each joint"));
  EXPECT_THAT(refused(robot + scara + joints + "[[joint]]\nname = \"a2\"\n"),
              HasSubstr("joint = 3: must be 2 joints for this type"));
  EXPECT_THAT(refused(robot + "[kinematics]\ntype = \"scara\"\narms = [300, 0]\n" + joints),
              HasSubstr("kinematics.arms = 0: must be"));
  EXPECT_THAT(refused(robot + "[kinematics]\ntype = \"scara\"\narms = [300]\n" + joints),
              HasSubstr("kinematics.arms = 1: must be the lengths"));
  EXPECT_THAT(refused(robot + "[kinematics]\ntype = \"linear_delta\"\narm = 3\n" + joints),
              HasSubstr("kinematics.type = \"linear_delta\": needs the axes x, y and z"));
  EXPECT_THAT(refused(robot + scara + "wrist = 3\n" + joints), HasSubstr("kinematics.wrist"));
  EXPECT_THAT(refused(robot + scara +
                      "[[joint]]\nname = \"a0\"\nunit = \"mm\"\n[[joint]]\nname = \"a1\"\n"),
              HasSubstr("must be deg for this joint"));
  std::string overlap = robot;
  overlap.replace(overlap.find("start = [300, 100]"), 0, "overlap = { deviation = 1 }\n");
  EXPECT_THAT(refused(overlap + scara + joints),
              HasSubstr("kinematics: cannot be combined with overlap"));
  const std::size_t in_path = overlap.find("overlap = ");
  EXPECT_THAT(refused(overlap.substr(0, in_path) + "refine = true\n" + overlap.substr(in_path)),
              HasSubstr("path.refine = true: cannot be combined with overlap"));
  std::string refine = robot;
  refine.insert(refine.find("start = [300, 100]"), "refine = true\n");
  EXPECT_THAT(refused(refine + "[[override]]\ntime = 0\nfactor = 0.5\n"),
              HasSubstr("path.refine = true: cannot be combined with [[override]]"));
}

TEST(PathSpecFile, AFramePutsTheCommandsIntoTheMachine) {
  const PathSpec turned = read("[frame]\noffset = [10, 20, 5]\nrotation = 90\n" +
                               command("type = \"line\"\nto = [3, 0, 7]"));
  EXPECT_THAT(turned.program.start(), ElementsAre(10, 20, 5, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT(turned.program.position(), ElementsAre(10, 23, 12, 0, 0, 0, 0, 0, 0));
  EXPECT_THAT(complaint("[frame]\nrotation = 90\nzyz = [1, 2, 3]\n" +
                        command("type = \"line\"\nto = [3, 0, 7]")),
              HasSubstr("frame.zyz: cannot be combined with rotation"));
  EXPECT_THAT(complaint("[frame]\nzyz = [1, 2, 3]\n" + command("type = \"line\"\nto = [3, 0, 7]")),
              HasSubstr("frame.zyz: needs three axes that are not followers"));
}

TEST(PathSpecFile, ARotaryFollowerTakesTheShortestWay) {
  std::string rotary = head;
  rotary.replace(rotary.find("follower = true"), 15, "follower = true\nmodulo = 360");
  const PathSpec path =
      read(command("type = \"line\"\nto = [10, 0, 350]") +
               "[[command]]\ntype = \"line\"\nto = [20, 0, 10]\n" +
               "[[command]]\ntype = \"line\"\nrelative = true\nto = [20, 0, 720]\n",
           rotary);
  EXPECT_EQ(path.program.numbers()[2], -10);
  EXPECT_EQ(path.program.numbers()[5], 10);
  EXPECT_EQ(path.program.position()[2], 730);
  EXPECT_THAT(complaint("",
                        "jounce = 1\nkind = \"path\"\nunits = { position = \"mm\", time = \"s\" "
                        "}\n[path]\n[[axis]]\nname = \"x\"\nmodulo = 360\n"),
              HasSubstr("needs follower = true"));
}

TEST(PathSpecFile, ABSplineAndASplineInArcLengthHaveTheirFeed) {
  const std::string points =
      "[[command.point]]\nto = [10, 20, 0]\n[[command.point]]\nto = [40, -10, "
      "0]\n[[command.point]]\nto = [60, 0, 0]\n";
  const PathSpec b = read(command("type = \"bspline\"\ntolerance = 1e-6") + points);
  ASSERT_EQ(b.program.curves().size(), 1U);
  EXPECT_LE(b.program.curves()[0].deviation, 1e-6);
  EXPECT_LT(b.program.curves()[0].speed_error, 1e-5);
  const PathSpec even = read(command("type = \"spline\"\ntolerance = 1e-6") + points);
  const PathSpec chords = read(command("type = \"spline\"") + points);
  EXPECT_LT(even.program.curves()[0].speed_error, 1e-5);
  EXPECT_GT(chords.program.curves()[0].speed_error, 1e-2);
  EXPECT_THAT(complaint(command("type = \"bspline\"\ndegree = 5") + points),
              HasSubstr("point = 4: a B-spline of degree 5 needs 6 points"));
}

/// The plan of an example; its joints keep their limits of velocity, acceleration and jerk.
Plan planned(const std::string& name) {
  const std::string file = std::string(JOUNCE_SOURCE_DIR) + "/examples/" + name;
  const Spec spec = parse_spec(read_file(file), file);
  const auto& path = std::get<PathSpec>(spec.subject);
  Plan made = plan(path.program, path.limits, {.joints = path.joints});
  const PlanAxes axes = to_axes(made);
  EXPECT_EQ(axes.curves.size(), spec.axes.size());
  for (std::size_t i = 0; i < axes.curves.size(); ++i)
    EXPECT_TRUE(check(axes.curves[i], made.given().limits.axes[i]).ok())
        << name << " " << spec.axes[i].name;
  return made;
}

TEST(PathSpecFile, TheExamplesOfRobotsKeepTheLimitsOfTheirJoints) {
  for (const char* name : {"scara", "linear-delta", "corexy"}) {
    const Plan made = planned(std::string("kinematics/") + name + ".toml");
    ASSERT_TRUE(made.given().fit) << name;
    EXPECT_TRUE(made.given().fit->proven) << name;
    EXPECT_LE(made.given().fit->error, 1.01e-9) << name;
    EXPECT_LE(made.duration(), made.stop_duration()) << name;
    RecordProperty(name, std::to_string(made.duration()) + " s, with stops " +
                             std::to_string(made.stop_duration()) + ", " +
                             std::to_string(made.given().fit->pieces) + " pieces");
  }
}

TEST(PathSpecFile, TheRecordsOfTheManualAreFasterThanWithStops) {
  const Plan made = planned("pmc600-path/sequence.toml");
  EXPECT_LT(made.duration(), 7.386350);
  EXPECT_GT(made.duration(), 7.386350 - 2 * 1000.0 / 2000);
}

TEST(PathSpecFile, ACommandHasLimitsOfAxesUntilOthersFollow) {
  const PathSpec path = read(
      command("type = \"line\"\nto = [1, 0, 0]\naxis_limits = { y = { velocity = 5 }, c = { jerk = "
              "\"900 deg/s^3\" } }") +
      "[[command]]\ntype = \"line\"\nto = [2, 0, 0]\n"
      "[[command]]\ntype = \"line\"\nto = [3, 0, 0]\naxis_limits = {}\n");
  const auto axes_of = [&](std::size_t k) {
    return path.program.settings()[path.program.commands()[k].settings].axes;
  };
  const std::vector<AxisRates> limits{{}, {.velocity = 5}, {.jerk = 900}};
  EXPECT_EQ(axes_of(0), limits);
  EXPECT_EQ(axes_of(1), limits);
  EXPECT_TRUE(axes_of(2).empty());
  EXPECT_THAT(complaint(command("type = \"line\"\nto = [1, 0, 0]\naxis_limits = { z = {} }")),
              HasSubstr("axis_limits.z"));
  EXPECT_THAT(complaint(command("type = \"line\"\nto = [1, 0, 0]\naxis_limits = { x = { velocity "
                                "= -5 } }")),
              HasSubstr("must be greater than 0"));
}

}  // namespace
}  // namespace jounce::path_spec_test
