// SPDX-License-Identifier: Apache-2.0
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "program.hpp"

namespace jounce::usage_of_verbs_test {
namespace {

using cli_test::cam;
using cli_test::Result;
using cli_test::slurp;
using ::testing::HasSubstr;
using ::testing::Not;

using Usage = cli_test::Program;

/// The verbs that `jounce --help` lists.
std::vector<std::string> verbs_of(const std::string& help) {
  std::vector<std::string> verbs;
  std::istringstream lines(help.substr(help.find("Subcommands:\n")));
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line) && !line.empty();)
    if (line.size() > 2 && line[2] != ' ') verbs.push_back(line.substr(2, line.find(' ', 2) - 2));
  return verbs;
}

TEST_F(Usage, EveryVerbHasHelpWithAnExample) {
  const Result program = run("--help");
  EXPECT_EQ(program.status, 0);
  const auto verbs = verbs_of(program.out);
  EXPECT_GE(verbs.size(), 24U) << program.out;
  for (const std::string& verb : verbs) {
    const Result help = run(verb + " --help");
    EXPECT_EQ(help.status, 0) << verb;
    EXPECT_THAT(help.out, HasSubstr("Example:\n  jounce " + verb)) << verb;
  }
}

TEST_F(Usage, AWrongWordIsStatus2WithTheNearestOne) {
  EXPECT_EQ(run("").status, 2);
  const Result verb = run("chek x");
  EXPECT_EQ(verb.status, 2);
  EXPECT_EQ(verb.err, "jounce: `chek` is not a verb: did you mean check? (see jounce --help)\n");
  const Result option = run("check --limt x");
  EXPECT_EQ(option.status, 2);
  EXPECT_EQ(option.err,
            "jounce: `--limt` is not an option of check: did you mean --limit? (see jounce check "
            "--help)\n");
  EXPECT_THAT(run("convert a.csv b.csv --format csv").err, HasSubstr("did you mean --to?"));
  EXPECT_THAT(run("check a.toml --force").err, HasSubstr("not an option of check, but of new"));
  EXPECT_THAT(run("order x move --speed 3").err, Not(HasSubstr("--seed"))) << "a hidden option";
  for (const char* flag : {"new cam --force=3", "check a.toml --strict=no", "--json=3"}) {
    const Result valued = run(flag);
    EXPECT_EQ(valued.status, 2) << flag;
    EXPECT_THAT(valued.err, HasSubstr("takes no value: write it alone, or leave it out")) << flag;
  }
  EXPECT_EQ(run("check nothing.toml").status, 2);
}

TEST_F(Usage, AWrongValueIsReportedWithItsRule) {
  const auto told = [&](const std::string& words) {
    const Result result = run(words);
    EXPECT_EQ(result.status, 2) << words;
    return result.err;
  };
  EXPECT_EQ(told("check " + cam + " --continuity 4"),
            "jounce: --continuity = 4: must be a whole number from 0 to 3\n");
  EXPECT_EQ(told("convert " + cam + " x.csv --most -3"),
            "jounce: --most = -3: must be a whole number from 1 to 10000000\n");
  EXPECT_EQ(told("optimize " + cam + " --seconds soon"),
            "jounce: --seconds = soon: must be a number\n");
  EXPECT_EQ(told("plot " + cam + " --over tiem"),
            "jounce: --over = tiem: must be one of master, time: did you mean time?\n");
  EXPECT_EQ(told("stop a --patience nan"),
            "jounce: --patience = nan: must be a number of seconds from 0.001 to 1e12\n");
  EXPECT_EQ(told("-x"), "jounce: `-x` is not an option of jounce (see jounce --help)\n");
  EXPECT_EQ(told("design " + cam + " -o"),
            "jounce: --output has no value after it (see jounce design --help)\n");
}

