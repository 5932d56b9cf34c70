// SPDX-License-Identifier: Apache-2.0
#include <string>

#include <gmock/gmock.h>

#include "program.hpp"

namespace jounce::map_verb_test {
namespace {

using cli_test::examples;
using cli_test::Result;
using cli_test::slurp;
using ::testing::HasSubstr;

using MapVerb = cli_test::Program;

TEST_F(MapVerb, ListsTheFastestLineForEachCut) {
  const std::string knife = examples + "rotary-knife/knife.toml";
  const Result map = run("map " + knife + " --from 2 --to 10 --steps 9 --line-speed 60");
  EXPECT_EQ(map.status, 0) << map.err;
  EXPECT_THAT(map.out, HasSubstr("\ncut_length [in],line_speed [in/s],cuts [1/min],limit\n2,"));
  EXPECT_THAT(map.out, HasSubstr("# longest without a stop: 19.8967534727353"));
  EXPECT_THAT(map.out, HasSubstr("# shortest at 20 in/s: 4.5800"));
  EXPECT_EQ(run("map " + knife + " -o map.svg").status, 0);
  EXPECT_THAT(slurp(folder / "map.svg"), HasSubstr("longest without a stop 19.8968"));
  EXPECT_THAT(run("map " + knife + " --from 5 --to 4").err,
              HasSubstr("greater than --from = 5 in"));
  EXPECT_EQ(run("map " + examples + "pmc600-cam/cam.toml").status, 2);
}

TEST_F(MapVerb, ShowsWhereAKnifeWithoutADwellReverses) {
  std::string knife = slurp(examples + "rotary-knife/knife.toml");
  knife.erase(knife.find("dwell = true"), 12);
  write("knife.toml", knife);
  const Result map = run("map knife.toml --from 5 --to 25 --steps 3");
  EXPECT_EQ(map.status, 0) << map.err;
  EXPECT_THAT(map.out,
              HasSubstr("the knife would reverse between two cuts: add dwell = true to [knife]\n"));
  EXPECT_THAT(map.out, HasSubstr("# from 19.8967534727"));
  EXPECT_THAT(map.out, HasSubstr("\n25,,,reversal\n"));
  EXPECT_EQ(run("map knife.toml -o map.svg").status, 0);
  EXPECT_THAT(slurp(folder / "map.svg"), HasSubstr("reverses: needs dwell"));
}

TEST_F(MapVerb, AgreesWithCheckForAShear) {
  const std::string shear = examples + "flying-shear/shear.toml";
  const Result map = run("map " + shear + " --line-speed 3000 --from 500 --to 9000 --steps 3");
  EXPECT_EQ(map.status, 0) << map.err;
  EXPECT_THAT(map.out, HasSubstr("# shortest at 1000 mm/s: 966.4246"));
  EXPECT_THAT(map.out, HasSubstr("\n9000,1114.37"));  // beyond the spec's line
  EXPECT_THAT(map.out, HasSubstr(",stroke\n"));
  const Result check = run("check " + shear);
  EXPECT_THAT(check.out, HasSubstr("  shortest cut         966.425 mm: at 1000 mm/s, limited by "));
  EXPECT_THAT(check.out, HasSubstr("  fastest line         1019.76 mm/s"));
  EXPECT_THAT(check.out, HasSubstr("  fastest master 1000 mm/s for this table, limited by "));
}

}  // namespace
}  // namespace jounce::map_verb_test
