// SPDX-License-Identifier: Apache-2.0
#include "jounce/executor/histogram.hpp"

#include <limits>
#include <numeric>

#include <gtest/gtest.h>

namespace jounce::histogram_test {
namespace {

TEST(Histogram, CountsInPowersOfTwoOfAMicrosecond) {
  Histogram h;
  for (const std::int64_t ns : {-5, 0, 999}) h.add(ns);
  for (const std::int64_t ns : {1000, 1999}) h.add(ns);
  h.add(2000);
  h.add(16'383'999);
  h.add(16'384'000);
  h.add(std::numeric_limits<std::int64_t>::max());
  const Histogram::Counts counts = h.counts();
  EXPECT_EQ(counts[0], 3);
  EXPECT_EQ(counts[1], 2);
  EXPECT_EQ(counts[2], 1);
  EXPECT_EQ(counts[14], 1);
  EXPECT_EQ(counts[15], 2);
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0), 9);
}

TEST(Histogram, BoundsAShareFromAbove) {
  Histogram h;
  EXPECT_EQ(upper_bound(h.counts(), 0.999), 0);
  for (int i = 0; i < 999; ++i) h.add(3'000);  // [2, 4) us
  h.add(100'000);                              // [64, 128) us
  EXPECT_EQ(upper_bound(h.counts(), 0.5), 4);
  EXPECT_EQ(upper_bound(h.counts(), 0.999), 4);
  EXPECT_EQ(upper_bound(h.counts(), 1), 128);
  h.add(1'000'000'000);
  EXPECT_EQ(upper_bound(h.counts(), 1), std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace jounce::histogram_test
