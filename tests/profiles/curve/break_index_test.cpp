// SPDX-License-Identifier: Apache-2.0
#include "jounce/profiles/curve/break_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "support/random.hpp"

namespace jounce::break_index_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The oracle: one break after another.
std::size_t counted(const std::vector<double>& breaks, double x, Side side) {
  std::size_t i = 0;
  while (i + 2 < breaks.size() && (side == Side::right ? x >= breaks[i + 1] : x > breaks[i + 1]))
    ++i;
  return i;
}

void expect_as_counted(const std::vector<double>& breaks, const BreakIndex& index, double x) {
  for (const Side side : {Side::right, Side::left})
    ASSERT_EQ(index.find(breaks, x, side), counted(breaks, x, side))
        << "x = " << x << (side == Side::right ? " right" : " left") << ", " << breaks.size()
        << " breaks from " << breaks.front() << " to " << breaks.back();
}

/// At every break, its neighbours on either side, half-way to the next, and far outside.
void expect_as_counted(const std::vector<double>& breaks) {
  const BreakIndex index(breaks);
  for (std::size_t i = 0; i < breaks.size(); ++i) {
    expect_as_counted(breaks, index, breaks[i]);
    expect_as_counted(breaks, index, std::nextafter(breaks[i], -infinity));
    expect_as_counted(breaks, index, std::nextafter(breaks[i], infinity));
    if (i > 0) expect_as_counted(breaks, index, std::midpoint(breaks[i - 1], breaks[i]));
  }
  for (const double x : {-infinity, -1e300, 0.0, 1e300, infinity})
    expect_as_counted(breaks, index, x);
}

std::vector<double> evenly(double start, double step, int n) {
  std::vector<double> breaks;
  for (int i = 0; i <= n; ++i) breaks.push_back(start + i * step);
  return breaks;
}

TEST(BreakIndex, CountsTheBreaksOfAnEvenGrid) {
  for (const int n : {1, 2, 3, 4, 5, 6, 7, 12, 100, 360})
    for (const double step : {1.0, 0.1, 1.0 / 3, 1e-300, 1e300})
      for (const double start : {0.0, -7.3, 1e6}) expect_as_counted(evenly(start * step, step, n));
}

TEST(BreakIndex, CountsClustersThatShareACell) {
  std::vector<double> breaks{0};
  for (int cluster = 1; cluster <= 5; ++cluster)
    for (int i = 0; i < 40; ++i) breaks.push_back(cluster + 1e-12 * i);
  breaks.push_back(1e6);
  expect_as_counted(breaks);
}

TEST(BreakIndex, CountsLengthsOverTwelveDecadesBothWays) {
  std::vector<double> breaks{0};
  for (int i = 0; i < 240; ++i) breaks.push_back(std::pow(10.0, -6 + i / 20.0));
  expect_as_counted(breaks);
  std::vector<double> mirrored;
  for (auto it = breaks.rbegin(); it != breaks.rend(); ++it) mirrored.push_back(-*it);
  expect_as_counted(mirrored);
}

TEST(BreakIndex, CountsBreaksThatRoundingHasMadeEqual) {
  expect_as_counted({0, 1, 1, 1, 1, 2, 2, 3});
  expect_as_counted(evenly(1e15, 0.01, 500));  // a double resolves 0.125 there
  expect_as_counted(evenly(-1e15, 0.01, 500));
}

TEST(BreakIndex, CountsWhereTheCellsOverOrUnderflow) {
  constexpr double most = std::numeric_limits<double>::max();
  constexpr double least = std::numeric_limits<double>::denorm_min();
  expect_as_counted({-most, -1, 0, 1, 2, 3, most});
  expect_as_counted({-most, -most / 2, 0, 1, 2, most / 4, most / 2, most});
  expect_as_counted({0, least, 2 * least, 3 * least, 4 * least, 5 * least, 6 * least, 9 * least});
}

TEST(BreakIndex, CountsRandomBreaksAtRandomPositions) {
  test::Random random(20);
  for (int round = 0; round < 200; ++round) {
    std::vector<double> breaks{random.uniform(-1, 1) * random.log_uniform(1e-9, 1e9)};
    const int n = 1 + random.below(60);
    const double spread = random.log_uniform(1, 1e9);
    for (int i = 0; i < n; ++i) breaks.push_back(breaks.back() + random.log_uniform(1 / spread, 1));
    expect_as_counted(breaks);
    const BreakIndex index(breaks);
    for (int i = 0; i < 100; ++i)
      expect_as_counted(breaks, index, random.uniform(breaks.front(), breaks.back()));
  }
}

TEST(BreakIndex, NamesNoIntervalTooLateBeforehand) {
  test::Random random(21);
  std::vector<double> breaks{-5};
  for (int i = 0; i < 1000; ++i) breaks.push_back(breaks.back() + random.log_uniform(0.01, 10));
  const BreakIndex index(breaks);
  for (int i = 0; i < 10000; ++i) {
    const double x = random.uniform(breaks.front(), breaks.back());
    const std::size_t found = index.find(breaks, x, Side::right);
    ASSERT_LE(index.near(x), found) << x;
    // At most as far off as breaks fit into one cell, half a mean interval.
    const double cell = (breaks.back() - breaks.front()) / 2000;
    ASSERT_LE(breaks[found] - breaks[index.near(x)], cell + 10) << x;
  }
  EXPECT_EQ(BreakIndex(std::vector<double>{0, 1}).near(0.5), 0U);
}

TEST(BreakIndex, AnswersAnIntervalForWhatIsNoNumber) {
  const auto breaks = evenly(0, 1, 20);
  const BreakIndex index(breaks);
  EXPECT_LT(index.find(breaks, std::nan(""), Side::right), 20U);
  EXPECT_LT(index.find(breaks, std::nan(""), Side::left), 20U);
}

}  // namespace
}  // namespace jounce::break_index_test
