// SPDX-License-Identifier: Apache-2.0
#include "jounce/report/detail/ci_formats.hpp"

#include <limits>
#include <string>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "jounce/base/input_errors.hpp"

namespace jounce::ci_formats_test {
namespace {

using nlohmann::json;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

Diagnostic statement(Level level, const std::string& file, int line, const std::string& message) {
  Diagnostic d;
  d.rule = "limit/velocity";
  d.level = level;
  d.place = {file, line, line > 0 ? 3 : 0};
  d.message = message;
  d.value = 61.4;
  d.limit = 50;
  d.margin = -0.228;
  return d;
}

RunResult run() {
  Diagnostic warning = statement(Level::warning, "a,b.toml", 2, "50 % more:\nslow");
  warning.rule = "warning/reversal";
  FileResult first{"a,b.toml", "cam", {warning, statement(Level::good, "a,b.toml", 4, "holds")}};
  FileResult second{"c d.toml", "move", {statement(Level::broken, "c d.toml", 9, "a < b & \"c\"")}};
  return {"check", {first, second, {"good.toml", "cam", {}}}};
}

TEST(CiFormats, TheStatusIsTheWorstLevel) {
  RunResult all{"check", {run().files[0]}};
  EXPECT_EQ(all.status(), 0);
  EXPECT_EQ(all.status(true), 1);
  all = run();
  EXPECT_EQ(all.status(), 1);
  all.files.push_back({"x", "", {statement(Level::error, "x", 0, "wrong")}});
  EXPECT_EQ(all.status(), 2);
  EXPECT_EQ(summary_line(all),
            "4 files: 2 good, 1 with 1 broken rule, 1 wrong (1 error); 1 warning");
}

TEST(CiFormats, TheSummaryOfAFileWithoutAMotionStatesIt) {
  EXPECT_EQ(summary_line({"check", {{"d.toml", "drive", {}}}}),
            "1 file: 1 good: its keys are valid; a spec of kind drive has no motion to examine");
  EXPECT_EQ(summary_line({"check", {{"c.toml", "cam", {}}}}), "1 file: 1 good");
  EXPECT_EQ(
      summary_line({"check", {{"c.toml", "cam", {}}}, 3}),
      "1 file: 1 good; 3 controller files not checked: give each file by its name, with --against "
      "SPEC");
  EXPECT_EQ(summary_line({"validate", {{"c.toml", "cam", {}}}, 1}),
            "1 file: 1 good; 1 controller file not checked: give this file by its name");
  EXPECT_EQ(summary_line({"check", {{"c.toml", "cam", {}}}, 0, 2}),
            "1 file: 1 good; 2 G-code programs not checked: give each file by its name, with "
            "--machine SPEC");
}

TEST(CiFormats, TextIsWhatCompilersPrint) {
  EXPECT_EQ(to_text(run()),
            "a,b.toml:2:3: warning: 50 % more:\nslow [warning/reversal]\n"
            "c d.toml:9:3: error: a < b & \"c\" [limit/velocity]\n");
  EXPECT_EQ(to_text(run(), true), "c d.toml:9:3: error: a < b & \"c\" [limit/velocity]\n");
}

TEST(CiFormats, GitHubHasTheWorstFirstAndEscapesWhatEndsACommand) {
  EXPECT_EQ(to_github(run()),
            "::error file=c d.toml,line=9,col=3,title=limit/velocity::a < b & \"c\"\n"
            "::warning file=a%2Cb.toml,line=2,col=3,title=warning/reversal::50 %25 more:%0Aslow\n");
}

TEST(CiFormats, JsonHasEveryFindingWithItsNumbers) {
  RunResult all = run();
  all.files[0].diagnostics[0].margin = -std::numeric_limits<double>::infinity();
  const json document = json::parse(to_json(all));
  EXPECT_EQ(document["ok"], false);
  EXPECT_EQ(document["status"], 1);
  ASSERT_EQ(document["files"].size(), 3U);
  const json& first = document["files"][0]["findings"];
  ASSERT_EQ(first.size(), 2U) << "limits that hold are included";
  EXPECT_TRUE(first[0]["margin"].is_null()) << "JSON has no infinity";
  EXPECT_EQ(first[1]["severity"], "ok");
  const json& broken = document["files"][1]["findings"][0];
  EXPECT_EQ(broken["line"], 9);
  EXPECT_EQ(broken["column"], 3);
  EXPECT_EQ(broken["value"], 61.4);
  EXPECT_EQ(broken["limit"], 50);
  EXPECT_EQ(broken["margin"], -0.228);
}

TEST(CiFormats, GitLabHasALineForEveryFinding) {
  RunResult all = run();
  all.files[1].diagnostics[0].place.line = 0;
  const json list = json::parse(to_gitlab(all));
  ASSERT_EQ(list.size(), 2U);
  EXPECT_EQ(list[0]["location"]["lines"]["begin"], 1);
  EXPECT_EQ(list[0]["severity"], "major");
  EXPECT_EQ(list[1]["severity"], "minor");
}

/// The fingerprints of the SARIF results.
std::vector<std::string> fingerprints(const RunResult& result) {
  std::vector<std::string> all;
  const json sarif = json::parse(to_sarif(result));
  for (const json& each : sarif["runs"][0]["results"])
    all.push_back(each["partialFingerprints"]["jounceFinding/v1"]);
  return all;
}

TEST(CiFormats, AFingerprintDoesNotDependOnLinesAndNumbers) {
  RunResult moved = run();
  moved.files[1].diagnostics[0].place.line = 90;
  moved.files[1].diagnostics[0].value = 70;
  moved.files[1].diagnostics[0].message = "another";
  ASSERT_EQ(fingerprints(run()).size(), 2U);
  EXPECT_EQ(fingerprints(moved), fingerprints(run()));
  RunResult twice = run();
  twice.files[1].diagnostics.push_back(twice.files[1].diagnostics[0]);
  const auto names = fingerprints(twice);
  ASSERT_EQ(names.size(), 3U);
  EXPECT_NE(names[0], names[1]) << "equal statements are different alerts";
}

TEST(CiFormats, SarifEncodesPathsAndNamesItsRules) {
  const json sarif = json::parse(to_sarif(run()));
  const json& one = sarif["runs"][0];
  EXPECT_EQ(one["results"][0]["locations"][0]["physicalLocation"]["artifactLocation"]["uri"],
            "c%20d.toml");
  for (const json& result : one["results"])
    EXPECT_EQ(one["tool"]["driver"]["rules"][result["ruleIndex"].get<std::size_t>()]["id"],
              result["ruleId"]);
}

TEST(CiFormats, JUnitHasACaseForEachStatementAndEachGoodFile) {
  const std::string xml = to_junit(run());
  EXPECT_THAT(xml, HasSubstr("tests=\"4\" failures=\"1\" errors=\"0\">"));
  EXPECT_THAT(xml, HasSubstr("message=\"a &lt; b &amp; &quot;c&quot;\""));
  EXPECT_THAT(xml, HasSubstr("<testcase classname=\"good.toml\" name=\"check\"/>"));
  EXPECT_THAT(to_junit(run(), true), HasSubstr("tests=\"4\" failures=\"2\""));
}

TEST(CiFormats, ErrorsAreInTheOrderOfTheDocument) {
  const InputErrors errors({InputError("b", "2", "must be 1").at("f.toml", 9, 1),
                            InputError("", "", "is bad").at("f.toml", 3)});
  EXPECT_STREQ(errors.what(), "f.toml:9:1: b = 2: must be 1") << "the first that was read";
  const auto all = diagnostics_of(errors, "f.toml");
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[0].rule, "input/file");
  EXPECT_EQ(all[0].place.line, 3);
  EXPECT_EQ(all[1].rule, "input/key");
  EXPECT_EQ(all[1].message, "b = 2: must be 1");
}

}  // namespace
}  // namespace jounce::ci_formats_test
