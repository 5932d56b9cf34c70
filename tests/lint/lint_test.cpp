// SPDX-License-Identifier: Apache-2.0
#include "jounce/lint/lint.hpp"

#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>

#include "jounce/design/detail/cam_check.hpp"
#include "jounce/lint/run.hpp"

#include "support/errors.hpp"
#include "support/temporary_folder.hpp"

namespace jounce::lint_test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

const std::string examples = JOUNCE_SOURCE_DIR "/examples/";

std::vector<Report> check_axes(std::vector<Input>& axes) {
  std::vector<Report> reports;
  for (const Input& axis : axes) {
    reports.push_back(checked(axis));
    add_no_limits(reports.back());
  }
  return reports;
}

class Lint : public test::WithFolder {
 protected:
  FileResult linted(const std::string& text, const char* name = "a.toml") {
    std::ofstream(in(name), std::ios::binary) << text;
    return lint_file(in(name), check_axes);
  }
};

/// "line:column rule key" of the statements at a level.
std::vector<std::string> places(const FileResult& file, Level level) {
  std::vector<std::string> all;
  for (const Diagnostic& d : file.diagnostics)
    if (d.level == level)
      all.push_back(std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + " " +
                    d.rule + " " + d.key);
  return all;
}

const std::string cam_head =
    "jounce = 1\nkind = \"cam\"\nunits = { master = \"deg\", position = \"mm\" }\n"
    "start = { master = 0, slave = 0 }\n";  // 4 lines

TEST_F(Lint, ABrokenLimitIsAtTheTableOfItsSegment) {
  const FileResult file = linted(cam_head +
                                 "[[segment]]\nlaw = \"dwell\"\nend = { master = 10, slave = 0 }\n"
                                 "[[segment]]\nlaw = \"345\"\nend = { master = 60, slave = 50 }\n"
                                 "[limits]\n# a comment\ngeo_velocity = 1\n");
  EXPECT_EQ(file.kind, "cam");
  EXPECT_THAT(places(file, Level::broken), ElementsAre("8:1 limit/geo_velocity segment[2]"));
  const Diagnostic& d = file.diagnostics.front();
  EXPECT_EQ(d.limit_place.line, 13);
  EXPECT_EQ(d.segment, "2");
  EXPECT_NEAR(*d.value, 1.875, 1e-12) << "Cv of the polynomial 3-4-5, 50 mm over 50 deg";
  EXPECT_EQ(*d.limit, 1);
  EXPECT_NEAR(*d.margin, -0.875, 1e-12);
  EXPECT_NEAR(*d.where, 35, 1e-9);
  EXPECT_EQ(d.unit, "mm/deg");
}

TEST_F(Lint, AllErrorsThatDoNotDependOnEachOtherAreReported) {
  const FileResult file =
      linted(cam_head +
             "[[segment]]\nlaw = \"345\"\nend = { master = \"6 kg\", slave = 5 }\ncolor = 3\n"
             "[[segment]]\nlaw = \"345x\"\nend = { master = 20, slave = 5 }\n"
             "[[segment]]\nlaw = \"dwell\"\nend = { master = 30 }\n"
             "[limits]\ngeo_velocity = \"fast\"\ngeo_jrek = 3\n"
             "[table]\ntolerance = true\n");
  EXPECT_THAT(places(file, Level::error),
              ElementsAre("7:18 input/key segment[1].end.master", "8:1 input/key segment[1].color",
                          "10:7 input/key segment[2].law", "14:7 input/key segment[3].end.slave",
                          "16:16 input/key limits.geo_velocity", "17:1 input/key limits.geo_jrek",
                          "19:13 input/key table.tolerance"));
  EXPECT_THAT(file.diagnostics[0].message, HasSubstr("segment[1].end.master = \"6 kg\": "));
}

TEST_F(Lint, AnErrorDoesNotCauseOthers) {
  const FileResult unit = linted(
      "jounce = 1\nkind = \"move\"\nunits = { position = \"mmm\" }\n[move]\nprofile = "
      "\"trapezoid\"\nto = \"3 cm\"\nvelocity = 3\nacceleration = 3\n[limits]\nvelocity = 3\n");
  EXPECT_THAT(places(unit, Level::error), ElementsAre("3:22 input/key units.position"));
  const FileResult placeholder = linted(
      "jounce = 1\nkind = \"axes\"\nunits = { position = \"mm\" }\n[[axis]]\nname = \"x\"\nto = 3\n"
      "position_min = \"5 kg\"\nposition_max = 0.5\nvelocity = 3\n");
  EXPECT_THAT(places(placeholder, Level::error), ElementsAre("7:16 input/key axis[1].position_min"))
      << "the rule position_min < position_max is not applied to the placeholder";
}

