// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace jounce::events_verb_test {
namespace {

using cli_test::cam;
using cli_test::examples;
using cli_test::Result;
using cli_test::slurp;
using nlohmann::json;
using ::testing::HasSubstr;
using ::testing::StartsWith;

using EventsVerb = cli_test::Program;

TEST_F(EventsVerb, ListsWhenOutputsSwitch) {
  const std::string scan = examples + "position-compare/scan.toml";
  const Result events = run("events " + scan);
  EXPECT_EQ(events.status, 0) << events.err;
  EXPECT_THAT(events.out, ::testing::StartsWith("time [s],output,on,position [mm]\n"));
  EXPECT_EQ(std::count(events.out.begin(), events.out.end(), '\n'), 23);  // 11 pulses, both edges
  EXPECT_THAT(run("events " + scan + " --json").out, HasSubstr("\"output\": \"compare\""));
  EXPECT_EQ(run("events " + scan + " -o e.csv --json").err,
            "jounce: --json: cannot be combined with .csv: end the output in .json\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "e.csv"));
  EXPECT_EQ(run("events " + scan + " -o e.json").status, 0);
  EXPECT_THAT(slurp(folder / "e.json"), StartsWith("{"));
  for (const char* both : {"laws --markdown --json", "laws quintic -o q.svg --json"})
    EXPECT_EQ(run(both).status, 2) << both;
  EXPECT_EQ(run("check " + scan).status, 0);
  EXPECT_THAT(run("events " + examples + "spring-coiler/cam.toml").err,
              HasSubstr("switch: is missing"));
}

TEST_F(EventsVerb, ReportsPointsThatDoNotFire) {
  std::string scan = slurp(examples + "position-compare/scan.toml");
  const std::string_view count = "count = ";
  const std::size_t at = scan.find(count);
  ASSERT_NE(at, std::string::npos);
  scan.replace(at, scan.find('\n', at) - at, "count = 100000");
  std::ofstream(folder / "scan.toml") << scan;
  const Result events = run("events scan.toml");
  EXPECT_EQ(events.status, 1);
  EXPECT_THAT(events.err, HasSubstr("compare/missed: "));
  EXPECT_THAT(events.err, HasSubstr(" of 100000 points fire"));
}

TEST_F(EventsVerb, FindsPositionsOfTheSlaveForAnyLaw) {
  ASSERT_EQ(run("new cam -o cam.toml").status,
            0);  // modified sine behind a master that accelerates
  std::ofstream(folder / "cam.toml", std::ios::app)
      << "[switches]\nof = \"position\"\n"
         "[[switch]]\ntrack = 1\nfirst_on_position = 25\nlast_on_position = 40\n";
  const Result events = run("events cam.toml --json");
  ASSERT_EQ(events.status, 0) << events.err;
  const json all = json::parse(events.out)["events"];
  ASSERT_EQ(all.size(), 12U);  // on and off, up and down, in three turns
  // The rise passes its middle, 25 mm, at 60 deg, when the master, which reaches 180 deg/s at 22.5 deg
  // after 0.25 s, has run on for (60 - 22.5)/180 s.
  EXPECT_NEAR(all[0]["time"].get<double>(), 0.25 + 37.5 / 180, 1e-12);
  EXPECT_NEAR(all[0]["position"].get<double>(), 25, 1e-10);
}

TEST_F(EventsVerb, ListsTheSwitchesOfACam) {
  const std::string switched = slurp(cam) +
                               "\n[[switch]]\ntrack = 2\nfirst_on_position = 90\n"
                               "last_on_position = 180\n";
  std::ofstream(folder / "cam.toml") << switched;
  const Result events = run("events cam.toml");
  EXPECT_EQ(events.status, 0) << events.err;
  EXPECT_THAT(events.out, HasSubstr(",track 2,1,"));
  EXPECT_EQ(std::count(events.out.begin(), events.out.end(), '\n'), 7);  // three periods
}

}  // namespace
}  // namespace jounce::events_verb_test
