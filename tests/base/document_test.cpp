// SPDX-License-Identifier: Apache-2.0
// An error of a generator gets the place of its key, and the units of the text.
#include "jounce/base/document.hpp"

#include <string>

#include <gtest/gtest.h>

namespace jounce::document_test {
namespace {

Document shear() {
  Document document{.name = "s.toml", .text = "", .places = {{"shear.stroke", {4, 10}}}};
  document.units = {{"shear.stroke", "mm"},
                    {"shear.line_speed", "mm/s"},
                    {"shear.sync_time", "s"},
                    {"shear.count", "1"},
                    {"limits.slave.velocity", "mm/s"}};
  document.given = {{"shear.line_speed", "m/min"}};
  return document;
}

std::string located(const char* key, double value, const std::string& rule) {
  return shear().located(InputError(std::string("shear.") + key, value, rule)).what();
}

TEST(Document, NumbersOfARuleHaveTheUnitsOfTheirKeys) {
  EXPECT_EQ(
      located("stroke", 120,
              "must be at least 337.5, of which run-up and braking take 187.5, at line_speed = "
              "1000, or line_speed at most 300 with this stroke, or sync_time at most 0.2"),
      "s.toml:4:10: shear.stroke = 120 mm: must be at least 337.5 mm, of which run-up and "
      "braking take 187.5 mm, at line_speed = 60 m/min, or line_speed at most 18 m/min with this "
      "stroke, or sync_time at most 0.2 s");
  EXPECT_EQ(located("line_speed", 3000, "must be at most 2000: above limits.slave.velocity = 2000"),
            "s.toml: shear.line_speed = 180 m/min: must be at most 120 m/min: above "
            "limits.slave.velocity = 2000 mm/s");
  EXPECT_EQ(located("stroke", 5, "must be at most position_max, 3"),
            "s.toml:4:10: shear.stroke = 5 mm: must be at most position_max, 3 mm");
}

TEST(Document, RangesListsAndNamedQuantitiesHaveUnits) {
  EXPECT_EQ(
      located("stroke", 5, "must ascend inside the segment, from 140 to 260"),
      "s.toml:4:10: shear.stroke = 5 mm: must ascend inside the segment, from 140 mm to 260 mm");
  EXPECT_EQ(
      located("stroke", 5, "must lie in a rise or fall of the slave, 0 to 120, 180 to 300"),
      "s.toml:4:10: shear.stroke = 5 mm: must lie in a rise or fall of the slave, 0 to 120 mm, "
      "180 mm to 300 mm");
  EXPECT_EQ(
      located("stroke", 5, "is 20 from the start and 40 from the end; may differ by at most 2"),
      "s.toml:4:10: shear.stroke = 5 mm: is 20 mm from the start and 40 mm from the end; may "
      "differ by at most 2");
  Document document = shear();
  document.nouns = {{"master", "deg"}, {"slope", "mm/deg"}};
  EXPECT_EQ(
      std::string(document
                      .located(InputError("shear.stroke", "1, 2",
                                          "ends at master 100 with the slope 0.25, but the "
                                          "adjacent segment 3 (line) has the slope 1 there"))
                      .what()),
      "s.toml:4:10: shear.stroke = 1, 2 mm: ends at master 100 deg with the slope 0.25 mm/deg, "
      "but the adjacent segment 3 (line) has the slope 1 mm/deg there");
}

TEST(Document, OtherNumbersOfARuleStayAsTheyAre) {
  for (const char* rule :
       {"must be greater than 0", "must be at least 5 mm", "must be a list of 3 numbers",
        "lies between two blades: at most 7", "must be at least twice 4"})
    EXPECT_EQ(located("stroke", 1, rule), std::string("s.toml:4:10: shear.stroke = 1 mm: ") + rule);
  EXPECT_EQ(located("count", 1, "must be at least 2"),
            "s.toml: shear.count = 1: must be at least 2");
}

TEST(Document, ANumberUnderAnotherKeyIsConvertedWithItsRule) {
  Document document = shear();
  document.converted["knot.geo_velocity"] = {"shear.stroke", 10};
  EXPECT_EQ(std::string(document.located(InputError("knot.geo_velocity", 2, "must be 3")).what()),
            "s.toml:4:10: shear.stroke = 20 mm: must be 30 mm");
}

}  // namespace
}  // namespace jounce::document_test
