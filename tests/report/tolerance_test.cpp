// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"
#include "jounce/report/comparison.hpp"

namespace jounce::tolerance_test {
namespace {

const Labels labels{{"deg", "mm"}, true, {}};

std::string rule_of(const std::string& text) {
  try {
    static_cast<void>(tolerance_of({text}, labels));
  } catch (const InputError& error) {
    EXPECT_EQ(error.key(), "tolerance");
    EXPECT_EQ(error.value(), text);
    return error.rule();
  }
  return "";
}

TEST(Tolerance, IsAShareOrANumberOfAQuantity) {
  const Tolerance tolerance = tolerance_of({"1e-6", "position=10 um", "geo_velocity=0.5"}, labels);
  EXPECT_EQ(tolerance.share, 1e-6);
  EXPECT_DOUBLE_EQ(tolerance.of[0].value(), 0.01) << "mm";
  EXPECT_EQ(tolerance.of[1], 0.5);
  EXPECT_FALSE(tolerance.of[2]);
}

TEST(Tolerance, RejectsAnythingElse) {
  EXPECT_NE(rule_of("wide"), "");
  EXPECT_NE(rule_of("velocity=1"), "") << "of a motion over time";
  EXPECT_NE(rule_of("position=1 s"), "");
  EXPECT_NE(rule_of("position=-1"), "");
  EXPECT_EQ(rule_of("2"), "is a share of the range, so it must be at most 1");
  EXPECT_EQ(rule_of("1"), "");
}

TEST(Tolerance, FitsTheMotionsThatHaveItsQuantityAndUnit) {
  const Labels axis{{"s", "deg"}, false, {}};
  const Labels plain{{"", ""}, true, {}};
  EXPECT_TRUE(tolerance_fits("position=1 um", labels));
  EXPECT_FALSE(tolerance_fits("position=1 um", axis)) << "it is in deg";
  EXPECT_FALSE(tolerance_fits("position=1 um", plain)) << "it has no unit";
  EXPECT_TRUE(tolerance_fits("position=1", axis));
  EXPECT_TRUE(tolerance_fits("1e-6", axis));
  EXPECT_FALSE(tolerance_fits("velocity=1", labels)) << "of a motion over time";
  EXPECT_FALSE(tolerance_fits("geo_jerk=1", axis));
  EXPECT_TRUE(tolerance_fits("speed=1", axis)) << "tolerance_of() reports the error";
  EXPECT_TRUE(tolerance_fits("position=1 parsec", axis));
}

}  // namespace
}  // namespace jounce::tolerance_test