TEST_F(Lint, AMotionWithoutLimitsIsAWarningOfItsOwn) {
  const std::string segment = "[[segment]]\nlaw = \"345\"\nend = { master = 60, slave = 50 }\n";
  const FileResult none = linted(cam_head + segment);
  EXPECT_EQ(none.worst(), Level::warning);
  EXPECT_THAT(places(none, Level::warning), testing::Contains("2:8 warning/no_limits kind"));
  const FileResult one = linted(cam_head + segment + "[limits]\nposition_max = 60\n");
  EXPECT_THAT(places(one, Level::warning), testing::Not(testing::Contains(HasSubstr("no_limits"))));
}

TEST_F(Lint, ATableThatNoExecutorPlaysIsAWarningAtItsOutside) {
  const auto spec = [](const std::string& outside) {
    return "jounce = 1\nkind = \"pvt\"\nunits = { position = \"mm\" }\noutside = \"" + outside +
           "\"\n[[knot]]\ntime = 0\nposition = 0\nvelocity = 0\n[[knot]]\ntime = 1\n"
           "position = 5\nvelocity = 0\n[limits]\nvelocity = 9\n";
  };
  EXPECT_THAT(places(linted(spec("advance")), Level::warning),
              ElementsAre("4:11 warning/not_played outside"));
  EXPECT_THAT(places(linted(spec("hold")), Level::warning), IsEmpty());
}

TEST_F(Lint, AMotionOverTimePointsToItsLimit) {
  const FileResult file = linted(
      "jounce = 1\nkind = \"axes\"\nunits = { position = \"mm\" }\n"
      "[[axis]]\nname = \"x\"\nto = 30\nvelocity = 3\nacceleration = 9\n"
      "[[axis]]\nname = \"y\"\nto = 30\nvelocity = 3\nacceleration = 9\n[axis.limits]\nvelocity = "
      "2\n");
  EXPECT_THAT(places(file, Level::broken),
              testing::AllOf(testing::Not(IsEmpty()),
                             testing::Each("15:12 limit/velocity axis[2].limits.velocity")));
  const Diagnostic& d = file.diagnostics.front();
  EXPECT_EQ(d.axis, "y");
  EXPECT_EQ(d.limit_place.line, 15);
}

TEST_F(Lint, ACommandOfAQueueAndALineOfAProgramAreTheirPlaces) {
  const FileResult queue = linted(
      "jounce = 1\nkind = \"queue\"\nunits = { position = \"mm\" }\n"
      "[dynamics]\nvelocity = 10\nacceleration = 100\njerk = 1000\n"
      "[[command]]\ntype = \"absolute\"\nposition = 10\nvelocity = 2\n"
      "[[command]]\ntype = \"absolute\"\nposition = 90\n"
      "[limits]\nvelocity = 5\n");
  ASSERT_EQ(queue.worst(), Level::broken) << queue.diagnostics.front().message;
  EXPECT_THAT(places(queue, Level::broken), testing::Each(HasSubstr("12:1 limit/velocity")));

  std::ofstream(in("part.ngc")) << "G21 G90\nG1 X10 Y0 F600\nG1 X10 Y50 F6000\n";
  std::ofstream(in("mill.toml"))
      << "jounce = 1\nkind = \"path\"\nunits = { position = \"mm\" }\n[path]\n[path.limits]\n"
         "velocity = 200\nacceleration = 1000\njerk = 10000\n"
         "[[axis]]\nname = \"x\"\n[[axis]]\nname = \"y\"\n";
  const auto slower = [](std::vector<Input>& axes) {  // than the plan, which keeps its own limits
    axes[1].limits.velocity = 50;
    return check_axes(axes);
  };
  const FileResult program = lint_file(in("part.ngc"), slower, in("mill.toml"));
  ASSERT_THAT(program.diagnostics, testing::Not(IsEmpty()));
  EXPECT_EQ(program.kind, "G-code");
  EXPECT_EQ(program.diagnostics.front().level, Level::broken)
      << program.diagnostics.front().message;
  EXPECT_EQ(program.diagnostics.front().place.file, in("part.ngc"));
  EXPECT_EQ(program.diagnostics.front().place.line, 3);
  EXPECT_EQ(lint_file(in("mill.toml"), check_axes).worst(), Level::good)
      << "a path without commands is a machine";
}

