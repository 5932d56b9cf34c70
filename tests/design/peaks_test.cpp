// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/detail/peaks.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace jounce::peaks_test {
namespace {

/// A rise of 10 mm in 180 deg, back in the rest of the turn. The peak of |y'| of the 3-4-5 polynomial is 15/8 h/b.
Spec cam(double rise_end) {
  return parse_spec(
      "jounce = 1\nkind = \"cam\"\nunits = { master = \"deg\", position = \"mm\" }\n"
      "start = { master = 0, slave = 0 }\n[limits]\ngeo_velocity = 0.2\n"
      "[[segment]]\nlaw = \"quintic\"\nend = { master = " +
          std::to_string(rise_end) + ", slave = 10 }\n",
      "cam.toml");
}

TEST(Peaks, AreThoseOfBothVersionsWithTheLimit) {
  const auto peaks = peak_changes(cam(90), cam(180));
  ASSERT_EQ(peaks.size(), 3U);
  EXPECT_EQ(peaks[0].name, "geo_velocity");
  EXPECT_EQ(peaks[0].unit, "mm/deg");
  EXPECT_NEAR(peaks[0].given.value(), 15.0 / 8 * 10 / 90, 1e-12);
  EXPECT_NEAR(peaks[0].optimized, 15.0 / 8 * 10 / 180, 1e-12);
  EXPECT_EQ(peaks[0].limit, 0.2);
  EXPECT_FALSE(peaks[1].limit);
  const std::string text = peaks_text(peaks);
  EXPECT_THAT(text, testing::HasSubstr("-50.0 %"));
  EXPECT_THAT(text, testing::HasSubstr("not limited"));
  EXPECT_THAT(peaks_json(peaks), testing::HasSubstr("\"limit\":null"));
}

/// A rise of 40 mm, over 360 deg at 120 cycles a minute: 0.5 s.
Spec timed(const std::string& law) {
  return parse_spec(
      "jounce = 1\nkind = \"cam\"\nunits = { master = \"deg\", position = \"mm\" }\n"
      "periodic = true\nstart = { master = 0, slave = 0 }\n"
      "[[segment]]\nlaw = \"" +
          law +
          "\"\nend = { master = 180, slave = 40 }\n"
          "[[segment]]\nlaw = \"345\"\nend = { master = 360, slave = 0 }\n"
          "[master]\nvelocity = \"120 cpm\"\n"
          "[limits.slave]\nvelocity = \"1 m/s\"\nacceleration = \"15 m/s^2\"\n",
      "cam.toml");
}

TEST(OtherChanges, AreInTheUnitsOfTheSpec) {
  // The peaks of the 3-4-5 polynomial of the return remain: only the rise with 4567 has a higher peak.
  const auto others = other_changes(timed("345"), timed("4567"));
  const auto named = [&](const std::string& name) {
    for (const PeakChange& other : others)
      if (other.name == name) return other;
    ADD_FAILURE() << name;
    return PeakChange{};
  };
  const PeakChange acceleration = named("peak acceleration");
  EXPECT_EQ(acceleration.unit, "m/s^2");
  EXPECT_NEAR(acceleration.given.value(), 10 / std::sqrt(3) * 0.04 / 0.0625, 1e-6);
  EXPECT_NEAR(acceleration.optimized, 84 * std::sqrt(5) / 25 * 0.04 / 0.0625, 1e-6);
  EXPECT_NEAR(acceleration.limit.value(), 15, 1e-12);
  const PeakChange fastest = named("fastest master");
  EXPECT_EQ(fastest.unit, "cpm");
  EXPECT_NEAR(fastest.given.value(), 120 * std::sqrt(15 / acceleration.given.value()), 1e-6);
  EXPECT_THAT(others_text(others), testing::HasSubstr("other figures"));
  for (const PeakChange& other : others)
    EXPECT_NE(other.name, "cycle time") << "it does not change";
}

TEST(OtherChanges, AreEmptyForTheSameSpec) {
  EXPECT_TRUE(other_changes(timed("345"), timed("345")).empty());
  EXPECT_EQ(others_text({}), "");
}

}  // namespace
}  // namespace jounce::peaks_test
