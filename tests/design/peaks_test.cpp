// SPDX-License-Identifier: Apache-2.0
#include "jounce/design/peaks.hpp"

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

}  // namespace
}  // namespace jounce::peaks_test