TEST_F(Lint, EveryKindOfFileIsRead) {
  std::set<std::string> kinds;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(examples)) {
    const std::string path = entry.path().string();
    if (!path.ends_with(".toml") || path.ends_with("as-printed.toml")) continue;  // a misprint
    const FileResult file =
        lint_file(path, [](std::vector<Input>& axes) { return std::vector<Report>(axes.size()); });
    EXPECT_EQ(file.count(Level::error), 0U)
        << path << ": " << (file.diagnostics.empty() ? "" : file.diagnostics.front().message);
    kinds.insert(file.kind);
  }
  for (const char* kind : {"cam", "gear", "follow", "knife", "shear", "move", "queue", "axes",
                           "path", "pvt", "pt", "axis", "machine", "drive", "sweep"})
    EXPECT_TRUE(kinds.contains(kind)) << kind;
}

TEST_F(Lint, AMachineNamesTheSpecOfAnAxisThatIsMissing) {
  const FileResult file =
      linted("jounce = 1\nkind = \"machine\"\n[[axis]]\nspec = \"gone.toml\"\n", "m.toml");
  EXPECT_THAT(places(file, Level::error), ElementsAre("4:8 input/key axis[1].spec"));
  EXPECT_TRUE(is_without_motion(in("m.toml")));
}

TEST_F(Lint, AKeyIsForItsOwnerAlone) {
  std::ofstream(in("line.key")) << std::string(64, 'a');
  std::filesystem::permissions(in("line.key"), std::filesystem::perms(0644));
  EXPECT_THAT(lint_file(in("line.key"), check_axes).diagnostics,
              ElementsAre(AllOf(Field(&Diagnostic::rule, "input/key"),
                                Field(&Diagnostic::message, HasSubstr("chmod 600")))));
  std::filesystem::permissions(in("line.key"), std::filesystem::perms(0600));
  EXPECT_THAT(lint_file(in("line.key"), check_axes).diagnostics, IsEmpty());
}

TEST_F(Lint, ManyFilesKeepTheirOrderOnAllCores) {
  std::vector<std::string> files;
  for (int i = 0; i < 40; ++i) {
    files.push_back(in(("f" + std::to_string(i) + ".toml").c_str()));
    std::ofstream(files.back()) << cam_head
                                << "[[segment]]\nlaw = \"345\"\nend = { master = " << 60 + i
                                << ", slave = 50 }\n[limits]\ngeo_velocity = 1.25\n";
  }
  files.push_back(in("missing.toml"));
  const auto results = lint_files(files, check_axes);
  ASSERT_THAT(results, SizeIs(41));
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_EQ(results[i].file, files[i]);
    // Cv 1.875: the limit holds from 75 deg on.
    EXPECT_EQ(results[i].worst() >= Level::broken, i < 15) << i;
  }
  EXPECT_THAT(places(results.back(), Level::error), ElementsAre("0:0 input/file "));
}

TEST_F(Lint, ASpecOfTablesNeedsATable) {
  std::ofstream(in("a.toml"), std::ios::binary)
      << cam_head + "[[segment]]\nlaw = \"345\"\nend = { master = 60, slave = 50 }\n";
  const LintOptions options{.against = "b.toml"};
  EXPECT_THAT(
      test::error_of([&] { (void)lint_run("check", {in("a.toml")}, check_axes, options); }),
      HasSubstr("--against = b.toml: is the spec of tables, but none of the files is a table"));
  std::ofstream(in("t.csv"), std::ios::binary) << "# jounce table 1\nwrong\n";
  EXPECT_NO_THROW((void)lint_run("check", {in("a.toml"), in("t.csv")}, check_axes, options))
      << "the table has an error of its own";
}

/// Specs, and their accepted versions in a folder.
class Accepted : public Lint {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(in("accepted"));
    std::filesystem::create_directories(in("now"));
    std::filesystem::current_path(in("now"));
  }
  void TearDown() override { std::filesystem::current_path("/"); }

  void give(const char* name, const std::string& before, const std::string& now) {
    std::ofstream(in("accepted") + "/" + name, std::ios::binary) << before;
    std::ofstream(name, std::ios::binary) << now;
  }
  [[nodiscard]] LintedFiles compared(std::vector<std::string> tolerances = {}) {
    return lint_run(
        "check", {"."}, check_axes,
        {.baseline = in("accepted"), .accepted = {.tolerances = std::move(tolerances)}});
  }
  /// The statements about the accepted version, each with its severity.
  std::vector<std::string> changes(std::vector<std::string> tolerances = {}) {
    std::vector<std::string> all;
    for (const FileResult& file : compared(std::move(tolerances)).result.files)
      for (const Diagnostic& d : file.diagnostics)
        if (d.rule == "baseline/changed")
          all.push_back(std::string(severity(d.level)) + ": " + d.message);
    return all;
  }
};

