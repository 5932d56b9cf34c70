// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/detail/six_digits.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

namespace jounce::six_digits_test {
namespace {

TEST(SixDigits, RoundsForAMessage) {
  EXPECT_EQ(six_digits(26.17993877991494), "26.1799");
  EXPECT_EQ(six_digits(0.5000000000000001), "0.5");
  EXPECT_EQ(six_digits(90000), "90000");
  EXPECT_EQ(six_digits(-123456789), "-123456789");
  EXPECT_EQ(six_digits(1.23456789e-5), "1.23457e-5");
  EXPECT_EQ(six_digits(2e297), "2e297");
  EXPECT_EQ(six_digits(0), "0");
}

// A bound that is typed in as shown keeps the rule.
TEST(SixDigits, RoundsABoundToItsSafeSide) {
  EXPECT_EQ(six_digits_up(1113.8542746), "1113.86");
  EXPECT_EQ(six_digits_down(940.71622696), "940.716");
  EXPECT_EQ(six_digits_up(-1.0000009), "-1");
  EXPECT_EQ(six_digits_down(-1.0000009), "-1.00001");
  EXPECT_EQ(six_digits_up(0.30000000000000004), "0.3");
  EXPECT_EQ(six_digits_down(0), "0");
  EXPECT_EQ(six_digits_up(std::numeric_limits<double>::infinity()), "inf");
}

TEST(SixDigits, AnErrorShowsItsValueWithoutRoundingNoise) {
  EXPECT_STREQ(InputError("move.to", 120.00000000000001, "must be lower").what(),
               "move.to = 120: must be lower");
  EXPECT_STREQ(InputError("move.to", 360.000000000001, "must be lower").what(),
               "move.to = 360.000000000001: must be lower");
}

}  // namespace
}  // namespace jounce::six_digits_test