// The parser would take the next word for the value, and the spec would be lost to the log.
TEST_F(Usage, AMissingValueIsNotTheNextWord) {
  EXPECT_EQ(run("new axis -o a.toml").status, 0);
  EXPECT_EQ(run("run --log= a.toml a.toml --url memq:// --seconds 0.1").err,
            "jounce: --log: has no value after =\n");
  EXPECT_THAT(run("run a.toml --log a.toml --url memq:// --seconds 0.1").err,
              HasSubstr("--log = a.toml: is also the input"));
  EXPECT_THAT(slurp(folder / "a.toml"), HasSubstr("kind = \"axis\""));
}

TEST_F(Usage, NumbersAreDecimal) {
  EXPECT_EQ(run("check " + cam + " --continuity 02").status,
            run("check " + cam + " --continuity 2").status);
  EXPECT_THAT(run("check " + cam + " --continuity 010").err, HasSubstr("0 to 3"));
  EXPECT_THAT(run("order feeder jog -.5mm/s --url memq://").err, Not(HasSubstr("not expected")));
}

TEST_F(Usage, HelpShowsValuesDefaultsAndRequiredOptions) {
  const std::string help = run("stream --help").out;
  EXPECT_THAT(help, HasSubstr("  --to ...                        Required. Name of the axis or "
                              "group, or of several axes (x,y,z): each\n"));
  EXPECT_THAT(help, HasSubstr("  --loops [1]  "));
  EXPECT_THAT(help, HasSubstr("  --json                          Outcome"));
  EXPECT_THAT(help, Not(HasSubstr("\n\n\n")));
  std::istringstream lines(run("convert --help").out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 104U) << line;
}

TEST_F(Usage, AnEmptyValueIsReportedAsEmpty) {
  const Result result = run("convert " + cam + " out.csv --tolerance \"\"");
  EXPECT_EQ(result.status, 2);
  EXPECT_EQ(result.err, "jounce: --tolerance: is empty: write a value\n");
  EXPECT_TRUE(files().empty());
}

TEST_F(Usage, AFileOfAnotherVerbNamesThatVerb) {
  write("a.toml", "jounce = 1\nkind = \"machine\"\n");
  EXPECT_THAT(
      run("plot a.toml -o a.svg").err,
      HasSubstr(
          "a.toml:2:8: kind = \"machine\": is a machine, which has no motion of its own: use it "
          "with `jounce check` and `jounce run`"));
  write("a.toml", "jounce = 1\nkind = \"sweep\"\n");
  EXPECT_THAT(run("plot a.toml -o a.svg").err,
              HasSubstr("a.toml:2:8: kind = \"sweep\": is a sweep: start it with `jounce sweep`"));
}

TEST_F(Usage, AnOptionWithoutEffectIsRejected) {
  ASSERT_EQ(run("new move -o move.toml").status, 0);
  ASSERT_EQ(run("new drive -o drive.toml").status, 0);
  EXPECT_THAT(run("plot move.toml --over master -o x.svg").err,
              HasSubstr("is over time, without a master: leave out --over"));
  EXPECT_THAT(run("convert " + cam + " y.scl --rule linear").err,
              HasSubstr("--rule = linear: applies to csv, json, lcm-log and mcap only"));
  EXPECT_THAT(run("check drive.toml --limit foo=3").err,
              HasSubstr("--limit = foo=3: applies to a motion, but this file has none"));
  EXPECT_THAT(run("events " + cam).err, HasSubstr("switch: is missing: add [[switch]]"));
  EXPECT_THAT(run("events move.toml").err, HasSubstr("compare: is missing: add [compare]"));
  EXPECT_THAT(run("check " + cam + " --limit geo_acceleration=-1").err,
              HasSubstr("--limit geo_acceleration = -1"));
  EXPECT_THAT(run("design " + cam + " -o a.csv -o b.csv").err,
              HasSubstr("--output is given twice"));
}

}  // namespace
}  // namespace jounce::usage_of_verbs_test
