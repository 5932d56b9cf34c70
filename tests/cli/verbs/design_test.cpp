// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace jounce::design_verb_test {
namespace {

using cli_test::cam;
using cli_test::examples;
using cli_test::Result;
using cli_test::slurp;
using cli_test::via;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using DesignVerb = cli_test::Program;

TEST_F(DesignVerb, ReportsTheFindingsOfCheck) {
  const Result broken = run("design " + cam + " -o broken.csv");
  EXPECT_EQ(broken.status, 1);  // a CI that only designs sees it; the table is written
  EXPECT_THAT(broken.out, HasSubstr("jounce check: 2 findings; the worst: geo_velocity"));
  EXPECT_THAT(run("design " + cam + " -o broken.csv --json").out, HasSubstr("\"broken\":2"));
}

TEST_F(DesignVerb, EveryVerbThatWritesATableTakesOverTime) {
  const std::string pusher = examples + "press-pusher/pusher.toml";
  const Result check = run("check " + pusher + " --over time --limit jerk=1500m/s^3");
  EXPECT_EQ(check.status, 0) << check.err;
  EXPECT_THAT(check.out, HasSubstr("limit/jerk"));
  const Result design = run("design " + pusher + " --over time -o -");
  EXPECT_EQ(design.status, 0) << design.err;
  EXPECT_THAT(design.out, HasSubstr("time [s]"));
  EXPECT_EQ(
      run("convert " + pusher + " pt.csv --over time --rule linear --intervals 100 --allow-loss")
          .status,
      0);
  const Result lines = run("check pt.csv --continuity 0");
  EXPECT_EQ(lines.status, 1);
  EXPECT_THAT(lines.out, HasSubstr("limit/velocity_step"));
  EXPECT_THAT(run("design " + examples + "valve-cam/valve.toml --over time").err,
              HasSubstr("master: is missing"));
  EXPECT_THAT(run("check pt.csv --over time").err, HasSubstr("jounce: --over = time: "));
  EXPECT_THAT(run("check " + pusher + " " + cam + " --over time").err,
              HasSubstr("--over = time: applies to a single file: give one file"));
  EXPECT_THAT(run("check " + cam + " --over time --quiet").err,
              HasSubstr("--over = time: cannot be combined with --quiet"));
}

TEST_F(DesignVerb, WritesTablesThatCheckReads) {
  const Result csv = run("design " + cam);
  EXPECT_EQ(csv.status, 1);
  EXPECT_THAT(csv.out, StartsWith("# jounce table 1\n"));
  EXPECT_EQ(run("design " + cam + " | " JOUNCE_EXE " check - --limit geo_velocity=4").status, 0);
  EXPECT_EQ(run("design " + cam + " -o t.csv --curve c.json").status, 1);
  EXPECT_EQ(run("design " + cam + " -o t.json").status, 1);
  EXPECT_EQ(files(), (std::vector<std::string>{"c.json", "t.csv", "t.json"}));
  EXPECT_EQ(json::parse(slurp(folder / "c.json"))["segments"].size(), 4U);
  EXPECT_EQ(run("check t.json").status, 1) << "the limits of its spec";
}

TEST_F(DesignVerb, WritesATableForEachAxis) {
  const Result all = run("design " + via + " -o via.csv --curve via.curve.json");
  EXPECT_EQ(all.status, 0) << all.err;
  EXPECT_THAT(all.out, StartsWith("via points x: "));
  EXPECT_THAT(all.out, HasSubstr("\nvia points y: "));
  EXPECT_EQ(files(), (std::vector<std::string>{"via-x.csv", "via-y.csv", "via.curve-x.json",
                                               "via.curve-y.json"}));
  EXPECT_THAT(slurp(folder / "via-x.csv"), HasSubstr("4000"));
  EXPECT_EQ(run("check via-y.csv").status, 0);
  EXPECT_EQ(run("design " + via + " -o ./no_suffix").status, 0);
  EXPECT_THAT(files(), ::testing::Contains("no_suffix-y"));

  const json summary = json::parse(run("design --json " + via + " -o via.csv").out);
  EXPECT_EQ(summary["axes"]["y"]["table"], "via-y.csv");
  EXPECT_FALSE(summary.contains("ok"));

  const Result one = run("design " + via + " --axis y");
  EXPECT_EQ(one.status, 0);
  EXPECT_EQ(one.out, slurp(folder / "via-y.csv"));
}

TEST_F(DesignVerb, SeveralAxesNeedSeveralFiles) {
  const Result piped = run("design " + via);
  EXPECT_EQ(piped.status, 2);
  EXPECT_EQ(piped.err,
            "jounce: --output: is missing: with several axes, each needs a file. -o a.csv writes "
            "a-x.csv and so on; --axis x writes one axis only\n");
  EXPECT_EQ(piped.out, "");
  const Result other = run("design --axis z " + via);
  EXPECT_EQ(other.status, 2);
  EXPECT_EQ(other.err, "jounce: --axis = z: must be one of x, y\n");
  EXPECT_EQ(
      run("check " + cam + " --axis x").err,
      "jounce: --axis = x: " + cam + " has only one axis, without a name: leave out --axis\n");
  const Result streamed = run("stream --to feeder --url memq:// " + via);
  EXPECT_EQ(streamed.status, 2);
  EXPECT_EQ(streamed.err,
            "jounce: --axis: is missing: " + via + " has several axes. Choose one of x, y\n");
  EXPECT_EQ(run("report " + via + " -o both.html").status, 0);
  EXPECT_EQ(run("report --axis x " + via + " -o x.html").status, 0);
  EXPECT_EQ(run("plot " + via + " --before " + via).status, 2);
  EXPECT_EQ(run("plot --axis x " + via + " --before " + via).status, 0);
  EXPECT_EQ(run("validate " + via + " --log x.csv").status, 2);
}

TEST_F(DesignVerb, ReportsTheResidualVibration) {
  const std::string spec = examples + "generators/21-shaper.toml";
  EXPECT_THAT(run("design " + spec + " -o t.csv").out,
              HasSubstr("; without the operators 8.84401 mm\n"));
  const json residual = json::parse(run("design --json " + spec + " -o t.csv").out)["residuals"][0];
  EXPECT_EQ(residual["frequency"], 5.5);
  EXPECT_NEAR(residual["before"].get<double>(), 8.84401, 1e-5);
  EXPECT_LT(residual["after"].get<double>(), 1e-10);
}

}  // namespace
}  // namespace jounce::design_verb_test