TEST_F(Accepted, AFolderIsNotItsOwnBaseline) {
  give("a.toml", cam_head, cam_head);
  EXPECT_THAT(test::error_of([] { (void)lint_run("check", {"."}, check_axes, {.baseline = "."}); }),
              HasSubstr("FILE = .: contains only files of the accepted versions, ."));
}

TEST_F(Accepted, AFolderOfGCodeProgramsNamesTheOption) {
  std::ofstream("part.ngc") << "G21 G90\nG1 X1 F100\n";
  EXPECT_THAT(test::error_of([] { (void)lint_run("check", {"."}, check_axes); }),
              HasSubstr("G-code programs (1): name each program, with --machine SPEC"));
  give("a.toml", "", cam_head);
  EXPECT_EQ(lint_run("check", {"."}, check_axes).result.programs, 1U);
}

const std::string cam_rise = cam_head +
                             "[[segment]]\nlaw = \"345\"\n"
                             "end = { master = 60, slave = 50 }\n";

TEST_F(Accepted, AChangedLimitOfAnySectionIsAChange) {
  const std::string limits = cam_rise + "[limits.slave]\nvelocity = ";
  give("a.toml", limits + "\"0.6 m/s\"\n", limits + "\"6 m/s\"\n");
  EXPECT_THAT(changes(), ElementsAre("error: limit slave.velocity differs from the accepted "
                                     "version: 0.6 m/s -> 6 m/s"));
  EXPECT_THAT(to_markdown(compared().changes, "accepted"),
              HasSubstr("- limit slave.velocity: 0.6 m/s -> 6 m/s\n"));
  give("a.toml", limits + "3\n", cam_rise);
  EXPECT_THAT(changes(), ElementsAre("error: limit slave.velocity differs from the accepted "
                                     "version: 3 mm/s -> none"));
}

TEST_F(Accepted, OtherKeysAreOneWarning) {
  const std::string disc = cam_rise + "[disc]\nroller_radius = 12\nbase_radius = ";
  give("a.toml", disc + "60\n", disc + "50\n[master]\nvelocity = 2\n");
  EXPECT_THAT(changes(),
              ElementsAre("warning: the spec differs outside the curve: disc.base_radius 60 mm -> "
                          "50 mm; master.velocity none -> 2 deg/s"));
  const LintedFiles all = compared();
  EXPECT_EQ(all.changes[0].what, FileChange::What::changed);
  EXPECT_THAT(to_markdown(all.changes, "accepted"), HasSubstr("disc.base_radius 60 mm -> 50 mm"));
  give("a.toml", disc + "60\n", "# a comment\n" + disc + "\"6 cm\"\n");
  EXPECT_THAT(changes(), IsEmpty());
}

TEST_F(Accepted, AWrongFileThatASpecNamesMakesItWrong) {
  const std::string spec =
      "jounce = 1\nkind = \"pvt\"\nunits = { position = \"mm\", time = \"s\" }\n"
      "rule = \"natural\"\npoints = \"p.csv\"\n";
  give("a.toml", spec, spec);
  give("p.csv", "time,position\n0,0\n1,2\n2,3\n", "time,position\n0,0\n1,2\n0.5,3\n");
  const LintedFiles all = compared();
  ASSERT_THAT(all.changes, SizeIs(1));
  EXPECT_EQ(all.changes[0].what, FileChange::What::wrong);
  EXPECT_THAT(changes(), IsEmpty());
}

TEST_F(Accepted, AToleranceAppliesWhereItsUnitFits) {
  const std::string in_deg =
      "jounce = 1\nkind = \"cam\"\nunits = { master = \"deg\", position = \"deg\" }\n"
      "start = { master = 0, slave = 0 }\n[[segment]]\nlaw = \"345\"\n"
      "end = { master = 60, slave = 90 }\n";
  std::string changed = cam_rise;
  changed.replace(changed.find("slave = 50"), 10, "slave = 50.0005");
  give("deg.toml", in_deg, in_deg);
  give("mm.toml", cam_rise, changed);
  EXPECT_THAT(changes({"position=1 um"}), IsEmpty());
  EXPECT_THAT(changes({"position=0.1 um"}), SizeIs(1));
  EXPECT_THAT(test::error_of([&] { (void)compared({"position=1 s"}); }),
              HasSubstr("tolerance = position=1 s: fits none of the compared motions"));
  EXPECT_THAT(test::error_of([&] { (void)compared({"wide"}); }),
              HasSubstr("tolerance = wide: must be a share"));
}

}  // namespace
}  // namespace jounce::lint_test
