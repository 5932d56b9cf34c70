// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <string>
#include <utility>

#include <gmock/gmock.h>

#include "program.hpp"

namespace jounce::run_verb_test {
namespace {

using cli_test::examples;
using cli_test::Result;
using cli_test::slurp;
using ::testing::HasSubstr;

using RunVerb = cli_test::Program;

// The run would begin, and fail when it opens the log.
TEST_F(RunVerb, RejectsMissingFoldersBeforeItBegins) {
  EXPECT_EQ(run("new axis -o a.toml").status, 0);
  for (const char* option : {"--log", "--record", "--black-box"}) {
    const Result done =
        run(std::string("run a.toml --url memq:// --seconds 0.1 ") + option + " none/a.x");
    EXPECT_EQ(done.status, 2) << option;
    EXPECT_EQ(done.err, std::string("jounce: ") + option +
                            " = none/a.x: cannot be written, because the folder none does not "
                            "exist: make it first\n");
  }
}

TEST_F(RunVerb, ReportsWhereAnAxisContradictsItsLimits) {
  write("a.toml",
        "jounce = 1\nkind = \"axis\"\nname = \"a\"\nunits = { position = \"mm\" }\n[axis]\n"
        "stop_acceleration = 10\n[limits]\nvelocity = 1\nacceleration = 100\n");
  const Result run_it = run("run a.toml --url memq:// --seconds 1");
  EXPECT_EQ(run_it.status, 2);
  EXPECT_THAT(run_it.err,
              HasSubstr("a.toml:6:21: axis.stop_acceleration = 10 mm/s^2: must be at least"));
}

TEST_F(RunVerb, ReplacesNoFileOfItsMachine) {
  for (const char* name : {"gantry", "cut-plan"})
    std::filesystem::copy(examples + name, folder / name);
  for (const auto& [machine, file] : {std::pair{"gantry", "y1.toml"},
                                      {"gantry", "part.toml"},
                                      {"gantry", "part.ngc"},
                                      {"cut-plan", "drum.toml"},
                                      {"cut-plan", "knife.toml"},
                                      {"cut-plan", "line.toml"}}) {
    const std::string path = std::string(machine) + "/" + file;
    const std::string before = slurp(folder / path);
    const Result result =
        run("run " + std::string(machine) + "/machine.toml --seconds 0.1 --record " + path);
    EXPECT_EQ(result.status, 2) << path;
    EXPECT_THAT(result.err, HasSubstr(path + ": is also an input")) << path;
    EXPECT_EQ(slurp(folder / path), before) << path;
  }
}

}  // namespace
}  // namespace jounce::run_verb_test
