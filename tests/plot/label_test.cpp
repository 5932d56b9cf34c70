// SPDX-License-Identifier: Apache-2.0
#include "jounce/plot/label.hpp"

#include <limits>

#include <gtest/gtest.h>

namespace jounce::label_test {
namespace {

TEST(Superscripts, RaisePowersOfUnits) {
  EXPECT_EQ(superscripts("mm/deg^2"), "mm/deg²");
  EXPECT_EQ(superscripts("s^-1 and (m/s)^13"), "s⁻¹ and (m/s)¹³");
  EXPECT_EQ(superscripts("°^3"), "°³");
}

TEST(Superscripts, LeaveEverythingElse) {
  for (const char* text : {"", "^", "^2", "a^", "a^b", "a^-", "a ^2", "mm"})
    EXPECT_EQ(superscripts(text), text);
}

TEST(ShortNumber, IsShort) {
  EXPECT_EQ(short_number(0), "0");
  EXPECT_EQ(short_number(-0.0), "0");
  EXPECT_EQ(short_number(232.361666), "232.362");
  EXPECT_EQ(short_number(-3.392270802), "−3.39227");
  EXPECT_EQ(short_number(7.95, 2), "8");
  EXPECT_EQ(short_number(1.5e12), "1.5×10¹²");
  EXPECT_EQ(short_number(-1e-9), "−10⁻⁹");
}

TEST(ShortNumber, WritesNanAndInfinity) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(short_number(infinity), "∞");
  EXPECT_EQ(short_number(-infinity), "−∞");
  EXPECT_EQ(short_number(std::numeric_limits<double>::quiet_NaN()), "not a number");
}

}  // namespace
}  // namespace jounce::label_test
