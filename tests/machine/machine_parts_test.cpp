// SPDX-License-Identifier: Apache-2.0
#include "jounce/machine/machine_parts.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "jounce/executor/detail/dispatcher.hpp"
#include "jounce/executor/detail/sent_program.hpp"
#include "jounce/machine/detail/group_position.hpp"

#include "support/errors.hpp"

namespace jounce::machine_parts_test {
namespace {

class MachineParts : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) / ("parts_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// A spec of kind "axis" in mm and min: 1.2 m/min.
  std::string axis(const std::string& name, const std::string& more = "") {
    const std::string path = (folder_ / (name + ".toml")).string();
    std::ofstream(path) << "jounce = 1\nkind = \"axis\"\nname = \"" << name
                        << "\"\nunits = { position = \"mm\", master = \"mm\", time = \"min\" }\n"
                           "[axis]\ncycle = \"2 ms\"\n[limits]\nvelocity = 1200\n"
                           "acceleration = 3600\n"
                        << more;
    return path;
  }

  /// A machine with these axes; `more` follows the last of them.
  std::string machine_of(const std::vector<std::string>& axes, const std::string& more) {
    const std::string path = (folder_ / "line.toml").string();
    std::ofstream file(path);
    file << "jounce = 1\nkind = \"machine\"\n";
    for (const std::string& name : axes) file << "[[axis]]\nspec = \"" << name << ".toml\"\n";
    file << more;
    return path;
  }

  std::filesystem::path folder_;
};

TEST_F(MachineParts, HaveTheNumbersOfTheirSpecsInSeconds) {
  const auto parts = machine_parts({.files = {axis("feeder")}, .log = "run.csv", .enable = true});
  ASSERT_EQ(parts.axes.size(), 1U);
  const ExecutorOptions& feeder = parts.axes[0];
  EXPECT_EQ(feeder.receiver.executor, "feeder");
  EXPECT_EQ(feeder.axis.period, 2'000'000);
  EXPECT_DOUBLE_EQ(feeder.axis.limits.velocity.value(), 20);
  EXPECT_DOUBLE_EQ(feeder.axis.limits.acceleration.value(), 1);
  EXPECT_EQ(feeder.log, "run.csv");
  EXPECT_TRUE(feeder.enable);
  EXPECT_TRUE(parts.masters.empty());
}

TEST_F(MachineParts, TheCheckOfASpecRejectsWhatTheRunRejects) {
  for (const auto& [more, key] :
       {std::pair{"position_max = 10\n[homing]\nmethod = 37\noffset = 500\n",
                  "homing.offset = 500"},
        {"[homing]\nmethod = 37\nindex_velocity = 5000\n", "homing.index_velocity = "},
        {"position_max = -7\n", "limits.position_max = -7"},
        {"[homing]\nmethod = 24\n", "homing.method = 24"}}) {
    const std::string file = axis("feeder", more);
    const std::string run = test::error_of([&] { machine_parts({.files = {file}}); });
    EXPECT_THAT(run, testing::HasSubstr(key));
    EXPECT_EQ(test::error_of([&] { require_axis(read_spec(file)); }), run);
  }
  EXPECT_NO_THROW(require_axis(read_spec(axis("feeder"))));
}

TEST_F(MachineParts, TheDefaultStartIsInsideTheLimits) {
  EXPECT_THAT(
      test::error_of([&] { machine_parts({.files = {axis("feeder", "position_min = 5\n")}}); }),
      testing::HasSubstr("limits.position_min = 5 mm: must be at most 0, the start position "
                         "of the axis: change the limit, or add position to [axis]"));
}

TEST_F(MachineParts, TheCheckOfAMachineRejectsWhatTheRunRejects) {
  (void)axis("feeder");
  (void)axis("knife");
  for (const auto& [more, key] :
       {std::pair{"follow = { axis = \"feder\" }\n", "did you mean feeder?"},
        {"follow = { axis = \"quick\" }\n",
         "is not an axis of this machine, which has feeder, knife: add the axis, or correct"},
        {"follow = { master = \"line\" }\n", "is not a master of this machine"},
        {"follow = { axes = \"feeder\" }\n",
         "follow.axes = \"feeder\": is not a key here: did you mean axis?"},
        {"follow = { of = \"actual\" }\n", "follow.axis: is missing: add axis = \"NAME\""},
        {"follow = { axis = \"feeder\", master = \"line\" }\n",
         "follow.axis = \"feeder\": cannot be combined with master"},
        {"[[group]]\nname = \"pair\"\naxes = [\"feeder\", \"knifee\"]\n", "did you mean knife?"},
        {"[[group]]\nname = \"knife\"\naxes = [\"feeder\"]\n", "also the name of an axis"}}) {
    const std::string file = machine_of({"feeder", "knife"}, more);
    const std::string run = test::error_of([&] { machine_parts({.files = {file}}); });
    EXPECT_THAT(run, testing::HasSubstr(key));
    EXPECT_EQ(test::error_of([&] { require_machine(*read_machine(file)); }), run);
  }
  EXPECT_NO_THROW(require_machine(*read_machine(machine_of({"feeder", "knife"}, ""))));
}

TEST_F(MachineParts, RejectAHomingThatNoDriveCanDo) {
  const std::string homing = "[homing]\nmethod = 24\nsearch_velocity = 60\nacceleration = 3600\n";
  EXPECT_THAT(
      test::error_of([&] { machine_parts({.files = {axis("feeder", homing)}}); }),
      testing::HasSubstr("homing.method = 24: needs a switch or an index, but this axis has "
                         "no drive that reports one"));
  EXPECT_EQ(test::error_of(
                [&] { machine_parts({.files = {axis("feeder", "[homing]\nmethod = 35\n")}}); }),
            "");
}

TEST_F(MachineParts, HaveTheCutterThatTheirSpecNames) {
  const auto write = [&](const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  };
  const auto parts_of = [&](const std::string& cutter, double velocity = 2000) {
    write("cutter.toml", cutter);
    const std::string spec = write(
        "shear.toml",
        "jounce = 1\nkind = \"axis\"\nname = \"shear\"\nunits = { position = \"mm\", master = "
        "\"mm\" }\n[axis]\ncutter = \"cutter.toml\"\n[limits]\nacceleration = 10000\n"
        "velocity = " +
            std::to_string(velocity) + "\n");
    return machine_parts({.files = {spec}});
  };
  const auto error_of = [&](const std::string& cutter, double velocity = 2000) {
    return test::error_of([&] { (void)parts_of(cutter, velocity); });
  };
  const auto shear = [](const std::string& unit, const std::string& more = "") {
    return "jounce = 1\nkind = \"shear\"\nunits = { position = \"mm\", master = \"" + unit +
           "\" }\n[shear]\nlengths = [\"1.2 m\", \"1 m\"]\nline_speed = \"60 m/min\"\n"
           "sync_time = \"150 ms\"\n" +
           more + "[limits.slave]\nvelocity = 2000\nacceleration = 10000\n";
  };
  const auto parts = parts_of(shear("mm"));
  ASSERT_TRUE(parts.axes[0].cutter);
  const CutTask& task = *parts.axes[0].cutter->task;
  EXPECT_EQ(task.list.lengths, (std::vector<double>{1200, 1000}));
  EXPECT_NEAR(task.possible.front().from, 966.42464345, 1e-6);
  EXPECT_THAT(
      error_of(shear("m")),
      testing::HasSubstr("shear.toml:6:10: axis.cutter = \"cutter.toml\": has units.master = "
                         "\"m\", but the axis has mm: use the same unit"));
  EXPECT_THAT(error_of("jounce = 1\nkind = \"drive\"\n[drive]\ninertia = 1\n"),
              testing::HasSubstr("cutter.toml"));
  EXPECT_THAT(error_of("jounce = 1\nkind = \"move\"\nunits = { position = \"mm\" }\n[move]\n"
                       "profile = \"trapezoid\"\nto = 1\nvelocity = 1\nacceleration = 1\n"),
              testing::HasSubstr("must be a spec of kind \"knife\" or \"shear\""));
  EXPECT_THAT(error_of(shear("mm"), 1100), testing::HasSubstr("cutter.toml"))
      << "with the lower limit of the axis, 1000 mm is too short";
  // [master] gives the speed of the line, so the message names its key.
  const std::string master = "[master]\nvelocity = 800\nacceleration = 500\n";
  EXPECT_THAT(
      error_of(shear("mm", master), 700),
      testing::AllOf(testing::HasSubstr("master.velocity = 800 mm/s: must be at most 700 mm/s"),
                     testing::Not(testing::HasSubstr("line_speed"))));
  EXPECT_THAT(error_of(shear("mm"), 700),
              testing::HasSubstr("shear.line_speed = 60 m/min: must be at most 42 m/min"));
  EXPECT_THAT(error_of(shear("mm", master)),
              testing::HasSubstr("shear.safety = 1: must be at least 1.0259"));
  EXPECT_EQ(error_of(shear("mm", "safety = 1.03\n" + master)), "");
}

TEST_F(MachineParts, FollowEachOtherByName) {
  const std::string leader = axis("line"), slave = axis("knife", "[follow]\naxis = \"line\"\n");
  const auto parts = machine_parts({.files = {slave, leader}});
  EXPECT_EQ(parts.axes[0].follow.index, 1U);
  EXPECT_EQ(parts.axes[0].follow.what, Follow::What::setpoint);
  EXPECT_THAT(test::error_of([&] { machine_parts({.files = {slave}}); }),
              testing::HasSubstr("follow.axis = line: is not an axis of this machine"));
}

TEST_F(MachineParts, SendTheirNoticesWithTheNameOfTheAxis) {
  std::vector<std::string> notices;
  const auto notify = [&](const std::string& notice) { notices.push_back(notice); };
  const auto parts = machine_parts({.files = {axis("a"), axis("b")}, .notify = notify});
  parts.axes[1].notify("late");
  EXPECT_THAT(notices, testing::ElementsAre("b: late"));
}

TEST(LogOf, NamesTheAxisIfThereAreSeveral) {
  EXPECT_EQ(log_of("run.csv", "feeder", 1), "run.csv");
  EXPECT_EQ(log_of("logs/run.csv", "feeder", 2), "logs/run.feeder.csv");
}

/// A machine of two axes and the group "plotter"; `more`: further keys of the group.
class MachineGroups : public MachineParts {
 protected:
  std::string machine(const std::string& group, const std::string& program) {
    axis("x");
    axis("y");
    std::ofstream(folder_ / "part.toml") << program;
    const std::string path = (folder_ / "machine.toml").string();
    std::ofstream(path) << "jounce = 1\nkind = \"machine\"\n[[axis]]\nspec = \"x.toml\"\n"
                           "[[axis]]\nspec = \"y.toml\"\n[[group]]\nname = \"plotter\"\n"
                        << group;
    return path;
  }
  static std::string part(const std::string& first = "x", const std::string& velocity = "10",
                          const std::string& unit = "mm") {
    const std::string limits = "limits = { velocity = 20, acceleration = 1, jerk = 10 }\n";
    return "jounce = 1\nkind = \"path\"\nunits = { position = \"" + unit +
           "\", time = \"s\" }\n[path]\nvelocity = " + velocity + "\n[[axis]]\nname = \"" + first +
           "\"\n" + limits + "[[axis]]\nname = \"y\"\n" + limits +
           "[[command]]\ntype = \"line\"\nto = [30, 40]\n";
  }
  std::string error(const std::string& group, const std::string& program = part()) {
    const std::string path = machine(group, program);
    return test::error_of([&] { machine_parts({.files = {path}}); });
  }
};

TEST_F(MachineGroups, AreVirtualAxesAfterTheOthers) {
  const std::string path =
      machine("axes = [\"x\", \"y\"]\nprogram = \"part.toml\"\ntolerance = \"2 um\"\n", part());
  const auto parts = machine_parts({.files = {path}, .log = "run.csv", .enable = true});
  ASSERT_EQ(parts.axes.size(), 3U);
  const ExecutorOptions& group = parts.axes[2];
  EXPECT_EQ(group.receiver.executor, "plotter");
  EXPECT_EQ(group.log, "run.plotter.csv");
  EXPECT_EQ(group.units.position, "mm");
  EXPECT_EQ(group.group->of.axes, (std::vector<std::size_t>{0, 1}));
  EXPECT_DOUBLE_EQ(group.group->of.tolerance, 0.002);
  EXPECT_FALSE(group.enable) << "its axes are enabled first";
  EXPECT_EQ(group.build_apart, 0U) << "the thread that receives a stop never plans a path";
  EXPECT_EQ(group.group->sent->stages.front().program->plan->path().length(), 50);
}

TEST_F(MachineGroups, HaveFollowersInTheirOwnUnits) {
  const ExecutorOptions head =
      machine_parts({.files = {JOUNCE_SOURCE_DIR "/examples/welding-head/machine.toml"}}).axes[3];
  EXPECT_EQ(head.group->coordinates(), (std::vector<std::string>{"x", "y", "c"}));
  EXPECT_EQ(head.group->path_axes(), 2U);
  EXPECT_EQ(head.group->coordinate_units(), (std::vector<std::string>{"mm", "mm", "deg"}));
  EXPECT_EQ(head.units.position, "mm");
  const double length = 2 * 10 + 2 * 80 + 2 * 40 + 20 * std::numbers::pi;
  EXPECT_NEAR(head.group->sent->stages.front().program->plan->path().length(), length, 1e-9)
      << "C turns by 360 deg, which do not count";
}

TEST_F(MachineGroups, RejectFollowersThatCannotFollow) {
  using testing::AllOf;
  using testing::HasSubstr;
  EXPECT_THAT(error("axes = [\"x\", \"y\"]\nfollowers = [\"y\"]\n"),
              AllOf(HasSubstr("machine.toml:10"),
                    HasSubstr("group[1].followers = y: is already an axis of this group")));
  EXPECT_THAT(error("followers = [\"y\"]\n"), HasSubstr("group[1].axes: is missing"));
  EXPECT_THAT(error("axes = []\nfollowers = [\"y\"]\n"), HasSubstr("group[1].axes: is missing"));
  EXPECT_THAT(error("axes = [\"x\"]\nfollowers = [\"z\"]\n"),
              HasSubstr("group[1].followers = z: is not an axis of this machine"));
  EXPECT_THAT(error("axes = [\"x\"]\nfollowers = \"y\"\n"),
              HasSubstr("must be a list of strings: followers = [\"y\"]"));
  EXPECT_THAT(error("axes = [\"x\"]\nfollowers = [\"y\"]\nprogram = \"part.toml\"\n"),
              HasSubstr("a follower of the group, but a path axis of the path"));
  EXPECT_THAT(
      error("axes = [\"x\", \"y\"]\nfollowers = [\"x\", \"y\"]\nkinematics = \"part.toml\"\n"),
      HasSubstr("kinematics"));
  std::string follower = part();
  follower.insert(follower.rfind("limits ="), "follower = true\n");
  EXPECT_EQ(error("axes = [\"x\"]\nfollowers = [\"y\"]\nprogram = \"part.toml\"\n", follower), "");
  follower.insert(follower.rfind("limits ="), "unit = \"deg\"\n");
  EXPECT_THAT(error("axes = [\"x\"]\nfollowers = [\"y\"]\nprogram = \"part.toml\"\n", follower),
              HasSubstr("has the unit deg for y, but the axis y of the group has mm"));
}

TEST_F(MachineGroups, TakeAProgramWithOtherNamesInItsOrder) {
  std::string program = part("u");
  program.replace(program.find("\"y\""), 3, "\"v\"");
  const std::string path = machine("axes = [\"y\", \"x\"]\nprogram = \"part.toml\"\n", program);
  EXPECT_EQ(machine_parts({.files = {path}}).axes[2].group->of.axes,
            (std::vector<std::size_t>{1, 0}));
}

TEST_F(MachineGroups, RejectWhatTheyCannotPlayWithItsPlace) {
  using testing::AllOf;
  using testing::HasSubstr;
  const std::string good = "axes = [\"x\", \"y\"]\nprogram = \"part.toml\"\n";
  EXPECT_THAT(error("axes = [\"x\", \"z\"]\nprogram = \"part.toml\"\n"),
              AllOf(HasSubstr("machine.toml:9"), HasSubstr("group[1].axes = z"),
                    HasSubstr("is not an axis of this machine")));
  EXPECT_THAT(error("axes = [\"y\", \"x\"]\nprogram = \"part.toml\"\n"),
              AllOf(HasSubstr("machine.toml:9"), HasSubstr("in the same order")));
  EXPECT_THAT(error(good, part("u")),
              HasSubstr("x: is axis 1 of the group, but axis 1 of the path is u"));
  EXPECT_THAT(error("axes = [\"x\"]\nprogram = \"part.toml\"\n"),
              HasSubstr("has 2 axes, but the group has 1"));
  std::string turned = part();
  turned.insert(turned.rfind("limits ="), "unit = \"deg\"\nfollower = true\n");
  EXPECT_THAT(error(good, turned),
              HasSubstr("has the unit deg for y, but the axis y of the group has mm"));
  EXPECT_THAT(error(good + "tolerance = \"1 s\"\n"), HasSubstr("machine.toml:11"));
  EXPECT_THAT(error(good + "tolerance = 1\n"),
              AllOf(HasSubstr("machine.toml:11"), HasSubstr("must be at most 0.04")));
  EXPECT_THAT(error(good + "speed = 1\n"), HasSubstr("group[1].speed"));
  EXPECT_THAT(error(good + "m_words = [0, 0.5]\n"),
              AllOf(HasSubstr("machine.toml:11"), HasSubstr("a list of M words")));
  EXPECT_THAT(error(good + "m_words = \"some\"\n"), HasSubstr("must be \"all\""));
  EXPECT_THAT(error(good + "m_word_timeout = \"0 s\"\n"), HasSubstr("m_word_timeout"));
  EXPECT_THAT(error(good, part("x", "10", "deg")), HasSubstr("has the unit deg"));
  EXPECT_THAT(error(good, "jounce = 1\nkind = \"path\"\n"), HasSubstr("part.toml"));
  EXPECT_THAT(error(good, "x = 1\n"), HasSubstr("part.toml"));
  std::string hard = part();
  for (int axis = 0; axis < 2; ++axis)
    hard.replace(hard.find("acceleration = 1"), 16, "acceleration = 9");
  EXPECT_THAT(error(good, hard), AllOf(HasSubstr("machine.toml:10"), HasSubstr("x.acceleration")));
}

TEST_F(MachineGroups, OfJointsHaveTheCoordinatesOfTheirTool) {
  const std::string examples = JOUNCE_SOURCE_DIR "/examples/";
  const auto scara = machine_parts({.files = {examples + "scara/machine.toml"}}).axes[3];
  EXPECT_EQ(scara.group->coordinates(), (std::vector<std::string>{"x", "y", "z"}));
  EXPECT_EQ(scara.group->names, (std::vector<std::string>{"a0", "a1", "z_joint"}));
  EXPECT_EQ(scara.units.position, "mm");
  EXPECT_EQ(scara.group->unit, "") << "deg and mm";
  EXPECT_EQ(scara.group->sent->stages.front().program->first, 3U);
  EXPECT_EQ(scara.group->sent->stages.front().program->axes.size(), 3U);
  const auto gantry = machine_parts({.files = {examples + "gantry/machine.toml"}}).axes[4];
  EXPECT_EQ(gantry.group->coordinates().size(), 3U);
  EXPECT_EQ(gantry.group->sent->stages.front().program->first, 3U);
  EXPECT_EQ(gantry.group->sent->stages.front().program->axes.size(), 4U);
}

/// The arms are 300 and 250 mm long. On the line y = 250 mm they reach to x = sqrt(550^2 - 250^2).
TEST(GroupPosition, APositionOutOfReachNamesTheLastOneInReach) {
  EXPECT_THAT(test::error_of([] {
                (void)converted_position(JOUNCE_SOURCE_DIR "/examples/scara/machine.toml", "",
                                         {"x=900", "y=250", "z=0"});
              }),
              testing::StartsWith(
                  "x = 900 mm, y = 250 mm, z = 0 mm: is out of reach of the joints: on the line "
                  "from the start of the joints, x = 300 mm, y = 250 mm, z = 0 mm, the last "
                  "position in reach is x = 489.126 mm, y = 250 mm, z = 0 mm"));
  // The remedy works. At sqrt(550^2 - 250^2) = 489.898 mm the arm is straight, beyond the range of a1.
  EXPECT_TRUE(converted_position(JOUNCE_SOURCE_DIR "/examples/scara/machine.toml", "",
                                 {"x=489.126", "y=250", "z=0"})
                  .inside());
  // The range of a0 is -130 to 130 deg.
  const auto beyond = converted_position(JOUNCE_SOURCE_DIR "/examples/scara/machine.toml", "",
                                         {"a0=131", "a1=90", "z_joint=0"});
  EXPECT_FALSE(beyond.inside());
  EXPECT_THAT(beyond.text(), testing::HasSubstr("a0 = 131 deg (above position_max, 130 deg)"));
}

TEST_F(MachineGroups, RejectAKinematicsOfOtherJoints) {
  using testing::HasSubstr;
  const auto belt = [&](const std::string& first, const std::string& map) {
    const std::string joint = "limits = { velocity = 20, acceleration = 1, jerk = 10 }\n";
    std::ofstream(folder_ / "belt.toml")
        << "jounce = 1\nkind = \"path\"\nunits = { position = \"mm\", time = \"s\" }\n[path]\n"
           "velocity = 10\n[[axis]]\nname = \"u\"\n[[axis]]\nname = \"v\"\n"
        << map << "[[joint]]\nname = \"" << first << "\"\n"
        << joint << "[[joint]]\nname = \"y\"\n"
        << joint;
  };
  const std::string core_xy = "[kinematics]\ntype = \"corexy\"\n";
  const std::string keys = "axes = [\"x\", \"y\"]\nkinematics = \"belt.toml\"\n";
  belt("a", core_xy);
  EXPECT_THAT(error(keys), HasSubstr("has the joints a, y, but the axes of the group are x, y"));
  belt("x", core_xy);
  const auto parts = machine_parts({.files = {machine(keys, part())}});
  EXPECT_EQ(parts.axes[2].group->coordinates(), (std::vector<std::string>{"u", "v"}));
  EXPECT_EQ(parts.axes[2].group->coordinate_units(), (std::vector<std::string>{"mm", "mm"}));
  EXPECT_THAT(error(keys + "program = \"part.toml\"\n"),
              HasSubstr("must be u, v, the coordinates of the group"));
  EXPECT_THAT(error("axes = [\"x\", \"y\"]\nkinematics = \"part.toml\"\n"),
              HasSubstr("must be a spec of kind \"path\" with [kinematics]"));
  EXPECT_THAT(error("axes = [\"x\", \"y\"]\nkinematics = \"none.toml\"\n"),
              HasSubstr("none.toml: cannot be read"));
  std::ofstream(folder_ / "tool.toml")
      << "jounce = 1\nkind = \"path\"\nunits = { position = \"mm\", time = \"s\" }\n[path]\n"
         "velocity = 10\n[kinematics]\ntype = \"corexy\"\n[[axis]]\nname = \"u\"\n"
         "[[axis]]\nname = \"v\"\n[[joint]]\nname = \"x\"\nlimits = { velocity = 20, "
         "acceleration = 1, jerk = 10 }\n[[joint]]\nname = \"y\"\nlimits = { velocity = 20, "
         "acceleration = 1, jerk = 10 }\n[[command]]\ntype = \"line\"\nto = [3, 4]\n";
  EXPECT_THAT(error("axes = [\"x\", \"y\"]\nprogram = \"tool.toml\"\n"),
              HasSubstr("add kinematics = \"FILE\" to the [[group]]"));
}

TEST_F(MachineGroups, TheNameOfAGroupIsItsOwn) {
  const std::string path = machine("axes = [\"x\", \"y\"]\nprogram = \"part.toml\"\n", part());
  std::string text;
  {
    std::ifstream file(path);
    text.assign(std::istreambuf_iterator<char>(file), {});
  }
  text.replace(text.find("plotter"), 7, "x");
  std::ofstream(path) << text;
  EXPECT_THAT(test::error_of([&] { machine_parts({.files = {path}}); }),
              testing::HasSubstr("is also the name of an axis"));
}

}  // namespace
}  // namespace jounce::machine_parts_test
