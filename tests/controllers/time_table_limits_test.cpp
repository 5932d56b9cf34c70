// SPDX-License-Identifier: Apache-2.0
#include "jounce/controllers/detail/time_table_limits.hpp"

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "jounce/profiles/error.hpp"

#include "support/errors.hpp"

namespace jounce::time_table_limits_test {
namespace {

template <class Call>
std::string message(const Call& call) {
  return test::error_of([&] { call(); });
}

std::vector<double> times(std::size_t n) {
  std::vector<double> all;
  for (std::size_t i = 0; i < n; ++i) all.push_back(static_cast<double>(i));
  return all;
}

TEST(Googol, TimesAreWholeMilliseconds) {
  const std::vector<PtPoint> whole{{16, 1}, {32, 2}};
  EXPECT_EQ(message([&] { googol::require_pt(whole); }), "");
  // The manual's example 7-4 as printed: a long incremented by 0.016.
  const std::vector<PtPoint> printed{{0.016, 40.1447}, {0.032, 160.3}};
  EXPECT_EQ(message([&] { googol::require_pt(printed); }),
            "point[1].time = 0.016: must be a whole number of ms: GT_PtData would take 0 ms, "
            "and the table would never advance");
  const std::vector<PtPoint> half{{1, 1}, {2.5, 2}};
  EXPECT_EQ(message([&] { googol::require_pt(half); }),
            "point[2].time = 2.5: must be a whole number of ms: GT_PtData would take 2 ms");
}

TEST(Googol, OnlyOneFifoCanBeRepeated) {
  std::vector<PtPoint> points;
  for (int i = 1; i <= 1025; ++i) points.push_back({1.0 * i, 0});
  EXPECT_EQ(message([&] { googol::require_pt(points); }), "");
  EXPECT_NE(message([&] { googol::require_pt(points, 0); }), "");
  points.pop_back();
  EXPECT_EQ(message([&] { googol::require_pt(points, 0); }), "");
}

TEST(Himc, TakesFiftyPoints) {
  EXPECT_EQ(message([] { himc::require_pvt(times(50)); }), "");
  EXPECT_EQ(message([] { himc::require_pvt(times(51)); }),
            "knot = 51 knots: must be at most 50, the greatest number for MovePVT of HIMC");
}

TEST(Himc, TimesBeginAtZeroAndAscend) {
  std::vector<double> x = times(5);
  x[3] = 2;
  EXPECT_EQ(
      message([&] { himc::require_pvt(x); }),
      "knot[4].time = 2: must be greater than 2, the previous knot (HIMC error 0x83aa08b6, PVT "
      "time sequence)");
  x[0] = 0.5;
  EXPECT_EQ(message([&] { himc::require_pvt(x); }),
            "knot[1].time = 0.5: must be 0 (HIMC error 0x83aa08b6, PVT time sequence)");
}

TEST(Googol, TimesAreALong) {
  const std::vector<PtPoint> last{{16, 1}, {2147483647, 2}};
  EXPECT_EQ(message([&] { googol::require_pt(last); }), "");
  const std::vector<PtPoint> beyond{{16, 1}, {2147483648, 2}};
  EXPECT_EQ(
      message([&] { googol::require_pt(beyond); }),
      "point[2].time = 2147483648: must be at most 2147483647 ms: GT_PtData takes a long of 32 "
      "bits");
}

}  // namespace
}  // namespace jounce::time_table_limits_test
