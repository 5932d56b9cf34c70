// SPDX-License-Identifier: Apache-2.0
#include "jounce/lint/find_files.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "support/temporary_folder.hpp"

namespace jounce::find_files_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class FindFiles : public test::WithFolder {
 protected:
  void write(const std::string& name, const std::string& text) {
    const auto path = folder_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
  }
  /// The files that the names in the folder stand for, relative to it.
  std::vector<std::string> found(const std::vector<std::string>& names,
                                 const std::string& except = "") {
    std::vector<std::string> in_folder;
    for (const std::string& name : names) in_folder.push_back((folder_ / name).string());
    std::vector<std::string> all;
    for (const std::string& file :
         find_files(in_folder, except.empty() ? "" : (folder_ / except).string()))
      all.push_back(std::filesystem::path(file).lexically_relative(folder_).string());
    return all;
  }
};

TEST_F(FindFiles, AFolderHasControllerFilesThatARunDoesNotExamine) {
  write("cam.st", "// a cam for CODESYS SoftMotion, by jounce 0.1.0\n");
  write("a/cam.dmc", "REM a cam for Galil ECAM, by jounce 0.1.0\n");
  write("README.md", "Cams by jounce users\n");
  write("table.csv", "# jounce table 1, by jounce 0.1.0\n");
  write(".git/cam.st", "// a cam for CODESYS SoftMotion, by jounce 0.1.0\n");
  EXPECT_EQ(
      controller_files({folder_.string()}),
      (std::vector<std::string>{(folder_ / "a/cam.dmc").string(), (folder_ / "cam.st").string()}));
  EXPECT_EQ(controller_files({folder_.string(), (folder_ / "cam.st").string()}).size(), 1U)
      << "the other is named, so the run examines it";
  EXPECT_THAT(controller_files({(folder_ / "cam.st").string()}), IsEmpty());
}

TEST_F(FindFiles, AFolderHasGCodeProgramsThatNeedAMachine) {
  write("part.ngc", "(a part)\nG21 G90\nG1 X1 F100\n");
  write("a/PART.NC", "%\nN10 G0 X0\n");
  write("a/letter.nc", "Dear customer,\n");
  write("notes.txt", "G21 G90\n");
  write(".git/old.ngc", "G21\n");
  EXPECT_EQ(gcode_files({folder_.string()}),
            (std::vector<std::string>{(folder_ / "a/PART.NC").string(),
                                      (folder_ / "part.ngc").string()}));
  EXPECT_EQ(gcode_files({folder_.string(), (folder_ / "part.ngc").string()}).size(), 1U);
}

TEST_F(FindFiles, AFolderHasTheFilesWithAHeaderOfJounce) {
  write("b.toml", "jounce = 1\n");
  write("a/late.toml", "# a comment\n\n  kind = \"cam\"\njounce=1\n[units]\n");
  write("a/broken.toml", "jounce = 1\nthis is not TOML");
  write("bom.toml", "\xEF\xBB\xBFjounce = 1\n");
  write("table.csv", "# jounce table 1\n");
  write("table.json", "{\n \"jounce_table\": 1");
  write("line.key", std::string(64, 'a') + "\n");
  write("pyproject.toml", "[tool.x]\njounce = 1\n");
  write("jouncer.toml", "jouncer = 1\n");
  write("excel.csv", "a;b\n1;2\n");
  write("package.json", "{}");
  write("tls.key", "-----BEGIN PRIVATE KEY-----\n");
  write("notes.txt", "jounce = 1\n");
  write(".git/x.toml", "jounce = 1\n");
  write("a/.cache/x.toml", "jounce = 1\n");
  std::filesystem::create_directory_symlink(folder_ / "a", folder_ / "link");
  EXPECT_THAT(found({"."}), ElementsAre("a/broken.toml", "a/late.toml", "b.toml", "bom.toml",
                                        "line.key", "table.csv", "table.json"));
  EXPECT_THAT(found({"."}, "a"),
              ElementsAre("b.toml", "bom.toml", "line.key", "table.csv", "table.json"));
}

TEST_F(FindFiles, APatternStandsForTheFilesThatMatch) {
  write("top.toml", "jounce = 1\n");
  write("a/x.toml", "jounce = 1\n");
  write("a/b/y.toml", "jounce = 1\n");
  write("a/b/z.csv", "# jounce table 1\n");
  write("a/foreign.toml", "x = 1\n");
  EXPECT_THAT(found({"*.toml"}), ElementsAre("top.toml"));
  EXPECT_THAT(found({"**/*.toml"}), ElementsAre("top.toml", "a/x.toml", "a/b/y.toml"));
  EXPECT_THAT(found({"a/**"}), ElementsAre("a/x.toml", "a/b/y.toml", "a/b/z.csv"));
  EXPECT_THAT(found({"a/?.toml", "a/[wxy].toml"}), ElementsAre("a/x.toml")) << "once";
  EXPECT_THAT(found({"none*"}), IsEmpty());
}

TEST_F(FindFiles, ANamedFileIsTakenWhateverItIs) {
  write("foreign.toml", "x = 1\n");
  write("[1].toml", "jounce = 1\n");
  EXPECT_THAT(found({"foreign.toml", "missing.toml", "[1].toml", "./foreign.toml"}),
              ElementsAre("foreign.toml", "missing.toml", "[1].toml"));
  EXPECT_TRUE(is_one_file(in("[1].toml"))) << "a file, not a pattern";
  EXPECT_FALSE(is_one_file(in("[2].toml")));
  EXPECT_FALSE(is_one_file(folder()));
}

}  // namespace
}  // namespace jounce::find_files_test
