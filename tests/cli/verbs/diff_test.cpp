// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace jounce::diff_verb_test {
namespace {

using cli_test::cam;
using cli_test::Result;
using cli_test::slurp;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using DiffVerb = cli_test::Program;

TEST_F(DiffVerb, ComparesGCodePrograms) {
  const std::string part = cli_test::examples + "gcode-part/";
  std::string text = slurp(part + "plate.ngc");
  write("a.ngc", text);
  const auto feed = text.find(" F");
  ASSERT_NE(feed, std::string::npos);
  text.insert(feed + 2, "1");
  write("b.ngc", text);
  const std::string machine = " --machine " + part + "machine.toml";
  EXPECT_EQ(run("diff a.ngc a.ngc" + machine).status, 0);
  EXPECT_EQ(run("diff a.ngc " + part + "plate.toml" + machine).status, 0)
      << "a spec is read as one";
  EXPECT_EQ(run("diff a.ngc b.ngc" + machine).status, 1);
  const Result without = run("diff a.ngc b.ngc");
  EXPECT_EQ(without.status, 2);
  EXPECT_THAT(without.err,
              HasSubstr("or give that spec with --machine to check, design, diff, plot, report, "
                        "stream or validate"));
}

TEST_F(DiffVerb, ListsTheChangesWithTheStatusOfDiff) {
  EXPECT_EQ(run("diff " + cam + " " + cam).status, 0);
  std::string text = slurp(cam);
  text.replace(text.find("slave = 100, geo_velocity = 0.01739"), 11, "slave = 95 ");
  write("b.toml", text);
  const Result changed = run("diff " + cam + " b.toml -o both.svg");
  EXPECT_EQ(changed.status, 1);
  EXPECT_THAT(changed.out, HasSubstr("! position          differs by -5 pulse at 280 pulse"));
  EXPECT_THAT(changed.out,
              HasSubstr("~ knot 4 (end of 3 return) at 280 pulse, position 100 -> 95"));
  EXPECT_THAT(slurp(folder / "both.svg"), StartsWith("<svg"));
  EXPECT_EQ(run("diff " + cam + " b.toml --tolerance position=\"5 pulse\"").status, 0);
  EXPECT_EQ(run("diff " + cam + " b.toml --tolerance position=4.9").status, 1);
  EXPECT_EQ(run("diff " + cam + " b.toml --tolerance 1").status, 0);
  const Result documents = run("diff --json " + cam + " b.toml");
  EXPECT_EQ(documents.status, 1);
  const json report = json::parse(documents.out);
  EXPECT_FALSE(report["equal"].get<bool>());
  EXPECT_NEAR(report["changes"]["position"]["largest"]["value"].get<double>(), -5, 1e-12);
  EXPECT_EQ(report["knots"][0]["what"], "changed");
  EXPECT_EQ(run("diff " + cam + " nothing.toml").status, 2);
  EXPECT_EQ(run("diff " + cam + " b.toml --tolerance speed=1").status, 2);
  EXPECT_EQ(run("diff " + cam + " b.toml -o both.gif").status, 2);
}

TEST_F(DiffVerb, PairsAxesByName) {
  EXPECT_EQ(run("new axes -o a.toml").status, 0);
  EXPECT_EQ(run("diff a.toml a.toml").status, 0);
  const json report = json::parse(run("diff --json a.toml a.toml").out);
  EXPECT_TRUE(report["equal"].get<bool>());
  EXPECT_GE(report["axes"].size(), 2U);
  EXPECT_EQ(run("diff a.toml " + cam).status, 2);
}

}  // namespace
}  // namespace jounce::diff_verb_test
