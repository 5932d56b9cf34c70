// SPDX-License-Identifier: Apache-2.0
#include "jounce/spec/key_changes.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>

namespace jounce::key_changes_test {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::string cam(const std::string& rest, const std::string& units = "mm",
                const std::string& stroke = "50") {
  return "jounce = 1\nkind = \"cam\"\nname = \"jaw\"\nunits = { master = \"deg\", position = \"" +
         units +
         "\" }\nstart = { master = 0, slave = 0 }\n[[segment]]\nlaw = \"345\"\n"
         "end = { master = 60, slave = " +
         stroke + " }\n" + rest;
}

/// "key: before -> after" of each change; a limit begins with "!".
std::vector<std::string> changes(const std::string& before, const std::string& after) {
  std::vector<std::string> all;
  for (const KeyChange& change :
       changed_keys(parse_spec(before, "a.toml"), parse_spec(after, "b.toml")))
    all.push_back((change.limit ? "!" : "") + change.key + ": " + change.before + " -> " +
                  change.after);
  return all;
}

const std::string disc = "[disc]\nbase_radius = 60\nroller_radius = 12\n";

TEST(KeyChanges, FindEachKeyWithItsUnit) {
  EXPECT_THAT(changes(cam(disc), cam("[disc]\nbase_radius = 50\nroller_radius = 12\n")),
              ElementsAre("disc.base_radius: 60 mm -> 50 mm"));
  EXPECT_THAT(changes(cam(""), cam("", "mm", "49")),
              ElementsAre("segment[1].end.slave: 50 mm -> 49 mm"));
  EXPECT_THAT(changes(cam("[master]\nvelocity = 1\ndistance = 60\n"),
                      cam("[master]\nvelocity = \"2 rpm\"\ndistance = 60\n")),
              ElementsAre("master.velocity: 1 deg/s -> 2 rpm"));
}

TEST(KeyChanges, FindAddedAndRemovedKeys) {
  EXPECT_THAT(changes(cam(""), cam(disc)),
              ElementsAre("disc.base_radius:  -> 60 mm", "disc.roller_radius:  -> 12 mm"));
  EXPECT_THAT(changes(cam(disc), cam("")),
              ElementsAre("disc.base_radius: 60 mm -> ", "disc.roller_radius: 12 mm -> "));
}

TEST(KeyChanges, FindLimitsOfEachSection) {
  const std::string limits = disc + "[disc.limits]\npressure_angle = 30\n";
  EXPECT_THAT(changes(cam(limits), cam(disc)),
              ElementsAre("!disc.limits.pressure_angle: 30 deg -> "));
  EXPECT_THAT(changes(cam(disc), cam(limits)),
              ElementsAre("!disc.limits.pressure_angle:  -> 30 deg"));
  EXPECT_THAT(changes(cam("[limits]\ngeo_velocity = 2\n"), cam("[limits]\ngeo_velocity = 3\n")),
              ElementsAre("!limits.geo_velocity: 2 mm/deg -> 3 mm/deg"));
}

TEST(KeyChanges, LeaveOutCommentsOrderAndUnits) {
  EXPECT_THAT(changes(cam(disc), cam("# smaller?\n[disc]\nroller_radius = \"1.2 cm\"  # a comment\n"
                                     "base_radius = 60.0\n")),
              IsEmpty());
  EXPECT_THAT(changes(cam("", "mm", "50"), cam("", "cm", "5")),
              ElementsAre("units.position: mm -> cm"));
}

TEST(KeyChanges, HaveThePlaceInTheLaterSpec) {
  const auto all =
      changed_keys(parse_spec(cam(disc), "a.toml"), parse_spec(cam("[disc]\nbase_radius = 50\n"
                                                                   "roller_radius = 12\n"),
                                                               "b.toml"));
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].place.line, 10);
  EXPECT_EQ(all[0].place.column, 15);
}

}  // namespace
}  // namespace jounce::key_changes_test
